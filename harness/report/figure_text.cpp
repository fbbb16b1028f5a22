#include "report/figure_text.hpp"

#include "report/text_layout.hpp"

#include <fmt/format.h>

#include <cmath>

namespace reliefbench {

namespace {

constexpr std::string_view fraction = "fraction";

}  // namespace

double figure_as_shown(double value, std::string_view unit) {
    return unit.starts_with(fraction) ? 100 * value : value;
}

std::string figure_value_text(double value, std::string_view unit, int digits) {
    return std::isfinite(value) ? significant(figure_as_shown(value, unit), digits) : "∞";
}

std::string figure_unit_text(std::string_view unit) {
    if (unit.empty()) return "";
    if (!unit.starts_with(fraction)) return fmt::format(" {}", unit);
    return fmt::format(" %{}", unit.substr(fraction.size()));
}

std::string column_title(const FigureDeclaration& figure) {
    const std::string& name = figure.short_label.empty() ? figure.label : figure.short_label;
    return figure.unit.starts_with(fraction) ? name + " %" : name;
}

}  // namespace reliefbench
