#include "verify_test.hpp"

namespace reliefbench::test {

namespace {

using Cap = VerifyTest;

std::uint32_t unconverged(const Probe& probe) {
    std::uint32_t count = 0;
    for (const PixelWork& work : probe.work.texels)
        count += work.unconverged;
    return count;
}

}  // namespace

/// At 88° and this depth most rays leave the patch without a hit, and are then followed over its repeats until the cap:
/// what they would find there is none of the clipped relief.
TEST_F(Cap, RaysThatHaveLeftAClippedPatchAreNotUnconverged) {
    const CoordinateScene scene(device(), procedural("rock", {64, 64}));
    View clipped = parallel_view(88, -70);
    clipped.relief.height_scale = 0.5;
    View repeated = clipped;
    repeated.relief.boundary = Boundary::repeat;
    for (const std::string technique : {"qdm", "max_mip", "robust_cone"}) {
        const ParameterValues capped{{"max_steps", std::int64_t{48}}};
        const TruthComparison found = compare(technique, capped, scene, clipped);
        ASSERT_TRUE(found.errors.uv_texels) << technique;
        EXPECT_LT(found.errors.uv_texels->p99, 0.01) << technique;
        EXPECT_EQ(unconverged(found.probe), 0U) << technique;
        EXPECT_GT(unconverged(compare(technique, capped, scene, repeated).probe), 100U) << technique;
    }
}

}  // namespace reliefbench::test
