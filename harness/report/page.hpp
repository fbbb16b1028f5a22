#pragma once

#include "compare/comparison.hpp"
#include "compare/stored_run.hpp"
#include "report/sample_groups.hpp"

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace reliefbench {

/// A colour of a map that stands for no value, and what for: "missed".
struct LegendColour {
    std::array<std::uint8_t, 3> colour{};
    std::string text;
};

/// What the colours of a map of errors mean: the n colours (RGB) stand for values from `dark` to `light` in equal
/// steps, of the value or of its logarithm.
struct MapLegend {
    std::string title;
    /// Empty for pure numbers.
    std::string unit;
    double dark = 0;
    double light = 1;
    bool logarithmic = false;
    std::vector<std::uint8_t> colours;
    /// Values that are named, from dark to light; none where the map shows no values.
    std::vector<double> marks;
    std::vector<LegendColour> others;
};

/// Which of the page's pictures (page_pictures.hpp) show what of a run's cells.
struct CellPictures {
    /// One position per cell, -1 where it has none.
    std::vector<int> technique, truth;
    /// Error maps and others, by name.
    std::map<std::string, std::vector<int>> maps;
    /// Of those maps whose scale is known.
    std::map<std::string, MapLegend> legends;
    /// Every how many pixels were kept: 1 is all.
    int step = 1;
    /// Cells whose pictures are in the run's folder but did not fit into the page.
    std::size_t left_out = 0;
};

/// What the page shows of one run.
struct PageRun {
    StoredRun stored;
    /// Of a run that ended.
    std::optional<Json> summary;
    RunSamples samples;
    CellPictures pictures;
};

/// The last run against others.
struct PageComparison {
    /// Names of the runs of each side.
    std::vector<std::string> base, changed;
    /// Either the verdicts or why there are none.
    std::optional<Comparison> comparison;
    std::string failure;
};

/// All that the report's page knows: `{"tool_version", "figures", "runs": [{"name", "record", "summary", "cautions",
/// "cells", "samples", "pictures"}, ...], "pictures": [...], "comparison"}`. `figures` is the list of
/// store/figures.hpp, and what later versions declared in the runs, with the tolerances of
/// compare/deciding_figures.hpp; `record` is run.json without its own list; the rest is as page_cells.hpp,
/// page_samples.hpp, page_pictures.hpp and page_comparison.hpp say.
Json page_data(const std::vector<PageRun>& runs, const Json& pictures, const std::optional<PageComparison>& comparison,
               std::string_view tool_version);

/// The page with the data in it. `page` is what report_page/ builds; one without a place for data is an Error. The data
/// cannot end the element that it stands in, whatever its strings say.
std::string fill_page(std::string_view page, const Json& data);

}  // namespace reliefbench
