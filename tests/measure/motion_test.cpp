#include "measure/motion.hpp"

#include "core/error.hpp"
#include "measure/laboratory.hpp"
#include "technique/test_scene.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace reliefbench {
namespace {

class Motion : public test::DeviceTest {
protected:
    Motion() {
        configuration_.motion = MotionSettings{.frames = 4, .degrees = 0.5};
        view_.height_map.name = "rock";
        view_.height_map.size = {64, 64};
        view_.view = test::make_view(60, Projection::parallel, {96, 96});
        view_.view.relief.height_scale = 0.1;
    }

    /// Of shipped techniques.
    std::vector<CellResult> measure(const std::vector<std::pair<std::string, ParameterValues>>& cells) {
        static const TechniqueLibrary library = find_techniques({default_technique_root()});
        SharedInputs inputs(device(), configuration_.lighting, configuration_.truth);
        std::vector<Renderer> renderers;
        std::vector<CellResult> results(cells.size());
        renderers.reserve(cells.size());
        std::vector<MotionSubject> subjects;
        for (std::size_t cell = 0; cell < cells.size(); ++cell) {
            const auto& [technique, parameters] = cells[cell];
            renderers.push_back(test::make_renderer(device(), library.get(technique), inputs.map(view_).scene,
                                                    inputs.view(view_), configuration_.lighting, parameters));
            subjects.push_back({&renderers.back(), &results[cell]});
        }
        measure_motion(inputs, view_, configuration_, subjects, {});
        return results;
    }

