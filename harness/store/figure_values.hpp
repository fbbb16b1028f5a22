#pragma once

#include "store/figures.hpp"

#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

namespace reliefbench {

/// The figures of one cell: each has a number, is undefined (null in the file), or is not given at all.
class FigureValues {
public:
    explicit FigureValues(std::shared_ptr<const FigureList> list = declared_figures());

    const FigureList& list() const { return *list_; }

    /// All of a family; of this list.
    void add(const FigureValueList& values);
    /// Empty: not given. Not finite: undefined. The path is one of the list's.
    void set(std::string_view path, std::optional<double> value);
    void set(std::size_t index, std::optional<double> value);

    /// Empty where it is undefined or not given.
    std::optional<double> value(std::size_t index) const;
    bool is_given(std::size_t index) const { return values_[index] != not_given; }

    /// Takes away what `is_wanted` refuses.
    template <typename IsWanted>
    void keep_only(const IsWanted& is_wanted) {
        for (std::size_t index = 0; index < values_.size(); ++index) {
            if (!is_wanted(list_->all()[index])) values_[index] = not_given;
        }
    }

private:
    // One number a figure: runs have a hundred thousand cells.
    static constexpr double not_given = std::numeric_limits<double>::infinity();

    std::shared_ptr<const FigureList> list_;
    std::vector<double> values_;
};

}  // namespace reliefbench
