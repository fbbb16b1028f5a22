// Proves cone maps on the processor and measures how often techniques that step along cones pass the surface: the
// tables of the techniques' READMEs. Usage: cone_proof [--rays] [FILE...]: height maps beside the procedural ones,
// reduced to 128x128; --rays leaves the proof out.

#include "verify/drawing.hpp"
#include "verify/promise_checks.hpp"

#include "core/cache_folder.hpp"
#include "core/error.hpp"
#include "gpu/device.hpp"
#include "scene/procedural.hpp"
#include "verify/cone_maps.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdio>
#include <numeric>
#include <string>
#include <vector>

using namespace reliefbench;
using namespace reliefbench::test;

namespace {

constexpr int side = 128;
constexpr int published_search_steps = 128;
/// A place of a relaxed cone costs more than a thousand rays.
constexpr std::size_t conservative_places = 20000;
constexpr std::size_t relaxed_places = 2000;

/// Averaged over squares of texels.
HeightMap reduced(const std::string& file) {
    HeightMapSource source;
    source.name = file;
    const HeightMap map = load_height_map(source, HeightFormat::r16);
    if (map.width() % side != 0 || map.height() % side != 0) fail("{}: its sides are no multiples of {}", file, side);
    const int across = map.width() / side;
    const int down = map.height() / side;
    Image<float> heights({side, side});
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            double sum = 0;
            for (int j = 0; j < down; ++j) {
                for (int i = 0; i < across; ++i)
                    sum += map.texel(x * across + i, y * down + j);
            }
            heights.at(x, y) = static_cast<float>(sum / (across * down));
        }
    }
    return make_height_map(heights, HeightFormat::r16, map.name);
}

std::vector<HeightMap> height_maps(const std::vector<std::string>& files) {
    std::vector<HeightMap> maps;
    for (const ProceduralMap& procedural : procedural_maps()) {
        HeightMapSource source;
        source.name = procedural.name;
        source.size = {side, side};
        maps.push_back(load_height_map(source, HeightFormat::r16));
    }
    for (const std::string& file : files)
        maps.push_back(reduced(file));
    return maps;
}

double mean(const Ratios& ratios) {
    return std::accumulate(ratios.texels.begin(), ratios.texels.end(), 0.0) / static_cast<double>(ratios.texels.size());
}

void print_proof(const std::string& map, const std::string& cones, const Ratios& ratios, const ConeProof& proof) {
    fmt::print("| {} | {} | {:.4f} | {:.2f} % | {:.2f} |\n", map, cones, mean(ratios), 100 * proof.failed_fraction(),
               proof.deepest_texels);
    std::fflush(stdout);
}

void prove(const HeightMap& map) {
    const Ratios conservative = stored(conservative_ratios(map));
    const Ratios published = stored(published_relaxed_ratios(map, published_search_steps));
    const Ratios falling = stored(falling_edge_ratios(map));
    const auto conservative_line = [&](const std::string& cones, const Ratios& ratios) {
        print_proof(map.name, cones, ratios, prove_conservative(map, ratios, conservative_places));
    };
    const auto relaxed_line = [&](const std::string& cones, const Ratios& ratios) {
        print_proof(map.name, cones, ratios, prove_relaxed(map, ratios, relaxed_places));
    };
    conservative_line("conservative", conservative);
    print_proof(map.name, "conservative, square roots", conservative,
                prove_conservative(map, stored(square_roots(conservative_ratios(map))), conservative_places,
                                   ConeEncoding::square_root));
    conservative_line("conservative, 3x3 minimum", narrowest_around(conservative));
    relaxed_line("relaxed, published", published);
    relaxed_line("relaxed, falling edges", falling);
    relaxed_line("relaxed, falling edges, 3x3 minimum", narrowest_around(falling));
}

struct Variant {
    std::string technique;
    ParameterValues parameters;
};