    Configuration configuration_;
    ViewKey view_;
};

const std::vector<std::pair<std::string, ParameterValues>> coarse_to_exact{
    {"steep", {{"max_steps", std::int64_t{8}}, {"adaptive", false}}},
    {"pom", {{"max_steps", std::int64_t{64}}, {"adaptive", false}}},
    {"max_mip", {}},
};

TEST_F(Motion, RanksStairStepsAboveFineLayersAboveExactHits) {
    for (const Projection projection : {Projection::parallel, Projection::perspective}) {
        for (const Boundary boundary : {Boundary::clip, Boundary::repeat}) {
            view_.view.camera.projection = projection;
            view_.view.relief.boundary = boundary;
            const std::vector<CellResult> results = measure(coarse_to_exact);
            for (const CellResult& result : results) {
                const auto value = [&](const char* path) { return value_of(path, result).value(); };
                ASSERT_EQ(result.reason, "");
                EXPECT_GT(value("motion.compared"), 10 * value("motion.hit_once"));
                EXPECT_LE(value("motion.texels.mean"), value("motion.texels.p95"));
                EXPECT_LE(value("motion.texels.p95"), value("motion.texels.max"));
            }
            enum { coarse, fine, exact };
            const auto value = [&](const char* path, int cell) { return value_of(path, results.at(cell)).value(); };
            EXPECT_GT(value("motion.texels.mean", coarse), 4 * value("motion.texels.mean", fine));
            EXPECT_GT(value("motion.texels.mean", fine), 4 * value("motion.texels.mean", exact));
            EXPECT_GT(value("motion.flip.mean", coarse), 2 * value("motion.flip.mean", fine));
            EXPECT_GT(value("motion.flip.mean", fine), 2 * value("motion.flip.mean", exact));
            EXPECT_EQ(value("motion.unseen", coarse), value("motion.unseen", exact));
        }
    }
}

TEST_F(Motion, AHistoryMovesNoOtherFigure) {
    view_.view.resolution = {48, 48};
    const std::vector<CellResult> without = measure(coarse_to_exact);
    configuration_.motion->history_weight = 0.9;
    const std::vector<CellResult> with = measure(coarse_to_exact);
    for (std::size_t cell = 0; cell < without.size(); ++cell) {
        for (const FigureDeclaration& figure : figures()) {
            const std::optional<double> value = value_of(figure, with[cell]);
            if (figure.has_need(figure_needs::history)) {
                EXPECT_TRUE(value) << figure.path;
                EXPECT_FALSE(value_of(figure, without[cell])) << figure.path;
            } else {
                EXPECT_EQ(value, value_of(figure, without[cell])) << figure.path;
            }
        }
    }
}

TEST_F(Motion, TheHistoryOfAStillCameraConvergesToTheMeanOfItsFrames) {
    view_.view.resolution = {48, 48};
    configuration_.motion = MotionSettings{.frames = 48, .degrees = 0};
    for (const Projection projection : {Projection::parallel, Projection::perspective}) {
        view_.view.camera.projection = projection;
        std::vector<double> ghosting;
        std::vector<double> flicker;
        for (const double weight : {0.0, 0.8, 0.95}) {
            configuration_.motion->history_weight = weight;
            const CellResult result = measure({coarse_to_exact.front()}).front();
            ASSERT_EQ(result.reason, "");
            ghosting.push_back(value_of("motion.ghosting.mean", result).value());
            flicker.push_back(value_of("motion.history_flip.mean", result).value());
        }
        // Frames by themselves are as far from the mean as their samples scatter. Equal and independent ones leave
        // √((1 − weight) / (1 + weight)) of that: 0.33 and 0.16.
        EXPECT_GT(ghosting[0], 0.03);
        EXPECT_LT(ghosting[1], 0.4 * ghosting[0]);
        EXPECT_LT(ghosting[2], 0.2 * ghosting[0]);
        EXPECT_LT(flicker[1], 0.3 * flicker[0]);
        EXPECT_LT(flicker[2], 0.1 * flicker[0]);
    }
}

TEST_F(Motion, AHistoryGhostsAndTheClampTakesMostOfItAway) {
    configuration_.motion = MotionSettings{.frames = 12, .degrees = 1.5, .along = MotionSettings::Along::azimuth};
    view_.view.camera.projection = Projection::perspective;
    view_.view.relief.height_scale = 0.2;
    const auto ghosting = [&](double weight, bool clamp) {
        configuration_.motion->history_weight = weight;
        configuration_.motion->neighbourhood_clamp = clamp;
        return value_of("motion.ghosting.mean", measure({coarse_to_exact.back()}).front()).value();
    };
    const double kept = ghosting(0.9, false);
    EXPECT_LT(ghosting(0.9, true), 0.8 * kept);
    EXPECT_EQ(ghosting(0, true), ghosting(0, false)) << "each frame by itself";
}

TEST_F(Motion, OverACylinderHitsByBentRaysMoveAsTheTruthDoes) {
    configuration_.motion->frames = 2;
    view_.view.resolution = {48, 48};
    view_.base = {.kind = BaseSource::Kind::cylinder, .curvature = 1, .segments = 32};
    const ParameterValues bent{{"ray_model", std::string("quadric_uv")}};
    ParameterValues coarse = coarse_to_exact.front().second;
    coarse.insert(bent.begin(), bent.end());
    for (const Projection projection : {Projection::parallel, Projection::perspective}) {
        view_.view.camera.projection = projection;
        const std::vector<CellResult> results = measure({{"steep", coarse}, {"max_mip", bent}});
        const auto value = [&](const char* path, int cell) { return value_of(path, results.at(cell)).value(); };
        for (int cell = 0; cell < 2; ++cell) {
            ASSERT_EQ(results.at(cell).reason, "");
            EXPECT_GT(value("motion.compared", cell), 300);
        }
        // What the curvature's second order leaves.
        EXPECT_LT(value("motion.texels.mean", 1), 0.1);
        EXPECT_GT(value("motion.texels.mean", 0), 2 * value("motion.texels.mean", 1));
        EXPECT_LT(value("motion.hit_once", 1), 0.05 * value("motion.compared", 1));
    }
}

TEST_F(Motion, ATruthThatCannotBeTracedFailsItsCellsAndNothingElse) {
    SharedInputs inputs(device(), configuration_.lighting, configuration_.truth);
    const Technique flat = find_techniques({default_technique_root()}).get("flat");
    Renderer renderer =
        test::make_renderer(device(), flat, inputs.map(view_).scene, view_.view, configuration_.lighting, {});
    ViewKey missing = view_;
    missing.height_map.name = "missing.png";
    CellResult result;
    const MotionSubject subject{&renderer, &result};
    measure_motion(inputs, missing, configuration_, {&subject, 1}, {});
    EXPECT_EQ(result.status, CellStatus::failed);
    EXPECT_NE(result.reason.find("missing.png"), std::string::npos) << result.reason;
    EXPECT_FALSE(value_of("motion.texels.mean", result));
}

}  // namespace
}  // namespace reliefbench
