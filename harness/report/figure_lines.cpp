#include "report/figure_lines.hpp"

#include "core/suggest.hpp"
#include "report/figure_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <optional>
#include <span>

namespace reliefbench {

namespace {

constexpr int caption_digits = 4;

/// "error.uv_texels" of "error.uv_texels.p99".
std::string_view group_path(std::string_view path) {
    return path.substr(0, path.rfind('.'));
}

/// "UV error" and "p99" of "UV error, p99"; a label without a comma is its first part.
struct LabelParts {
    explicit LabelParts(std::string_view label) {
        constexpr std::string_view separator = ", ";
        const std::size_t at = label.find(separator);
        first = label.substr(0, at);
        if (at != std::string_view::npos) second = label.substr(at + separator.size());
    }

    std::string_view first;
    std::string_view second;
};

struct ShownFigure {
    const FigureDeclaration* figure = nullptr;
    double value = 0;

    LabelParts label() const { return LabelParts(figure->label); }
};

/// What the labels of a line's figures have in common, and stands before them.
enum class SharedPart { first, second };

bool share(const ShownFigure& a, const ShownFigure& b, SharedPart part) {
    if (group_path(a.figure->path) != group_path(b.figure->path)) return false;
    if (part == SharedPart::first) return a.label().first == b.label().first;
    return !a.label().second.empty() && a.label().second == b.label().second;
}

/// How many from the first on share a line.
std::size_t count_sharing(std::span<const ShownFigure> figures, SharedPart part) {
    std::size_t count = 1;
    while (count < figures.size() && share(figures.front(), figures[count], part))
        ++count;
    return count;
}

std::string caption_value(const ShownFigure& shown) {
    const FigureDeclaration& figure = *shown.figure;
    return figure.is_count ? fmt::format("{:.0f}", shown.value)
                           : figure_value_text(shown.value, figure.unit, caption_digits);
}

/// "PSNR 26.11 dB"; "0 % covered": what a fraction is of, the line says.
std::string with_own_unit(const ShownFigure& shown, std::string_view name) {
    const std::string unit = figure_unit_text(shown.figure->unit);
    const bool is_fraction = unit.starts_with(" %");
    if (is_fraction && !name.empty()) return fmt::format("{} % {}", caption_value(shown), name);
    return fmt::format("{}{}{}{}", name, name.empty() ? "" : " ", caption_value(shown), unit);
}

/// "UV error: p99 1.500, median 0.2500 texels", "Whole picture: FLIP 0.05981, PSNR 26.11 dB".
std::string line_of(std::span<const ShownFigure> figures, SharedPart part) {
    const std::string& unit = figures.front().figure->unit;
    const bool has_one_unit =
        std::ranges::all_of(figures, [&](const ShownFigure& shown) { return shown.figure->unit == unit; });
    std::vector<std::string> values;
    for (const ShownFigure& shown : figures) {
        const LabelParts label = shown.label();
        const std::string_view name = part == SharedPart::first ? label.second : label.first;
        values.push_back(has_one_unit ? fmt::format("{}{}{}", name, name.empty() ? "" : " ", caption_value(shown))
                                      : with_own_unit(shown, name));
    }
    const LabelParts label = figures.front().label();
    std::string subject(part == SharedPart::first ? label.first : label.second);
    if (!subject.empty())
        subject.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(subject.front())));
    return fmt::format("{}: {}{}", subject, join(values), has_one_unit ? figure_unit_text(unit) : "");
}

std::vector<std::string> lines_of(const CellResult& cell, const std::vector<const FigureDeclaration*>& figures) {
    std::vector<ShownFigure> shown;
    for (const FigureDeclaration* figure : figures) {
        if (const std::optional<double> value = value_of(*figure, cell)) shown.push_back({figure, *value});
    }
    std::vector<std::string> lines;
    for (std::span<const ShownFigure> rest = shown; !rest.empty();) {
        const std::size_t alike = count_sharing(rest, SharedPart::first);
        const std::size_t of_one_thing = count_sharing(rest, SharedPart::second);
        const SharedPart part = of_one_thing > alike ? SharedPart::second : SharedPart::first;
        const std::size_t count = std::max(alike, of_one_thing);
        lines.push_back(line_of(rest.first(count), part));
        rest = rest.subspan(count);
    }
    return lines;
}

}  // namespace

std::vector<std::string> figure_lines(const CellResult& cell) {
    std::vector<const FigureDeclaration*> shown;
    for (const FigureDeclaration& figure : cell.figures.list().all()) {
        if (!is_time(figure)) shown.push_back(&figure);
    }
    return lines_of(cell, shown);
}

std::vector<std::string> figure_lines(const CellResult& cell, const std::vector<std::string_view>& paths) {
    std::vector<const FigureDeclaration*> shown;
    for (const std::string_view path : paths)
        shown.push_back(&known_figure(path));
    return lines_of(cell, shown);
}

}  // namespace reliefbench
