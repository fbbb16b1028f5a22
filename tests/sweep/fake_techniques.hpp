#pragma once

#include "manifest/manifest.hpp"

#include <vector>

namespace reliefbench {

/// Manifests of no shipped technique: `plain` has no parameter, `march` an adaptive sample count, `tree` a capped one
/// and a choice, `mesh` an integer of its own.
inline std::vector<Manifest> fake_techniques() {
    const auto manifest = [](const std::string& id, const std::string& members) {
        const std::string text =
            R"({"title": "Fake", "kind": "march", "citation": "Nobody", "shape": "quad", "promises": [], )" + members +
            "}";
        return parse_manifest(parse_json(text, id), id, id);
    };
    return {
        manifest("plain", R"("parameters": [])"),
        manifest("march", R"("sample_count": "max_steps", "sample_count_minimum": "min_steps", "parameters": [
            {"name": "max_steps", "type": "integer", "default": 32, "range": [1, 256], "help": "Most."},
            {"name": "min_steps", "type": "integer", "default": 8, "range": [1, 256], "help": "Least."},
            {"name": "adaptive", "type": "boolean", "default": false, "help": "By angle."}])"),
        manifest("tree", R"("sample_count": "max_steps", "parameters": [
            {"name": "max_steps", "type": "integer", "default": 64, "range": [16, 4096], "help": "Cap."},
            {"name": "leaf", "type": "choice", "choices": ["linear", "exact"], "default": "exact", "help": "Leaf."}])"),
        manifest("mesh", R"("parameters": [
            {"name": "factor", "type": "integer", "default": 64, "range": [1, 64], "help": "Factor."},
            {"name": "bias", "type": "real", "default": 0, "range": [-1, 1], "help": "Shift."}])"),
    };
}

}  // namespace reliefbench
