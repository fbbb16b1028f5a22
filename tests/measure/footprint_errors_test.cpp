// Image errors over the footprint have no floor that an exact technique cannot pass; those of the whole picture have.

#include "measure/laboratory.hpp"
#include "measure/motion.hpp"
#include "technique/test_scene.hpp"

#include <gtest/gtest.h>

namespace reliefbench {
namespace {

struct SteepView {
    const char* height_map;
    double view_angle;
};

class FootprintErrors : public test::DeviceTest {
protected:
    CellResult measure(const std::string& technique, const ParameterValues& parameters, const std::string& height_map,
                       double view_angle, Boundary boundary) {
        Cell cell;
        cell.technique = technique;
        cell.id = technique;
        const Manifest& manifest = library().get(technique).manifest;
        for (const auto& [name, value] : manifest.defaults())
            cell.parameters[name] = value;
        for (const auto& [name, value] : parameters)
            cell.parameters[name] = value;
        cell.view.height_map.name = height_map;
        cell.view.height_map.size = {128, 128};
        cell.view.view = test::make_view(view_angle, Projection::perspective, {160, 160});
        cell.view.view.relief.height_scale = 0.1;
        cell.view.view.relief.boundary = boundary;
        SharedInputs inputs(device(), configuration_.lighting, configuration_.truth);
        PreparedCell prepared = Laboratory(library(), configuration_, inputs, {}).make_ready(cell);
        EXPECT_EQ(prepared.result.reason, "");
        CellResult result = prepared.result;
        const MotionSubject subject{&*prepared.renderer, &result};
        measure_motion(inputs, cell.view, configuration_, {&subject, 1}, {});
        return result;
    }

    static const TechniqueLibrary& library() {
        static const TechniqueLibrary found = find_techniques({default_technique_root()});
        return found;
    }

    Configuration configuration_ = [] {
        Configuration configuration;
        configuration.motion = MotionSettings{.frames = 2, .degrees = 0.25};
        return configuration;
    }();
};

TEST_F(FootprintErrors, AnExactTechniqueHasNextToNoneWhateverLiesBeyondTheQuad) {
    const std::vector<std::pair<std::string, ParameterValues>> exact = {
        {"qdm", {{"leaf", std::string("exact")}, {"max_steps", std::int64_t{4096}}}}, {"max_mip", {}}};
    for (const auto& [technique, parameters] : exact) {
        for (const auto& [height_map, view_angle] : {SteepView{"rock", 70}, SteepView{"bricks", 85}}) {
            for (const Boundary boundary : {Boundary::clip, Boundary::repeat}) {
                const CellResult result = measure(technique, parameters, height_map, view_angle, boundary);
                const std::string what = technique + " on " + height_map;
                EXPECT_LT(value_of("image.footprint.flip", result).value(), 0.001) << what;
                EXPECT_GT(value_of("image.footprint.ssim", result).value(), 0.999) << what;
                EXPECT_LT(value_of("motion.flip.mean", result).value(), 0.001)
                    << what << ": motion is followed in the footprint alone";
                const double whole = value_of("image.flip", result).value();
                if (boundary == Boundary::clip) {
                    EXPECT_GT(whole, 0.05) << what << ": the floor of the whole picture";
                } else {
                    EXPECT_EQ(whole, value_of("image.footprint.flip", result)) << "there is nothing else";
                }
            }
        }
    }
}

TEST_F(FootprintErrors, ATechniqueThatIsWrongHasThem) {
    const CellResult flat = measure("flat", {}, "rock", 70, Boundary::clip);
    EXPECT_GT(value_of("image.footprint.flip", flat).value(), 0.05);
    EXPECT_LT(value_of("image.footprint.ssim", flat).value(), 0.9);
}

}  // namespace
}  // namespace reliefbench
