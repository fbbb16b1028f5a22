#include "verify_test.hpp"

#include "core/file.hpp"
#include "verify/conformance.hpp"
#include "verify/general_checks.hpp"
#include "verify/promise_checks.hpp"
#include "verify/worst_pixel.hpp"

#include <gmock/gmock.h>

namespace reliefbench::test {

namespace {

using testing::AllOf;
using testing::HasSubstr;

/// Checks that would compare nothing: none of them may pass.
class VacuousChecks : public VerifyTest {
protected:
    /// A technique of one file, with what the manifest says of it beside the parameters.
    Technique technique(const std::string& trace, const std::string& parameters = "",
                        const std::string& more = "") const {
        const std::filesystem::path folder = root_ / "techniques" / "mine";
        write_text_file(folder / "technique.json",
                        R"({"title": "Mine", "kind": "march", "citation": "none", "shape": "quad", "promises": [],
                            "parameters": [)" +
                            parameters + "]" + more + "}");
        write_text_file(folder / "trace.glsl", trace);
        return find_techniques({folder.parent_path()}).get("mine");
    }

    void SetUp() override {
        VerifyTest::SetUp();
        std::filesystem::create_directories(root_ / "techniques" / "mine");
    }

    static Check last_check(const Technique& technique, const std::function<void(CheckList&)>& body) {
        const std::vector<Check> checks = checks_until_failure(device(), technique, body);
        EXPECT_FALSE(checks.empty());
        return checks.empty() ? Check{} : checks.back();
    }

    static Check check_relief_order(const PromiseDeclaration& declaration) {
        return last_check(shipped("relief"), [&](CheckList& list) { check_order_1(list, declaration); });
    }

private:
    TemporaryFolder root_;
};

const char* const sample_count =
    R"({"name": "samples", "type": "integer", "default": 8, "range": [1, 4096], "help": "h"})";

/// Exact on the smooth map, whatever the samples: quadtree and all would be long, and a long march does.
const char* const exact_trace = R"(
Trace trace(ReliefRay ray) {
    float low = 0.0;
    float high = 1.0;
    for (int i = 0; i < 24; ++i) {
        float middle = 0.5 * (low + high);
        if (tap_height(point_on_ray(ray, middle)) < 1.0 - middle) low = middle; else high = middle;
    }
    return hit_on_ray(0.5 * (low + high), samples);
}
)";

TEST_F(VacuousChecks, HalvingsThatAreFixed) {
    for (const std::int64_t fixed : {0, 4}) {
        const Check check = check_relief_order(
            {Promise::order_1, {{"adaptive", false}, {"binary_steps", fixed}}, std::string("binary_steps")});
        EXPECT_FALSE(check.passed) << check.detail;
        EXPECT_THAT(check.detail, AllOf(HasSubstr("\"with\" fixes 'binary_steps'"), HasSubstr("leave it out")));
    }
}

TEST_F(VacuousChecks, ASampleCountThatIsFixed) {
    const Check check =
        check_relief_order({Promise::order_1, {{"adaptive", false}, {"max_steps", std::int64_t{64}}}, {}});
    EXPECT_FALSE(check.passed) << check.detail;
    EXPECT_THAT(check.detail, HasSubstr("\"with\" fixes 'max_steps'"));
}

TEST_F(VacuousChecks, HalvingsWithoutEffect) {
    const Check check = check_relief_order(
        {Promise::order_1, {{"adaptive", false}, {"refinement", std::string("none")}}, std::string("binary_steps")});
    EXPECT_FALSE(check.passed) << check.detail;
    EXPECT_THAT(check.detail, HasSubstr("'binary_steps', which the check varies (halvings), has no effect"));
}

TEST_F(VacuousChecks, HalvingsThatCannotBeLeftOut) {
    const Technique mine =
        technique(exact_trace,
                  std::string(sample_count) +
                      R"(, {"name": "halvings", "type": "integer", "default": 1, "range": [1, 8], "help": "h"})",
                  R"(, "sample_count": "samples")");
    const Check check = last_check(mine, [](CheckList& list) {
        check_order_1(list, {Promise::order_1, {}, std::string("halvings")});
    });
    EXPECT_FALSE(check.passed) << check.detail;
    EXPECT_THAT(check.detail, HasSubstr("must hold 0 and 1"));
}

TEST_F(VacuousChecks, ErrorsThatAreAtTheFloorFromTheStart) {
    const Technique mine = technique(exact_trace, sample_count, R"(, "sample_count": "samples")");
    for (const Promise promise : {Promise::order_1, Promise::order_2}) {
        const Check check = last_check(mine, [&](CheckList& list) { check_promise(list, {promise, {}, {}}); });
        EXPECT_EQ(check.name, to_string(promise));
        EXPECT_FALSE(check.passed) << check.detail;
        EXPECT_THAT(check.detail, HasSubstr("nothing to compare"));
    }
}

TEST_F(VacuousChecks, APictureWithNothingInIt) {
    const Technique mine = technique("Trace trace(ReliefRay ray) { return miss(0); }");
    for (const auto& body : {check_pictures, check_work}) {
        const Check check = last_check(mine, body);
        EXPECT_FALSE(check.passed) << check.name << ": " << check.detail;
        EXPECT_THAT(check.detail, HasSubstr("nothing to")) << check.name;
    }
    for (const Promise promise : {Promise::first_hit, Promise::conservative}) {
        const Check check = last_check(mine, [&](CheckList& list) { check_promise(list, {promise, {}, {}}); });
        EXPECT_FALSE(check.passed) << check.name << ": " << check.detail;
    }
}

TEST_F(VacuousChecks, AnAnswerOutOfRangeIsTheReasonOfEveryCheck) {
    const Technique mine = technique("Trace trace(ReliefRay ray) { return hit_on_ray(-0.5 - tap_height(ray.uv), 1); }");
    const auto promise = [](CheckList& list) { check_first_hit(list, {Promise::first_hit, {}, {}}); };
    for (const std::function<void(CheckList&)>& body :
         std::vector<std::function<void(CheckList&)>>{check_pictures, check_polygon, check_work, promise}) {
        const Check check = last_check(mine, body);
        EXPECT_FALSE(check.passed);
        EXPECT_THAT(check.detail, AllOf(HasSubstr("answered out of range"), HasSubstr("s = -"))) << check.name;
        ASSERT_TRUE(check.drawn) << check.name;
        EXPECT_TRUE(check.drawn->worst) << check.name;
    }
}

TEST_F(VacuousChecks, AFailureNamesItsWorstPixel) {
    // One pixel of the first circumstance's 96 × 96 is off by a quarter of the relief's depth.
    const BrokenCopy copy("qdm", "trace.glsl", "Trace trace(ReliefRay ray) {",
                          "Trace found_by_search(ReliefRay ray);\n"
                          "Trace trace(ReliefRay ray) {\n"
                          "    Trace found = found_by_search(ray);\n"
                          "    if (ivec2(gl_FragCoord.xy) == ivec2(40, 50)) found.s = abs(found.s - 0.25);\n"
                          "    return found;\n"
                          "}\n"
                          "Trace found_by_search(ReliefRay ray) {");
    const CoordinateScene scene(device(), procedural("rock", {64, 64}));
    const TruthComparison found = compare_with_truth(
        device(), copy.technique(), with_values(copy.technique().manifest, {{"leaf", std::string("exact")}}), scene,
        parallel_view(75, 20));
    EXPECT_EQ(worst_place(found, scene.map, parallel_view(75, 20), false), (PixelPlace{40, 50}));
}

}  // namespace

}  // namespace reliefbench::test
