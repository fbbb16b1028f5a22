#include "measure/truth_cache.hpp"

#include "core/cache_folder.hpp"
#include "core/hash.hpp"
#include "measure/base_records.hpp"
#include "reference/pixel_loop.hpp"
#include "reference/stored_truth.hpp"
#include "reference/truth_code.hpp"
#include "sweep/settings.hpp"

#include <fmt/format.h>

#include <chrono>
#include <span>
#include <string_view>

namespace reliefbench {

namespace {

/// One of 1920×1080 takes up to 95 MB, one of 256×256 up to 3 MB.
constexpr std::uint64_t max_truth_bytes = std::uint64_t{4} << 30;

CachedFiles cached_truths(const std::filesystem::path& folder) {
    return {.folder = folder, .extension = ".truth", .content = "truths", .max_bytes = max_truth_bytes};
}

std::string text_of(const BaseSurface& base) {
    if (is_flat(base)) return "plane";
    const BaseMesh& mesh = curved_base(base);
    return hash_of_mesh(mesh) + content_hash(std::as_bytes(std::span(mesh.charts))) +
           content_hash(std::as_bytes(std::span(mesh.chart_periods)));
}

/// Numbers as the shortest text that is read as the same.
std::string text_of(const View& view) {
    const Camera& camera = view.camera;
    const Relief& relief = view.relief;
    return fmt::format("camera {} {} {} {} {} {} {}\nrelief {} {} {} {}\nbase {}\nresolution {}x{}\nshadows {}\n",
                       to_string(camera.projection), camera.view_angle, camera.azimuth, camera.distance, camera.fov,
                       camera.shift.x, camera.shift.y, relief.height_scale, relief.tiling, to_string(relief.boundary),
                       relief.polygon_height, text_of(relief.base), view.resolution.width, view.resolution.height,
                       static_cast<int>(view.self_shadow.mode));
}

}  // namespace

std::string content_of(const Albedo& albedo) {
    const Resolution size = albedo.texels.size;
    return fmt::format("{}x{} {}", size.width, size.height,
                       content_hash(std::as_bytes(std::span(albedo.texels.texels))));
}

std::string cache_key(const TruthContent& content) {
    TruthSettings settings = content.settings;
    if (settings.kind == TruthSettings::Kind::exact) settings.subdivision = TruthSettings{}.subdivision;
    std::string text =
        fmt::format("code {}\nheight map {}\nalbedo {}\n", truth_code(), content.map.hash, content.albedo);
    text += text_of(content.view);
    text += fmt::format("lighting {}\ntruth {}\n", to_json(content.lighting).dump(), to_json(settings).dump());
    if (content.object) text += fmt::format("object {}\n", to_json(*content.object).dump());
    return content_hash(text);
}

std::optional<Truth> read_cached_truth(const std::filesystem::path& folder, const std::string& key) {
    const auto start = std::chrono::steady_clock::now();
    std::optional<Truth> truth;
    const bool is_read =
        cached_truths(folder).read(key, [&truth](std::string_view bytes) { truth = parse_stored_truth(bytes); });
    if (!is_read) return std::nullopt;
    truth->trace_ms = milliseconds_since(start);
    return truth;
}

void cache_truth(const std::filesystem::path& folder, const std::string& key, const Truth& truth) {
    if (!folder.empty()) cached_truths(folder).write(key, stored_truth(truth));
}

}  // namespace reliefbench
