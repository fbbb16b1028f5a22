#include "report/figure_lines.hpp"

#include "core/suggest.hpp"
#include "report/figure_text.hpp"

#include <fmt/format.h>

#include <utility>

namespace reliefbench {

namespace {

constexpr std::string_view label_separator = ", ";
constexpr int caption_digits = 4;

/// "UV error" and "p99" of "UV error, p99".
std::pair<std::string, std::string> split_label(const std::string& label) {
    const std::size_t at = label.find(label_separator);
    if (at == std::string::npos) return {label, ""};
    return {label.substr(0, at), label.substr(at + label_separator.size())};
}

/// Values of figures whose labels begin alike.
struct FigureLine {
    std::string subject;
    std::string unit;
    std::vector<std::string> values = {};

    std::string text() const { return fmt::format("{}: {}{}", subject, join(values), figure_unit_text(unit)); }
};

std::string caption_value(double value, const FigureDeclaration& figure) {
    return figure.is_count ? fmt::format("{:.0f}", value) : figure_value_text(value, figure.unit, caption_digits);
}

std::vector<std::string> lines_of(const CellResult& cell, const std::vector<const FigureDeclaration*>& figures) {
    std::vector<FigureLine> lines;
    for (const FigureDeclaration* figure : figures) {
        const std::optional<double> value = value_of(*figure, cell);
        if (!value) continue;
        const auto [subject, statistic] = split_label(figure->label);
        if (lines.empty() || lines.back().subject != subject || lines.back().unit != figure->unit)
            lines.push_back({subject, figure->unit});
        const std::string text = caption_value(*value, *figure);
        lines.back().values.push_back(statistic.empty() ? text : statistic + ' ' + text);
    }
    std::vector<std::string> texts;
    for (const FigureLine& line : lines)
        texts.push_back(line.text());
    return texts;
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