std::vector<Variant> variants() {
    using namespace std::string_literals;
    return {
        {"cone_step", {}},
        {"cone_step", {{"cone_encoding", "linear"s}}},
        {"cone_step", {{"step_rule", "larger"s}}},
        {"cone_step", {{"step_rule", "larger"s}, {"cone_encoding", "linear"s}}},
        {"cone_step", {{"minimum_step", 0.0}}},
        {"cone_step", {{"minimum_step", 0.0}, {"cone_encoding", "linear"s}}},
        {"cone_step", {{"refinement", "linear"s}}},
        {"quad_cone", {}},
        {"quad_cone", {{"step_rule", "larger"s}}},
        {"quad_cone", {{"minimum_step", 0.0}}},
        {"quad_cone", {{"minimum_step", 0.0}, {"max_steps", std::int64_t{15}}}},
        {"relaxed_cone", {}},
        {"relaxed_cone", {{"preparation", "falling_edges"s}}},
        {"relaxed_cone", {{"max_steps", std::int64_t{256}}}},
        {"robust_cone", {{"preparation", "pruned"s}, {"minimum_step", false}, {"refinement", "none"s}}},
        {"robust_cone", {{"preparation", "pruned"s}, {"refinement", "none"s}}},
        {"robust_cone", {{"bump_check", false}}},
        {"robust_cone", {{"bump_check", true}}},
    };
}

/// Along texel rows, where the bilinear surface is a chain of straight lines, and off the axes.
constexpr std::array<double, 3> azimuths{-90, -67, -45};

/// Parallel rays at 75 degrees over a relief that goes on for ever.
View steep_view(double azimuth) {
    View view;
    view.camera.projection = Projection::parallel;
    view.camera.view_angle = 75;
    view.camera.azimuth = azimuth;
    view.relief.height_scale = 0.1;
    view.relief.boundary = Boundary::repeat;
    view.resolution = {192, 192};
    return view;
}

void overshoot(const gpu::Device& device, const TechniqueLibrary& library, const CoordinateScene& scene) {
    const double deviation = measure_filter_deviation(device, HeightFormat::r16);
    for (const Variant& variant : variants()) {
        const Technique& technique = library.get(variant.technique);
        const ParameterValues values = with_values(technique.manifest, variant.parameters);
        for (const double azimuth : azimuths) {
            const View view = steep_view(azimuth);
            const TruthComparison found =
                compare_with_truth(device, technique, values, scene, view, {.cache = cache_folder()});
            const auto footprint = static_cast<double>(found.errors.footprint);
            double unconverged = 0;
            double taps = 0;
            for (const PixelWork& work : found.probe.work.texels) {
                unconverged += work.unconverged;
                taps += work.taps;
            }
            fmt::print("| {} | {} | {} | {} | {:.3f} % | {:.3f} % | {:.2f} % | {:.1f} | {:.3g} |\n", scene.map.name,
                       variant.technique, describe(values, technique.manifest), azimuth,
                       100 * static_cast<double>(pixels_beyond(found, scene.map, view, deviation)) / footprint,
                       100 * found.errors.missed, 100 * unconverged / footprint, taps / footprint,
                       found.errors.uv_texels->p99);
            std::fflush(stdout);
        }
    }
}

}  // namespace

int main(int argc, char** argv) {
    try {
        std::vector<std::string> files(argv + 1, argv + argc);
        const bool rays_only = std::erase(files, "--rays") > 0;
        const std::vector<HeightMap> maps = height_maps(files);
        if (!rays_only) {
            fmt::print("| Map | Cones | Mean ratio | Places that fail | Deepest, texels |\n|---|---|---|---|---|\n");
            for (const HeightMap& map : maps)
                prove(map);
        }
        const gpu::Device device;
        const TechniqueLibrary library = find_techniques({default_technique_root()});
        fmt::print(
            "\nOn {}:\n\n| Map | Technique | Parameters | Azimuth | Beyond the first hit | Missed | Unconverged | Taps "
            "| p99, texels |\n|---|---|---|---|---|---|---|---|---|\n",
            device.info().name);
        for (const HeightMap& map : maps)
            overshoot(device, library, CoordinateScene(device, map));
    } catch (const Error& error) {
        fmt::print(stderr, "cone_proof: {}\n", error.what());
        return 1;
    }
    return 0;
}
