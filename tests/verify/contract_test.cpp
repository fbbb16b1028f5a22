// Contract 1, that of version 0.1.0, beside the newest: over the plane both are the same to the last bit.

#include "core/file.hpp"
#include "support/error_message.hpp"
#include "verify_test.hpp"

#include <gmock/gmock.h>

#include <fmt/format.h>

#include <cstring>

namespace reliefbench::test {
namespace {

/// A technique of one shader, in a folder of its own.
Technique technique_of(const TemporaryFolder& root, const std::string& id, int contract, const std::string& trace) {
    const std::filesystem::path folder = root.path() / id;
    std::filesystem::create_directories(folder);
    write_text_file(folder / "technique.json", fmt::format(R"({{"title": "T", "contract": {}, "kind": "march",
        "citation": "c", "parameters": [], "shape": "quad", "promises": []}})",
                                                           contract));
    write_text_file(folder / "trace.glsl", trace);
    return find_techniques({root.path()}).get(id);
}

class Contracts : public VerifyTest {
protected:
    static void expect_same_hits(const Technique& technique, const Technique& other) {
        for (const double tiling : {1.0, 3.0}) {
            View view = perspective_view(65, -67);
            view.resolution = {64, 64};
            view.relief.tiling = tiling;
            const CoordinateScene scene(device(), procedural("cobbles", {48, 64}));
            const auto hits_of = [&](const Technique& drawn) {
                return compare_with_truth(device(), drawn, drawn.manifest.defaults(), scene, view).probe.hits;
            };
            const Image<Hit> hits = hits_of(technique);
            const Image<Hit> others = hits_of(other);
            ASSERT_EQ(hits.texels.size(), others.texels.size());
            EXPECT_EQ(std::memcmp(hits.texels.data(), others.texels.data(), hits.texels.size() * sizeof(Hit)), 0)
                << technique.manifest.id << ", tiling " << tiling;
        }
    }
};

// Of these the shaders are the same text to either contract.
TEST_F(Contracts, TheLibraryServesBothAlike) {
    for (const char* id : {"pom", "relief", "secant", "steep", "contact_refinement", "max_mip", "qdm", "cone_step",
                           "quad_cone", "relaxed_cone", "robust_cone"}) {
        const BrokenCopy copy(id, "technique.json", "\"contract\": 2", "\"contract\": 1");
        ASSERT_EQ(copy.technique().manifest.contract, 1);
        expect_same_hits(copy.technique(), shipped(id));
    }
}

// What techniques of version 0.1.0 could do with a ray, making one of their own included.
TEST_F(Contracts, TheFirstHasTheRayOfVersion010) {
    const std::string search = R"(#include "refinement.glsl"
float tap_along(ReliefRay ray, float s) { return tap_height(point_on_ray(ray, s)); }
Trace trace(ReliefRay pixel) {
    RAY
    float h = tap_along(ray, 0.0);
    Crossing crossing = Crossing(0.0, h, 0.0, h, 0);
    for (int i = 1; i <= 20 && crossing.h_below < END; ++i)
        crossing = Crossing(crossing.s_below, crossing.h_below, float(i) / 20.0, tap_along(ray, float(i) / 20.0), i);
    if (GAPS == 0.0) return miss(0);
    Trace found = hit_on_ray(CHORD.s, 0);
    return hit_off_ray(point_on_ray(ray, found.s) + 0.01 * HEIGHT, 1.0 - found.s, 0);
}
)";
    const auto with = [&](const std::vector<std::pair<std::string, std::string>>& words) {
        std::string text = search;
        for (const auto& [word, replacement] : words)
            text.replace(text.find(word), word.size(), replacement);
        return text;
    };
    const TemporaryFolder root;
    const Technique first = technique_of(
        root, "first", 1,
        with({{"RAY",
               "ReliefRay ray = ReliefRay(pixel.uv, pixel.max_offset, pixel.to_eye, pixel.height, pixel.uv_dx, "
               "pixel.uv_dy, pixel.level);"},
              {"END", "1.0 - crossing.s_below"},
              {"GAPS", "gap_above(crossing) + gap_below(crossing)"},
              {"CHORD", "refine_linearly(crossing)"},
              {"HEIGHT", "(ray.height * ray.to_eye.xy)"}}));
    const Technique second = technique_of(root, "second", 2,
                                          with({{"RAY", "ReliefRay ray = pixel;"},
                                                {"END", "height_of_ray(ray, crossing.s_below)"},
                                                {"GAPS", "gap_above(ray, crossing) + gap_below(ray, crossing)"},
                                                {"CHORD", "refine_linearly(ray, crossing)"},
                                                {"HEIGHT", "(ray.height_scale * ray.uv_per_length * ray.to_eye.xy)"}}));
    expect_same_hits(first, second);
}

TEST_F(Contracts, TheSecondHasNoMembersOfTheFirst) {
    const TemporaryFolder root;
    const CoordinateScene scene(device(), procedural("cobbles", {8, 8}));
    for (const std::string member : {"height", "max_offset.x"}) {
        const Technique technique =
            technique_of(root, "mixed", 2, "Trace trace(ReliefRay ray) { return hit_on_ray(ray." + member + ", 0); }");
        EXPECT_THAT(error_message([&] {
                        compare_with_truth(device(), technique, technique.manifest.defaults(), scene,
                                           parallel_view(30));
                    }),
                    testing::HasSubstr(member.substr(0, member.find('.'))));
    }
}

}  // namespace
}  // namespace reliefbench::test
