#include "sweep/cell.hpp"

#include "manifest/parameter_json.hpp"
#include "sweep/view_axes.hpp"

#include <cassert>

namespace reliefbench {

Json axes_to_json(const ViewKey& view) {
    Json axes = Json::object();
    for (const ViewAxis& axis : view_axes()) {
        if (!axis.part_of_height_map) axes[axis.name] = axis.value(view);
    }
    return axes;
}

Json parameters_to_json(const ParameterValues& values) {
    Json parameters = Json::object();
    for (const auto& [name, value] : values)
        parameters[name] = to_json(value);
    return parameters;
}

std::string technique_id(const Manifest& manifest, const ParameterValues& values, const Preset* preset) {
    std::string id = manifest.id;
    if (preset != nullptr) id += " preset=" + preset->name;
    const ParameterValues expected = values_of_preset(manifest, preset);
    for (const Parameter& parameter : manifest.parameters) {
        const auto value = values.find(parameter.name);
        if (value == values.end() || value->second == expected.at(parameter.name)) continue;
        // Of a preset whose other values make it idle: it is at its default, and says nothing.
        if (value->second == parameter.default_value && !has_effect(parameter, values, true)) continue;
        id += ' ' + parameter.name + '=' + to_string(value->second);
    }
    return id;
}

std::string cell_id(const Manifest& manifest, const ParameterValues& values, const ViewKey& view) {
    return technique_id(manifest, values) + " | " + view_id(view);
}

std::vector<Block> make_blocks(const std::vector<Cell>& cells, std::size_t max_cells) {
    assert(max_cells > 0);
    std::vector<Block> blocks;
    Block block;
    const auto close = [&] {
        if (!block.cells.empty()) blocks.push_back(std::exchange(block, Block{}));
    };
    std::size_t begin = 0;
    while (begin < cells.size()) {
        std::vector<std::size_t> view;
        std::size_t end = begin;
        for (; end < cells.size() && cells[end].view == cells[begin].view; ++end) {
            if (cells[end].skip_reason.empty()) view.push_back(end);
        }
        if (block.cells.size() + view.size() > max_cells) close();
        for (const std::size_t index : view) {
            if (block.cells.size() == max_cells) close();
            block.cells.push_back(index);
        }
        begin = end;
    }
    close();
    return blocks;
}

}  // namespace reliefbench
