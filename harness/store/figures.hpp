#pragma once

#include "store/cell_result.hpp"

#include <optional>
#include <span>
#include <string_view>

namespace reliefbench {

/// Which way a figure is better. `neither`: a circumstance (how many pixels were compared), or signed.
enum class Better { lower, higher, neither };

std::string_view to_string(Better better);

/// Whether `value` is better than `other`; false for `neither`.
bool is_better(double value, double other, Better better);

/// A number of a line of cells.jsonl.
struct FigureDeclaration {
    /// Where it stands in the line: "error.uv_texels.p99"; the bounds of an interval are ".low" and ".high".
    std::string_view path;
    /// What it is called before people.
    std::string_view label;
    /// "ms", "texels", "fraction of footprint" ...; empty for pure numbers.
    std::string_view unit;
    Better better = Better::neither;
    /// Empty where the cell has none. Infinite for the PSNR of an image without an error, which is null in the file.
    std::optional<double> (*value)(const CellResult& cell) = nullptr;
};

/// Every number that any cell may have, in the order of the file: the one source of labels, units and directions for
/// verdicts, tables, the report's page and scripts. Left out is what is named by techniques and drivers: the times of
/// preparation passes, `pipeline` and `executable`.
std::span<const FigureDeclaration> figures();

/// Of what a device measures anew each time, unlike the others, which repeat exactly on it: times and what belongs to
/// them.
bool is_time(const FigureDeclaration& figure);

/// Of how far a picture is from the truth, alone or in motion.
bool is_error(const FigureDeclaration& figure);

/// Null where there is none of that path.
const FigureDeclaration* find_figure(std::string_view path);

/// `[{"path", "label", "unit", "better": "lower"|"higher"|"neither"}, ...]`
Json figures_to_json();

}  // namespace reliefbench
