#include "verify_test.hpp"

#include "gpu/loop_limit.hpp"
#include "verify/conformance.hpp"
#include "verify/general_checks.hpp"
#include "verify/promise_checks.hpp"

namespace reliefbench::test {

namespace {

/// Each copy of a shader is wrong in one place; the check named must find it.
class BrokenCopies : public VerifyTest {
protected:
    static void expect_failure(const BrokenCopy& copy, const std::string& check,
                               const std::function<void(CheckList&)>& body) {
        const std::vector<Check> checks = checks_until_failure(device(), copy.technique(), body);
        ASSERT_FALSE(checks.empty());
        EXPECT_FALSE(checks.back().passed) << "a broken copy of " << copy.technique().manifest.id << " passed "
                                           << checks.size() << " checks, the last: " << checks.back().detail;
        EXPECT_EQ(checks.back().name, check) << checks.back().detail;
    }

    static void expect_broken_promise(const BrokenCopy& copy, Promise promise) {
        const Manifest& manifest = copy.technique().manifest;
        for (const PromiseDeclaration& declaration : manifest.promises) {
            if (declaration.promise != promise) continue;
            expect_failure(copy, to_string(promise), [&](CheckList& list) { check_promise(list, declaration); });
            return;
        }
        FAIL() << manifest.id << " does not promise " << to_string(promise);
    }
};

}  // namespace

TEST_F(BrokenCopies, Order1FindsHalfAStepTooFar) {
    expect_broken_promise(BrokenCopy("steep", "trace.glsl", "hit_on_ray(refined.s,",
                                     "hit_on_ray(1.5 * crossing.s_below - 0.5 * crossing.s_above,"),
                          Promise::order_1);
}

TEST_F(BrokenCopies, Order1FindsSwappedHalvesOfTheBinarySearch) {
    expect_broken_promise(
        BrokenCopy("relief", "refinement.glsl", "< height_of_ray(ray, middle))", ">= height_of_ray(ray, middle))"),
        Promise::order_1);
}

TEST_F(BrokenCopies, Order1FindsAMissingHalving) {
    expect_broken_promise(BrokenCopy("relief", "refinement.glsl", "i < halvings", "i < halvings - 1"),
                          Promise::order_1);
}

TEST_F(BrokenCopies, Order1FindsTheEndOfTheLastIntervalInPlaceOfItsMiddle) {
    expect_broken_promise(
        BrokenCopy("relief", "refinement.glsl", "0.5 * (s_above + s_below);\n#endif", "s_below;\n#endif"),
        Promise::order_1);
}

TEST_F(BrokenCopies, Order1FindsAMapShiftedByHalfATexel) {
    expect_broken_promise(
        BrokenCopy("steep", "march.glsl", ": tap_height(uv)", ": tap_height(uv + 0.5 / vec2(height_map_size()))"),
        Promise::order_1);
}

TEST_F(BrokenCopies, Order2FindsHalfAStepTooFar) {
    expect_broken_promise(
        BrokenCopy("pom", "refinement.glsl", "crossing.s_below, fraction)", "crossing.s_below, fraction + 0.5)"),
        Promise::order_2);
}

TEST_F(BrokenCopies, Order2FindsTheMiddleOfTheLayerInPlaceOfTheIntersection) {
    expect_broken_promise(BrokenCopy("pom", "refinement.glsl", "? above / (above + below) : 0.0", "? 0.5 : 0.0"),
                          Promise::order_2);
}

TEST_F(BrokenCopies, Order2FindsAChordCutFromTheWrongEnd) {
    expect_broken_promise(BrokenCopy("secant", "refinement.glsl", "crossing.s_below, above / (above + below));",
                                     "crossing.s_below, below / (above + below));"),
                          Promise::order_2);
}

TEST_F(BrokenCopies, Order2FindsAContactThatIsNotMarchedAgain) {
    expect_broken_promise(
        BrokenCopy("contact_refinement", "refinement.glsl", "level < levels &&", "level < levels - 1 &&"),
        Promise::order_2);
}

TEST_F(BrokenCopies, Order1FindsAFinerMarchThatSkipsItsFirstStep) {
    expect_broken_promise(BrokenCopy("contact_refinement", "refinement.glsl", "for (int i = 1; i < finer_steps",
                                     "for (int i = 2; i < finer_steps"),
                          Promise::order_1);
}

TEST_F(BrokenCopies, FirstHitFindsNodesSkippedByTheirEntry) {
    expect_broken_promise(
        BrokenCopy("qdm", "quadtree_walk.glsl", "if (height_of_ray(ray.relief, walk.node.exit) < top)",
                   "if (height_of_ray(ray.relief, walk.place.s) < top)"),
        Promise::first_hit);
}

TEST_F(BrokenCopies, FirstHitFindsATraversalThatSkipsWhatIsBehindTheWall) {
    expect_broken_promise(BrokenCopy("qdm", "cell_walk.glsl", "    ivec2 wrapped = ",
                                     "    beyond += ivec2(ray.forward) * ivec2(lessThan(beyond + 1, ray.size));\n"
                                     "    ivec2 wrapped = "),
                          Promise::first_hit);
}

TEST_F(BrokenCopies, FirstHitFindsAnAscentThatForgetsTheCell) {
    expect_broken_promise(BrokenCopy("qdm", "quadtree_walk.glsl", "bool new_parent = (walk.place.cell",
                                     "walk.place.cell = (walk.place.cell >> 1) << 1;\n"
                                     "    bool new_parent = (walk.place.cell"),
                          Promise::first_hit);
}

TEST_F(BrokenCopies, FirstHitFindsAMapShiftedByHalfATexel) {
    expect_broken_promise(BrokenCopy("qdm", "trace.glsl", "vec2(height_map_size()) - 0.5;", "vec2(height_map_size());"),
                          Promise::first_hit);
}

TEST_F(BrokenCopies, FirstHitFindsACapThatEndsSearches) {
    expect_broken_promise(BrokenCopy("qdm", "technique.json", "\"default\": 4096", "\"default\": 16"),
                          Promise::first_hit);
}

TEST_F(BrokenCopies, ConservativeFindsTheFarWallInPlaceOfTheHit) {
    expect_broken_promise(BrokenCopy("qdm", "trace.glsl", "mix(walk.place.s, walk.node.exit, fraction)",
                                     "mix(walk.place.s, walk.node.exit, 1.0)"),
                          Promise::conservative);
}

TEST_F(BrokenCopies, ConservativeFindsATreeWithoutTheCellsFarCorners) {
    expect_broken_promise(
        BrokenCopy("qdm", "prepare_cell_maximum.glsl", "cell_maximum(texel)", "tap_height_texel(texel)"),
        Promise::conservative);
}

TEST_F(BrokenCopies, FirstHitFindsABoxEnteredOneLevelTooHigh) {
    expect_broken_promise(
        BrokenCopy("max_mip", "quadtree_walk.glsl", "if (height_of_ray(ray.relief, walk.node.exit) < top)",
                   "if (height_of_ray(ray.relief, 0.5 * (walk.place.s + walk.node.exit)) < top)"),
        Promise::first_hit);
}

TEST_F(BrokenCopies, FirstHitFindsMaximumMipmapsOverThreeOfFourNodes) {
    expect_broken_promise(BrokenCopy("max_mip", "prepare_node_maximum.glsl", "node_maximum(node)",
                                     "max(max(previous_level(2 * node).r, previous_level(2 * node + ivec2(1, 0)).r), "
                                     "previous_level(2 * node + ivec2(0, 1)).r)"),
                          Promise::first_hit);
}

TEST_F(BrokenCopies, ConservativeFindsBoxesPassedThroughToTheirFarWall) {
    expect_broken_promise(BrokenCopy("max_mip", "quadtree_walk.glsl", "max(walk.place.s, s_at_height(ray.relief, top))",
                                     "0.5 * (walk.place.s + walk.node.exit)"),
                          Promise::conservative);
}

TEST_F(BrokenCopies, ConservativeFindsDistancesNotReducedByTheVoxel) {
    expect_broken_promise(
        BrokenCopy("distance_map", "surface_distances.glsl", "nearest - 0.5 * length(voxel)", "nearest"),
        Promise::conservative);
}

TEST_F(BrokenCopies, ConservativeFindsStepsAlongTheHeightAlone) {
    expect_broken_promise(
        BrokenCopy("distance_map", "trace.glsl", "length(vec3(straight_offset(ray), metric_height))", "metric_height"),
        Promise::conservative);
}

TEST_F(BrokenCopies, ConservativeFindsConesThatHoldAtTexelsOnly) {
    expect_broken_promise(
        BrokenCopy("robust_cone", "store.glsl", "narrowest_around(ratios, texel)", "tap_map_texel(ratios, texel, 0).r"),
        Promise::conservative);
}

TEST_F(BrokenCopies, ConservativeFindsStepsBeyondTheCone) {
    expect_broken_promise(
        BrokenCopy("robust_cone", "cone_march.glsl", "start.gap * start.cone.y /", "2.0 * start.gap * start.cone.y /"),
        Promise::conservative);
}

TEST_F(BrokenCopies, ConservativeFindsConesBeyondTheFarSideOfANode) {
    expect_broken_promise(BrokenCopy("robust_cone", "quick_cone.glsl", "span.low - texel, texel - span.high",
                                     "2 * (span.high - texel), 2 * (texel - span.low)"),
                          Promise::conservative);
}

TEST_F(BrokenCopies, TimedAndProbedMustAgree) {
    const BrokenCopy copy("steep", "trace.glsl", "    return hit_on_ray(refined.s, refined.steps);",
                          "#ifndef RELIEFBENCH_PROBED\n"
                          "    return hit_on_ray(0.5 * (crossing.s_above + crossing.s_below), crossing.steps);\n"
                          "#endif\n"
                          "    return hit_on_ray(refined.s, refined.steps);");
    expect_failure(copy, "timed and probed agree", check_pictures);
}

TEST_F(BrokenCopies, TimedAndProbedMustCoverTheSamePixels) {
    const BrokenCopy copy("steep", "trace.glsl", "    return hit_on_ray(refined.s, refined.steps);",
                          "#ifdef RELIEFBENCH_PROBED\n"
                          "    if (crossing.steps > 6) return miss(crossing.steps);\n"
                          "#endif\n"
                          "    return hit_on_ray(refined.s, refined.steps);");
    expect_failure(copy, "timed and probed agree", check_pictures);
}

TEST_F(BrokenCopies, HitsMustBeFinite) {
    const BrokenCopy copy("pom", "refinement.glsl", "above + below > 0.0 ? above / (above + below) : 0.0",
                          "(above - above) / (below - below)");
    const std::vector<Check> checks = checks_until_failure(device(), copy.technique(), check_pictures);
    EXPECT_FALSE(checks.back().passed);
}

TEST_F(BrokenCopies, HitsMustStayInTheRelief) {
    const BrokenCopy copy("parallax", "trace.glsl", "depth * full_offset, h, 1)", "depth * full_offset, h + 0.5, 1)");
    // The first check that draws it: no picture of such a draw is judged.
    expect_failure(copy, "timed and probed agree", check_pictures);
}

/// The listing of Luna 2012, section 6, pairs the tap at the entry with the ray one layer down.
TEST_F(BrokenCopies, AMapOfOnesMustBeThePolygon) {
    const BrokenCopy copy("pom", "trace.glsl", "hit_on_ray(refined.s,", "hit_on_ray(refined.s + 1.0 / 50.0,");
    expect_failure(copy, "a map of ones is the polygon", check_polygon);
}

TEST_F(BrokenCopies, TapsMustBeCounted) {
    const BrokenCopy copy("parallax", "taps.glsl", "    count_tap(4u);\n    return textureLod(height_map",
                          "    return textureLod(height_map");
    expect_failure(copy, "work is counted", check_work);
}

/// One tap is counted, and another one is not.
TEST_F(BrokenCopies, NoTapMayBeHiddenBesideOthers) {
    const BrokenCopy copy("parallax", "trace.glsl", "float h = tap_height(ray.uv);",
                          "float h = 0.5 * tap_height(ray.uv);\n    h += 0.5 * textureLod(height_map, ray.uv, 0.0).r;");
    const std::vector<Check> checks = verify_technique(device(), copy.technique());
    ASSERT_EQ(checks.size(), 1U);
    EXPECT_FALSE(checks.front().passed);
    EXPECT_NE(checks.front().detail.find("trace.glsl:4: this fetch would count as no tap"), std::string::npos)
        << checks.front().detail;
}

TEST_F(BrokenCopies, LoopsMustNotBeCutByTheDevice) {
    if (!gpu::loop_limit(device())) GTEST_SKIP() << "the device ends no loops";
    const BrokenCopy copy("parallax", "trace.glsl", "float h = tap_height(ray.uv);",
                          "float h = tap_height(ray.uv);\n"
                          "    for (int n = 0; n >= 0;) { n = (n + 1) & 1023; h = max(h, 1e-9 * float(n)); }");
    expect_failure(copy, "work is counted", check_work);
}

TEST_F(BrokenCopies, AShaderThatDoesNotCompileIsAFailedCheck) {
    const BrokenCopy copy("steep", "trace.glsl", "Crossing crossing", "Crossing crossing =");
    const std::vector<Check> checks = verify_technique(device(), copy.technique());
    ASSERT_EQ(checks.size(), 1U);
    EXPECT_FALSE(checks.front().passed);
    EXPECT_NE(checks.front().detail.find("trace.glsl"), std::string::npos) << checks.front().detail;
}

}  // namespace reliefbench::test
