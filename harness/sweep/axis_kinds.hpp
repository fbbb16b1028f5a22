#pragma once

#include "core/suggest.hpp"
#include "sweep/view_axes.hpp"

#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

/// What the rows of the table of axes (sweep/view_axes.hpp) are made of.
namespace reliefbench {

/// Numbers that an axis takes, from `minimum` to `maximum`; each end may be left out.
struct NumberRange {
    double minimum = 0;
    double maximum = 0;
    bool above_minimum = false;
    bool below_maximum = false;

    std::string text() const {
        return fmt::format("{} {}{} {}", above_minimum ? "above" : "from", minimum,
                           above_minimum   ? ", up to"
                           : below_maximum ? " to below"
                                           : " to",
                           maximum);
    }

    double read(const JsonView& view) const {
        if (!above_minimum && !below_maximum) return view.number(minimum, maximum);
        const double number = view.json().is_number() ? view.json().get<double>() : minimum - 1;
        const bool inside = (above_minimum ? number > minimum : number >= minimum) &&
                            (below_maximum ? number < maximum : number <= maximum);
        if (!inside) view.fail_expected("a number " + text());
        return number;
    }
};

struct IntegerRange {
    int minimum = 0;
    int maximum = 0;

    std::string text() const { return fmt::format("integers from {} to {}", minimum, maximum); }
    int read(const JsonView& view) const { return static_cast<int>(view.integer(minimum, maximum)); }
};

inline const ViewKey& plain_view() {
    static const ViewKey view;
    return view;
}

/// An axis that is one number of the view.
template <typename Range, typename Member>
ViewAxis number_axis(std::string name, AxisDescription description, Range range, Member member) {
    description.values = range.text();
    return {std::move(name), std::move(description),
            [range, member](const JsonView& json) -> ViewSetting {
                return [number = range.read(json), member](ViewKey& view) { member(view) = number; };
            },
            [member](const ViewKey& view) { return Json(member(view)); }, Json(member(plain_view()))};
}

/// An axis that is one of a few words, of an enumeration in the order of its enumerators.
template <typename Enumeration, typename Member>
ViewAxis word_axis(std::string name, AxisDescription description, std::vector<std::string> words, Member member) {
    description.values = join(words, "|");
    return {std::move(name), std::move(description),
            [words, member](const JsonView& json) -> ViewSetting {
                const auto value = static_cast<Enumeration>(json.choice(words));
                return [value, member](ViewKey& view) { member(view) = value; };
            },
            [words, member](const ViewKey& view) { return Json(words[static_cast<std::size_t>(member(view))]); },
            Json(words[static_cast<std::size_t>(member(plain_view()))])};
}

/// Makes an axis one that only some views have.
template <typename HasUse>
ViewAxis only_for(HasUse has_use, ViewAxis axis) {
    axis.value_in_use = axis.value;
    axis.value = [has_use, value = std::move(axis.value)](const ViewKey& view) {
        return has_use(view) ? value(view) : Json();
    };
    return axis;
}
inline ViewAxis only_where(bool (*has_use)(const View&), ViewAxis axis) {
    return only_for([has_use](const ViewKey& view) { return has_use(view.view); }, std::move(axis));
}

}  // namespace reliefbench
