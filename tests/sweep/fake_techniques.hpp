#pragma once

#include "manifest/manifest.hpp"

#include <vector>

namespace reliefbench {

/// Manifests of no shipped technique: `plain` has no parameter, `march` an adaptive sample count and two presets,
/// `tree` a capped one and a choice with a preset, `mesh` an integer of its own.
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
            {"name": "adaptive", "type": "boolean", "default": false, "help": "By angle."}],
            "presets": [
                {"name": "quick_engine", "title": "Quick Engine 1", "source": "quick/engine, march.glsl at 1234567",
                 "parameters": {"max_steps": 16, "min_steps": 8, "adaptive": true}, "not_expressed": "Its dithering."},
                {"name": "slow_engine", "title": "Slow", "source": "a book", "parameters": {"max_steps": 128}}])"),
        manifest("tree", R"("sample_count": "max_steps", "parameters": [
            {"name": "max_steps", "type": "integer", "default": 64, "range": [16, 4096], "help": "Cap."},
            {"name": "leaf", "type": "choice", "choices": ["linear", "exact"], "default": "exact", "help": "Leaf."}],
            "presets": [{"name": "forest", "title": "Forest", "source": "a wood", "parameters": {"leaf": "linear"}}])"),
        manifest("mesh", R"("parameters": [
            {"name": "factor", "type": "integer", "default": 64, "range": [1, 64], "help": "Factor."},
            {"name": "bias", "type": "real", "default": 0, "range": [-1, 1], "help": "Shift."}])"),
    };
}

}  // namespace reliefbench
