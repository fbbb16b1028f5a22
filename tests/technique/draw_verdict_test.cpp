#include "technique/draw_verdict.hpp"

#include "test_scene.hpp"

#include <gmock/gmock.h>

namespace reliefbench {
namespace {

using testing::HasSubstr;

class DrawVerdictTest : public test::DeviceTest {
protected:
    /// Of a draw of `covered` pixels of four, of which the first so many did not converge.
    static Probe draw(std::size_t covered, std::size_t unconverged) {
        const Resolution size{4, 1};
        Probe probe;
        probe.hits = HitImage(size);
        probe.covered = Image<std::uint8_t>(size);
        probe.work = Image<PixelWork>(size);
        for (std::size_t pixel = 0; pixel < covered; ++pixel)
            probe.covered.texels[pixel] = 1;
        for (std::size_t pixel = 0; pixel < unconverged; ++pixel)
            probe.work.texels[pixel].unconverged = 1;
        return probe;
    }

    static DrawVerdict judge(const Probe& probe) { return judge_draw(device(), Manifest{}, {}, probe); }
};

TEST_F(DrawVerdictTest, MoreThanHalfOfTheCoveredPixelsUnconvergedIsNotTheTechniques) {
    EXPECT_EQ(judge(draw(4, 2)).reason, "");
    EXPECT_THAT(judge(draw(4, 3)).reason, HasSubstr("75 % of its pixels left their loop"));
    EXPECT_THAT(judge(draw(3, 2)).reason, HasSubstr("67 %")) << "uncovered pixels do not count";
    EXPECT_FALSE(judge(draw(4, 4)).is_meaningless) << "its figures show what is wrong";
    EXPECT_EQ(judge(draw(0, 0)).reason, "") << "nothing drawn is nothing wrong";
}

TEST_F(DrawVerdictTest, AnswersOutOfRangeComeFirst) {
    Probe probe = draw(4, 4);
    probe.faults = {{AnswerFault::Quantity::s, 1.5, PixelPlace{2, 0}},
                    {AnswerFault::Quantity::s, -3, PixelPlace{1, 0}}};
    const DrawVerdict verdict = judge(probe);
    EXPECT_THAT(verdict.reason, HasSubstr("s = -3 at pixel (1, 0)"));
    EXPECT_TRUE(verdict.is_meaningless);
    EXPECT_EQ(verdict.worst, (PixelPlace{1, 0}));
}

TEST_F(DrawVerdictTest, LoopsThatTheDeviceEndedComeBeforeSearchesThatTheTechniqueEnded) {
    Probe probe = draw(4, 4);
    probe.work.texels[0].cut = true;
    const DrawVerdict verdict = judge(probe);
    EXPECT_THAT(verdict.reason, HasSubstr("the device ended the loops of 25 % of the pixels"));
    EXPECT_FALSE(verdict.is_meaningless);
}

}  // namespace
}  // namespace reliefbench
