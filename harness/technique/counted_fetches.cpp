#include "technique/counted_fetches.hpp"

#include "core/error.hpp"
#include "gpu/fetches.hpp"

#include <filesystem>
#include <set>
#include <utility>

namespace reliefbench {

namespace {

/// Names are unique over a technique's folder and the shared shaders: no technique has files of these names.
bool may_fetch(const std::string& file) {
    const std::string name = std::filesystem::path(file).lexically_normal().generic_string();
    return name == "taps.glsl" || name == "surface.glsl";
}

const char* remedy(gpu::Fetch::Kind kind) {
    switch (kind) {
        case gpu::Fetch::Kind::sampled:
            return "use tap_height(uv), or tap_map(map, uv, lod) or tap_map_gradients(map, uv, uv_dx, uv_dy) for "
                   "another map";
        case gpu::Fetch::Kind::texel:
            return "use tap_height_texel(texel), or tap_map_texel(map, texel, lod) for another map";
        case gpu::Fetch::Kind::gather:
            return "use tap_height_cell(cell), or tap_map_cell(map, cell, channel) for another map";
        case gpu::Fetch::Kind::stored:
            return "use tap_map_texel(map, texel, lod) on a map that a pass has written";
    }
    return "";
}

}  // namespace

void refuse_uncounted_fetches(const gpu::SpirV& module) {
    constexpr std::size_t max_listed = 20;
    std::set<std::pair<std::string, std::uint32_t>> told;
    std::string complaints;
    for (const gpu::Fetch& fetch : gpu::find_fetches(module)) {
        if (may_fetch(fetch.file) || !told.emplace(fetch.file, fetch.line).second) continue;
        if (told.size() > max_listed) {
            complaints += "\n...";
            break;
        }
        complaints += fmt::format("{}{}:{}: this fetch would count as no tap; {}", complaints.empty() ? "" : "\n",
                                  fetch.file, fetch.line, remedy(fetch.kind));
    }
    if (!complaints.empty()) fail("{}", complaints);
}

}  // namespace reliefbench
