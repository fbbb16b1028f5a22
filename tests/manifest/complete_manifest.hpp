#pragma once

#include "manifest/manifest.hpp"
#include "support/error_message.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace reliefbench {

/// A manifest with something of everything; tests change a part of it.
inline Json complete() {
    return parse_json(R"({
        "title": "Test march", "kind": "march", "citation": "Nobody, 2024",
        "parameters": [
            {"name": "max_steps", "type": "integer", "default": 64, "range": [1, 256], "published": 32, "help": "Most."},
            {"name": "min_steps", "type": "integer", "default": 8, "range": [1, 256], "help": "Least."},
            {"name": "binary_steps", "type": "integer", "default": 5, "range": [0, 16], "help": "Halvings."},
            {"name": "bias", "type": "real", "default": 0, "range": [-1, 1], "help": "Shift."},
            {"name": "adaptive", "type": "boolean", "default": false, "help": "By angle."},
            {"name": "leaf", "type": "choice", "choices": ["linear", "exact"], "default": "exact", "help": "Leaf."}],
        "sample_count": "max_steps", "sample_count_minimum": "min_steps", "search_cap": ["max_steps", "min_steps"],
        "features": ["tessellationShader"], "needs": {"map": ["power_of_two", "square"]},
        "maps": [{"name": "tree", "format": "r16", "size": "next_power_of_two", "mip_chain": true},
                 {"name": "cones", "format": "rg32f", "linear_filter": true}],
        "passes": [{"name": "leaves", "shader": "leaves.glsl", "writes": "tree"},
                   {"name": "nodes", "shader": "nodes.glsl", "writes": "tree", "levels": "above_base"},
                   {"name": "search", "shader": "sub/search.glsl", "writes": "cones", "levels": "base"}],
        "shape": "quad",
        "promises": [{"promise": "order_1", "with": {"adaptive": false}, "halvings": "binary_steps",
                      "within": 0.5},
                     {"promise": "first_hit", "with": {"leaf": "exact", "bias": 0}}]
    })",
                      "test");
}

inline const std::vector<std::string> features{"tessellationShader", "shaderFloat64", "VK_EXT_mesh_shader"};
inline const std::filesystem::path shared_shaders =
    std::filesystem::path(RELIEFBENCH_SOURCE_DIR) / "harness" / "shaders";

inline Manifest parse(const Json& json) {
    return parse_manifest(json, "test", "technique.json", shared_shaders, {}, features);
}

inline std::string message_of(const Json& json, const std::string& id = "test") {
    return error_message([&] { parse_manifest(json, id, "technique.json", shared_shaders, {}, features); });
}

/// `complete()` with the member at the JSON pointer replaced.
inline Json with(const std::string& pointer, const Json& value) {
    Json json = complete();
    json[Json::json_pointer(pointer)] = value;
    return json;
}

}  // namespace reliefbench
