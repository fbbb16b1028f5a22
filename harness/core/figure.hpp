#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace reliefbench {

/// Which way a figure is better. `neither`: a circumstance (how many pixels were compared), or signed.
enum class Better { lower, higher, neither };

std::string_view to_string(Better better);

/// Whether `value` is better than `other`; false for `neither`.
bool is_better(double value, double other, Better better);

/// What a figure is measured of, or depends on: two runs that differ in it have figures that mean different things.
namespace figure_needs {
/// What the device measures anew each time: the others repeat exactly on it.
inline constexpr std::string_view timing = "timing";
/// A ground truth to compare with: the figure is an error, or says how much was compared.
inline constexpr std::string_view truth = "truth";
/// The lights and the materials: the figure is of what is shaded.
inline constexpr std::string_view lighting = "lighting";
inline constexpr std::string_view self_shadow = "self_shadow";
/// An object in the scene.
inline constexpr std::string_view object = "object";
/// A base surface that is not flat.
inline constexpr std::string_view curved_base = "curved_base";
/// A camera that moves.
inline constexpr std::string_view motion = "motion";
/// What is kept of earlier frames while the camera moves.
inline constexpr std::string_view history = "history";
}  // namespace figure_needs

/// A number of a cell, declared where it is computed and nowhere else: files, tables, verdicts and the report's page
/// have it from here.
struct FigureDeclaration {
    /// Where it stands in a line of cells.jsonl: "error.uv_texels.p99"; the bounds of an interval are ".low" and
    /// ".high".
    std::string path;
    /// What it is called before people.
    std::string label;
    /// "ms", "texels", "fraction of footprint" ...; empty for pure numbers.
    std::string unit;
    Better better = Better::neither;
    /// Of figure_needs; those of a later version may have others.
    std::vector<std::string> needs = {};
    /// A whole number of at least 0.
    bool is_count = false;
    /// Path of the figure that says of how much this one is a statistic: with 0 of that it says nothing.
    std::string over = {};
    /// Path of the figure beside which 0 makes this one infinite, which is null in files: the RMSE of a PSNR.
    std::string infinite_at_zero = {};
    /// Path of the figure that decides in its place where a run is too old to have this one.
    std::string stand_in = {};
    /// Per cent of the pixels in which what it is of is at most the figure: 99.9; empty where it is no percentile over
    /// the pixels of one picture.
    std::optional<double> percent_of_pixels = {};
    /// What it is called where there is little room, as the title of a column: "uv p99". Empty where nothing calls it
    /// so.
    std::string short_label = {};
    /// What the first word of `short_label` stands for, in a legend; where it is empty, what the unit says.
    std::string legend = {};

    bool has_need(std::string_view need) const;
};

/// The figure as a percentile over the pixels of a picture.
FigureDeclaration at_percentile(double percent, FigureDeclaration figure);

/// The figure with its name for narrow columns.
FigureDeclaration in_short(FigureDeclaration figure, std::string short_label, std::string legend = {});

/// Of what a family of figures computed, by path. Empty: the result has none, and a group of which all are empty is
/// null as a whole; not finite: undefined, and null by itself.
using FigureValueList = std::vector<std::pair<std::string, std::optional<double>>>;

/// One line of a family's table: a figure and how a result gives it.
template <typename Result>
struct FigureOf {
    FigureDeclaration figure;
    std::optional<double> (*value)(const Result& result) = nullptr;
};

template <typename Result>
std::vector<FigureDeclaration> declarations_in(const std::vector<FigureOf<Result>>& table) {
    std::vector<FigureDeclaration> declarations;
    for (const FigureOf<Result>& each : table)
        declarations.push_back(each.figure);
    return declarations;
}

template <typename Result>
FigureValueList values_in(const std::vector<FigureOf<Result>>& table, const Result& result) {
    FigureValueList values;
    for (const FigureOf<Result>& each : table)
        values.emplace_back(each.figure.path, each.value(result));
    return values;
}

}  // namespace reliefbench
