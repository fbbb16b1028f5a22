#include "store/view_variants.hpp"

#include "core/json_lookup.hpp"
#include "sweep/view_axes.hpp"

#include <algorithm>
#include <optional>
#include <set>
#include <sstream>

namespace reliefbench {

namespace {

std::vector<const ViewAxis*> axes_that_move_no_hits() {
    std::vector<const ViewAxis*> axes;
    for (const ViewAxis& axis : view_axes()) {
        if (!axis.moves_hits) axes.push_back(&axis);
    }
    return axes;
}

/// Null where the cell has no use for the axis.
Json value_of(const ViewAxis& axis, const CellResult& cell) {
    return cell.axes.is_object() && cell.axes.contains(axis.name) ? cell.axes[axis.name] : axis.default_value;
}

/// Whether there is more than one value among the cells that have one.
bool varies(const ViewAxis& axis, const std::vector<CellResult>& cells) {
    std::set<std::string> values;
    for (const CellResult& cell : cells) {
        const Json value = value_of(axis, cell);
        if (!value.is_null()) values.insert(value.dump());
    }
    return values.size() > 1;
}

void append_word(std::string& words, const std::string& word) {
    if (!words.empty()) words += ' ';
    words += word;
}

/// The id's part after the bar, without the words of these axes.
std::string view_without(const std::string& id, const std::vector<const ViewAxis*>& axes) {
    constexpr std::string_view bar = " | ";
    const std::size_t at = id.find(bar);
    if (at == std::string::npos) return "";
    std::istringstream words(id.substr(at + bar.size()));
    std::string view;
    for (std::string word; std::getline(words, word, ' ');) {
        const std::string name = word.substr(0, word.find('='));
        const bool left_out =
            std::any_of(axes.begin(), axes.end(), [&](const ViewAxis* axis) { return axis->name == name; });
        if (!left_out) append_word(view, word);
    }
    return view;
}

}  // namespace

std::string axis_word(const std::string& axis, const Json& value) {
    return axis + '=' + scalar_text(value);
}

std::vector<ViewVariant> view_variants(const std::vector<CellResult>& cells) {
    std::vector<const ViewAxis*> axes = axes_that_move_no_hits();
    std::set<const ViewAxis*> varying;
    for (const ViewAxis* axis : axes) {
        if (varies(*axis, cells)) varying.insert(axis);
    }
    if (varying.empty()) axes.clear();
    std::vector<ViewVariant> variants;
    for (const CellResult& cell : cells) {
        ViewVariant& split = variants.emplace_back(ViewVariant{view_without(cell.cell, axes), ""});
        for (const ViewAxis* axis : axes) {
            const Json value = value_of(*axis, cell);
            if (value.is_null() || (!varying.contains(axis) && value == axis->default_value)) continue;
            append_word(split.variant, axis_word(axis->name, value));
        }
    }
    return variants;
}

}  // namespace reliefbench
