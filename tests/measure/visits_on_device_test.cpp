// The sampler and the renderer together, on a device with the validation layer on.

#include "measure/draw_subject.hpp"
#include "measure/rounds.hpp"
#include "technique/test_scene.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace reliefbench {
namespace {

class Visits : public test::DeviceTest, public testing::WithParamInterface<std::size_t> {};

TEST_P(Visits, TakeEverySampleWhateverIsInFlight) {
    const test::TemporaryTechnique folder(test::TemporaryTechnique::Files{{"trace.glsl", test::march_trace}});
    const Technique technique = folder.load();
    const HeightMap map = test::make_map({8, 8}, [](int x, int y) { return 0.1 * ((x + y) % 8); });
    const SceneOnDevice scene(device(), map, test::grey_albedo());
    SamplingSettings settings;
    settings.warm_up = 0;
    settings.minimum_pass_ms = 0;
    std::vector<Renderer> renderers;
    std::vector<DrawSubject> draws;
    std::vector<Subject*> subjects;
    for (const double view_angle : {0.0, 30.0, 60.0}) {
        const View view = test::make_view(view_angle, Projection::parallel, {32, 32});
        renderers.push_back(test::make_renderer(device(), technique, scene, view));
    }
    draws.reserve(renderers.size());
    for (Renderer& renderer : renderers) {
        draws.emplace_back(timer_of(renderer), settings);
        subjects.push_back(&draws.back());
    }
    std::size_t visits = 0;
    RoundCallbacks callbacks;
    callbacks.on_visit = [&visits](const Visit&) { ++visits; };
    callbacks.on_failure = [](std::size_t, const std::string& reason) { ADD_FAILURE() << reason; };
    const auto sampled = sample_in_rounds(subjects, *make_fixed_rule(4), {2, 1, GetParam()}, callbacks);
    EXPECT_EQ(visits, 12U);
    for (const SampledSubject& subject : sampled) {
        ASSERT_EQ(subject.samples.at(draw_pass).size(), 4U);
        for (const std::vector<double>& round : subject.samples.at(draw_pass)) {
            ASSERT_EQ(round.size(), 2U);
            EXPECT_GT(round[0], 0);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(InFlight, Visits, testing::Values(1, 2));

}  // namespace
}  // namespace reliefbench
