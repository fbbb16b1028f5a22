#include "store/figure_values.hpp"

#include <cassert>
#include <cmath>
#include <utility>

namespace reliefbench {

FigureValues::FigureValues(std::shared_ptr<const FigureList> list)
    : list_(std::move(list)), values_(list_->all().size(), not_given) {}

void FigureValues::add(const FigureValueList& values) {
    for (const auto& [path, value] : values)
        set(path, value);
}

void FigureValues::set(std::string_view path, std::optional<double> value) {
    const FigureDeclaration* const figure = list_->find(path);
    assert(figure != nullptr);
    set(*list_->index_of(*figure), value);
}

void FigureValues::set(std::size_t index, std::optional<double> value) {
    if (value && !std::isfinite(*value)) value = std::numeric_limits<double>::quiet_NaN();
    values_[index] = value.value_or(not_given);
}

std::optional<double> FigureValues::value(std::size_t index) const {
    if (std::isfinite(values_[index])) return values_[index];
    return std::nullopt;
}

}  // namespace reliefbench
