#include "verify_test.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace reliefbench::test {

namespace {

constexpr int repeats = 3;

/// The same surface without a wrap: a map of `repeats` by `repeats` copies.
HeightMap tiled(const HeightMap& map) {
    return map_of({repeats * map.width(), repeats * map.height()},
                  [&](int x, int y) { return static_cast<double>(map.texel(x, y)); });
}

/// The defaults, and what each promise is made for.
std::vector<ParameterValues> settings_of(const Manifest& manifest) {
    std::vector<ParameterValues> all{manifest.defaults()};
    for (const PromiseDeclaration& promise : manifest.promises) {
        const ParameterValues values = with_values(manifest, promise.with);
        if (std::ranges::find(all, values) == all.end()) all.push_back(values);
    }
    return all;
}

/// Whether answers depend on the surface alone. Cones and distances are rounded in units of texture coordinates, which
/// are other lengths on a map of copies.
bool answers_are_the_surfaces(const Manifest& manifest, const ParameterValues& values) {
    const bool has_maps =
        std::ranges::any_of(manifest.maps, [&](const MapDeclaration& map) { return all_hold(map.only_with, values); });
    return !has_maps || std::ranges::any_of(manifest.promises, [](const PromiseDeclaration& promise) {
        return promise.promise == Promise::first_hit;
    });
}

/// Dummer's least step is a length with the relief one side of the texture deep, which is another length on a map of
/// copies: the rule that measures it in the scene takes its place.
ParameterValues measured_in_the_scene(ParameterValues values) {
    const auto rule = values.find("step_rule");
    if (rule != values.end()) rule->second = std::string("larger");
    return values;
}

/// The map's texture coordinates are `repeats` times as long as those of the map of copies: lengths in them are scaled.
ParameterValues in_longer_coordinates(ParameterValues values) {
    const auto length = values.find("metric_height");
    if (length != values.end()) length->second = std::get<double>(length->second) / repeats;
    return values;
}

double texels_apart(const Hit& a, const Hit& b, Resolution texels) {
    return std::hypot((a.u - b.u) * static_cast<float>(texels.width), (a.v - b.v) * static_cast<float>(texels.height));
}

/// Fraction of the footprint in which only one hits, or both and more than `tolerance` texels apart.
double fraction_apart(const TruthComparison& a, const TruthComparison& b, Resolution texels, double tolerance) {
    std::size_t apart = 0;
    for (std::size_t pixel = 0; pixel < a.truth.footprint.texels.size(); ++pixel) {
        if (a.truth.footprint.texels[pixel] == 0) continue;
        const Hit& hit_a = a.probe.hits.texels[pixel];
        const Hit& hit_b = b.probe.hits.texels[pixel];
        if (hit_a.is_hit() != hit_b.is_hit() || (hit_a.is_hit() && texels_apart(hit_a, hit_b, texels) > tolerance))
            ++apart;
    }
    return static_cast<double>(apart) / static_cast<double>(a.errors.footprint);
}

class Wrap : public VerifyTest, public testing::WithParamInterface<std::string> {
protected:
    static void expect_same(bool to_rounding, const TruthComparison& wrapped, const TruthComparison& copies,
                            Resolution texels, const std::string& what) {
        ASSERT_TRUE(wrapped.errors.uv_texels && copies.errors.uv_texels) << what;
        const Summary& error = *wrapped.errors.uv_texels;
        const Summary& expected = *copies.errors.uv_texels;
        const double wrong = wrapped.errors.missed + wrapped.errors.false_hits;
        const double expected_wrong = copies.errors.missed + copies.errors.false_hits;
        constexpr double worse = 1.25;
        constexpr double floor_texels = 0.05;
        if (to_rounding) {
            // What differs is rounding, which decides whether a ray passes an edge.
            constexpr double rounding_texels = 0.01;
            constexpr double tolerated = 0.005;
            EXPECT_LE(fraction_apart(wrapped, copies, texels, rounding_texels), tolerated) << what;
            // For the others rounding decides how often a step goes past an edge.
            EXPECT_LE(error.p99, worse * expected.p99 + floor_texels) << what;
        }
        EXPECT_LE(error.p50, worse * expected.p50 + floor_texels) << what;
        EXPECT_LE(error.p95, worse * expected.p95 + floor_texels) << what;
        EXPECT_LE(wrong, expected_wrong + 0.005) << what;
    }
};

}  // namespace

/// Seen three times on a side, a small map that is neither square nor a power of two looks as the same content on a map
/// of its own: no row, column or node at the wrap is read wrong, and nothing is measured along the wrong side.
TEST_P(Wrap, IsNoWorseThanTheSameContentWithoutOne) {
    const Technique technique = shipped(GetParam());
    const HeightMap map = procedural("rock", {48, 20});
    const CoordinateScene once(device(), map);
    const CoordinateScene copies(device(), tiled(map));
    const Resolution texels = copies.map.heights.size;
    for (const ParameterValues& setting : settings_of(technique.manifest)) {
        const ParameterValues values = measured_in_the_scene(setting);
        for (const Boundary boundary : {Boundary::clip, Boundary::repeat}) {
            // Over the plane it ends with its patch.
            if (technique.manifest.shape.kind == "shell" && boundary == Boundary::repeat) continue;
            for (View view : {parallel_view(70, -67), perspective_view(60, 25)}) {
                view.relief.boundary = boundary;
                const TruthComparison expected =
                    compare_with_truth(device(), technique, in_longer_coordinates(values), copies, view);
                view.relief.tiling = repeats;
                const TruthComparison wrapped = compare_with_truth(device(), technique, values, once, view);
                expect_same(answers_are_the_surfaces(technique.manifest, values), wrapped, expected, texels,
                            fmt::format("{}; {}, {}", describe(values, technique.manifest),
                                        to_string(view.camera.projection), to_string(boundary)));
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Shipped, Wrap, testing::ValuesIn(shipped_ids()),
                         [](const auto& instance) { return instance.param; });

}  // namespace reliefbench::test
