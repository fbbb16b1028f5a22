#include "sweep/base_value.hpp"

#include "core/suggest.hpp"
#include "scene/surface/generated_base.hpp"
#include "scene/surface/mesh_file.hpp"
#include "sweep/input_path.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace reliefbench {

const std::vector<std::string>& base_words() {
    static const std::vector<std::string> words{"plane", "cylinder", "sphere", "saddle"};
    return words;
}

BaseSource read_base_value(const JsonView& view) {
    BaseSource source;
    if (view.json().is_object()) {
        view.require_only({"file"});
        source.kind = BaseSource::Kind::file;
        source.file = view.at("file").string();
        if (!is_mesh_file_name(source.file)) view.at("file").fail_expected(readable_meshes());
        return source;
    }
    if (!view.json().is_string()) {
        view.fail_expected(
            fmt::format("one of {}, the path of a mesh file, or {{\"file\": path}}", join(base_words())));
    }
    const std::string word = view.string();
    const auto known = std::ranges::find(base_words(), word);
    if (known != base_words().end()) {
        source.kind = static_cast<BaseSource::Kind>(known - base_words().begin());
    } else if (is_mesh_file_name(word)) {
        source.kind = BaseSource::Kind::file;
        source.file = word;
    } else {
        view.fail_here(fmt::format("no base '{}'{}; give one of {}, or {}", word, did_you_mean(word, base_words()),
                                   join(base_words()), readable_meshes()));
    }
    return source;
}

Json resolve_base_path(const JsonView& view, const std::vector<std::filesystem::path>& folders) {
    if (read_base_value(view).kind != BaseSource::Kind::file) return view.json();
    if (!view.json().is_object()) return resolve_input_path(view, folders);
    return {{"file", resolve_input_path(view.at("file"), folders)}};
}

std::string base_label(const BaseSource& source) {
    return source.kind == BaseSource::Kind::file ? source.file.filename().string()
                                                 : base_words()[static_cast<std::size_t>(source.kind)];
}

Json base_list_json() {
    const auto entry = [](const std::string& base, const std::vector<std::string>& axes, const std::string& limits,
                          const std::string& description) {
        return Json{{"base", base}, {"axes", axes}, {"limits", limits}, {"description", description}};
    };
    const auto generated = [&](BaseSource::Kind kind, const std::string& description) {
        const double largest = max_curvature(kind);
        const bool both_ways = kind == BaseSource::Kind::saddle;
        std::string limits =
            fmt::format("{}curvature{}*height_scale below 1", both_ways ? "|" : "", both_ways ? "|" : "");
        if (std::isfinite(largest))
            limits = fmt::format("curvature from {0:.4f} to {1:.4f}, ", -largest, largest) + limits;
        return entry(base_words()[static_cast<std::size_t>(kind)], {"curvature", "base_segments"}, limits, description);
    };
    return {entry("plane", {}, "", "the unit square, flat"),
            generated(BaseSource::Kind::cylinder, "the unit square rolled about the u axis"),
            generated(BaseSource::Kind::sphere, "the unit square laid over a sphere: true distances from its middle"),
            generated(BaseSource::Kind::saddle, "bent away from the viewer along one axis and towards along the other"),
            entry("FILE", {"base_fit"}, fmt::format("up to {} triangles with texture coordinates", max_file_triangles),
                  "the triangles of " + readable_meshes())};
}

}  // namespace reliefbench
