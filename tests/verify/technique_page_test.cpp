// The exact technique of docs/adding_a_technique.md, as it stands there, and what a technique needs of its maps.

#include "core/file.hpp"
#include "scene/procedural.hpp"
#include "verify/conformance.hpp"
#include "verify_test.hpp"

#include <gmock/gmock.h>

namespace reliefbench::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// What stands between the next fence of that language from `at` on and its end.
std::string next_block(const std::string& page, const std::string& language, std::size_t at) {
    const std::string fence = "```" + language + "\n";
    const std::size_t begin = page.find(fence, at) + fence.size();
    return page.substr(begin, page.find("```", begin) - begin);
}

Technique technique_of_page(const TemporaryFolder& root, const std::function<std::string(std::string)>& change = {}) {
    const std::string page = read_text_file(fs::path(RELIEFBENCH_SOURCE_DIR) / "docs" / "adding_a_technique.md");
    const std::size_t at = page.find("**An exact technique from these.**");
    const fs::path folder = root.path() / "exact_walk";
    fs::create_directories(folder);
    const std::string manifest = next_block(page, "json", at);
    write_text_file(folder / "technique.json", change ? change(manifest) : manifest);
    write_text_file(folder / "trace.glsl", next_block(page, "glsl", at));
    return find_techniques({root.path()}).get("exact_walk");
}

using TechniquePage = VerifyTest;

TEST_F(TechniquePage, ItsExactTechniqueKeepsItsPromise) {
    const TemporaryFolder root;
    const Technique technique = technique_of_page(root);
    ASSERT_EQ(technique.manifest.promises.front().promise, Promise::first_hit);
    for (const char* map : {"spikes", "cobbles", "steps"}) {
        for (const double angle : {0.0, 45.0, 80.0}) {
            View view = angle == 45 ? perspective_view(angle, -67) : parallel_view(angle, 25);
            view.resolution = {48, 48};
            view.relief.tiling = angle == 80 ? 2 : 1;
            view.relief.boundary = angle == 0 ? Boundary::repeat : Boundary::clip;
            const CoordinateScene scene(device(), procedural(map, {24, 40}));
            const TruthComparison found =
                compare_with_truth(device(), technique, technique.manifest.defaults(), scene, view);
            ASSERT_GT(found.errors.compared, 100U) << map << ' ' << angle;
            EXPECT_LT(found.errors.uv_texels->p99, 0.02) << map << ' ' << angle;
            EXPECT_LE(found.errors.missed + found.errors.false_hits, 0.005) << map << ' ' << angle;
        }
    }
}

TEST_F(TechniquePage, AllThatVerifyDrawsIsAsTheTechniqueNeedsIt) {
    const TemporaryFolder root;
    const Technique technique = technique_of_page(root, [](std::string manifest) {
        const std::size_t at = manifest.find("\"promises\"");
        return manifest.substr(0, at) +
               R"("needs": {"map": ["untiled", "square", "power_of_two"]}, "sample_count": "max_cells",
            "promises": [{"promise": "first_hit"}, {"promise": "order_1"}]})";
    });
    std::size_t drawn = 0;
    std::size_t skipped = 0;
    for (const Check& check : verify_technique(device(), technique)) {
        if (check.skipped) {
            ++skipped;
            EXPECT_EQ(check.name, "order_1");
            EXPECT_THAT(check.detail, HasSubstr("here the boundary is repeat"));
            continue;
        }
        EXPECT_TRUE(check.passed) << check.name << ": " << check.circumstances << ": " << check.detail;
        if (!check.drawn) continue;
        ++drawn;
        const auto& [map, size, view] = check.drawn->where;
        EXPECT_EQ(size.width, size.height) << check.circumstances;
        EXPECT_TRUE(size.width == 128 || size.width == 64 || size.width == 32) << check.circumstances;
        EXPECT_EQ(view.relief.tiling, 1);
        EXPECT_EQ(view.relief.boundary, Boundary::clip);
    }
    EXPECT_EQ(skipped, 2U);
    EXPECT_GE(drawn, procedural_maps().size() * 4);
}

}  // namespace
}  // namespace reliefbench::test
