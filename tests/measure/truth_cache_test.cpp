#include "measure/truth_cache.hpp"

#include "core/file.hpp"
#include "measure/device_cells.hpp"
#include "measure/run.hpp"
#include "reference/stored_truth.hpp"
#include "support/temporary_folder.hpp"
#include "sweep/view_axes.hpp"
#include "technique/test_scene.hpp"

#include <gmock/gmock.h>

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace reliefbench {
namespace {

namespace fs = std::filesystem;

/// The key of a view's truth, whose map, albedo and base are loaded as those of cells are.
std::string key_of(const ViewKey& key, const Lighting& lighting = {}, const TruthSettings& settings = {},
                   const std::optional<SceneObject>& object = {}) {
    const HeightMap map = load_height_map(key.height_map, key.height_format);
    const std::string albedo = content_of(load_albedo(key.height_map, map));
    View view = key.view;
    view.relief.base = load_base(key.base);
    return cache_key({map, albedo, view, lighting, settings, object});
}

ViewKey view_with(const std::map<std::string, Json>& values) {
    std::vector<ViewSetting> settings;
    std::vector<const ViewAxis*> axes;
    settings.reserve(values.size());
    for (const auto& [name, value] : values) {
        axes.push_back(find_view_axis(name));
        settings.push_back(axes.back()->read(JsonView(value, "test")));
    }
    std::vector<ViewChoice> choices;
    for (std::size_t i = 0; i < axes.size(); ++i)
        choices.push_back({axes[i], &settings[i]});
    return make_view(choices);
}

TEST(TruthCache, EveryAxisThatMovesHitsIsOfTheKey) {
    const std::map<std::string, Json> usual{
        {"heightmap", "rock"}, {"heightmap_size", 16}, {"base", "cylinder"}, {"base_segments", 4}};
    const std::map<std::string, Json> others{{"heightmap", "bricks"},
                                             {"heightmap_size", 17},
                                             {"height_format", "r8"},
                                             {"resolution", 33},
                                             {"view_angle", 41},
                                             {"azimuth", -41},
                                             {"projection", "parallel"},
                                             {"distance", 3},
                                             {"fov", 30},
                                             {"height_scale", 0.07},
                                             {"tiling", 2},
                                             {"boundary", "repeat"},
                                             {"base", "sphere"},
                                             {"curvature", -0.5},
                                             {"base_segments", 5},
                                             {"albedo", ""},
                                             {"base_fit", "none"},
                                             {"polygon_height", 0.5}};
    std::set<std::string> keys{key_of(view_with(usual))};
    std::size_t expected = 1;
    for (const ViewAxis& axis : view_axes()) {
        if (!axis.moves_hits) continue;
        ASSERT_TRUE(others.contains(axis.name)) << axis.name << " moves hits: give it a value here";
        // Of files, whose content is hashed.
        if (axis.name == "albedo" || axis.name == "base_fit") continue;
        std::map<std::string, Json> changed = usual;
        changed[axis.name] = others.at(axis.name);
        keys.insert(key_of(view_with(changed)));
        ++expected;
        EXPECT_EQ(keys.size(), expected) << axis.name;
    }
}

TEST(TruthCache, WhatAPictureIsMadeWithIsOfTheKey) {
    const ViewKey view = view_with({{"heightmap", "rock"}, {"heightmap_size", 16}});
    std::set<std::string> keys{key_of(view)};
    const auto expect_new = [&](const std::string& key, const char* what) {
        EXPECT_TRUE(keys.insert(key).second) << what;
    };
    Lighting lighting;
    lighting.shininess = 31;
    expect_new(key_of(view, lighting), "shininess");
    lighting = {};
    lighting.lights[0].angular_radius = 1;
    expect_new(key_of(view, lighting), "angular radius");
    lighting = {};
    lighting.fog = Fog{};
    expect_new(key_of(view, lighting), "fog");
    expect_new(key_of(view, {}, {.samples = 2}), "samples");
    expect_new(key_of(view, {}, {.kind = TruthSettings::Kind::mesh}), "kind");
    expect_new(key_of(view, {}, {.kind = TruthSettings::Kind::mesh, .subdivision = 2}), "subdivision");
    expect_new(key_of(view, {}, {}, SceneObject{}), "object");
    for (const SelfShadow::Mode mode : {SelfShadow::Mode::hard, SelfShadow::Mode::soft}) {
        ViewKey shadowed = view;
        shadowed.view.self_shadow.mode = mode;
        expect_new(key_of(shadowed), "shadows");
    }
    ViewKey shifted = view;
    shifted.view.camera.shift = {0.01, 0};
    expect_new(key_of(shifted), "shift");
    EXPECT_EQ(key_of(view, {}, {.subdivision = 2}), key_of(view)) << "of meshes alone";
}

class CachedTruths : public test::DeviceTest {
protected:
    CachedTruths() {
        view_ = view_with({{"heightmap", "rock"}, {"heightmap_size", 16}, {"resolution", 24}, {"view_angle", 60}});
    }

    SharedInputs inputs() const { return {device(), {}, {.samples = 4}, SceneObject{}, folder_.path()}; }

    const TemporaryFolder folder_;
    ViewKey view_;
};

TEST_F(CachedTruths, AreReadBitForBit) {
    SharedInputs first = inputs();
    const std::string traced = stored_truth(first.truth(view_));
    Camera moved = view_.view.camera;
    moved.view_angle -= 1;
    const std::string in_motion = stored_truth(first.truth_from(view_, moved));
    EXPECT_EQ(first.truths().traced, 2U);
    EXPECT_EQ(first.truths().cached, 0U);
    SharedInputs second = inputs();
    EXPECT_TRUE(stored_truth(second.truth(view_)) == traced);
    EXPECT_TRUE(stored_truth(second.truth_from(view_, moved)) == in_motion);
    EXPECT_EQ(second.truths().traced, 0U);
    EXPECT_EQ(second.truths().cached, 2U);
    EXPECT_GT(second.truths().seconds, 0);
}

TEST_F(CachedTruths, ADamagedOneIsTracedAnew) {
    const std::string traced = stored_truth(inputs().truth(view_));
    const fs::path file = fs::directory_iterator(folder_.path())->path();
    std::string bytes = read_text_file(file);
    bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 1);
    write_text_file(file, bytes);
    SharedInputs second = inputs();
    EXPECT_TRUE(stored_truth(second.truth(view_)) == traced);
    EXPECT_EQ(second.truths().traced, 1U);
    SharedInputs third = inputs();
    third.truth(view_);
    EXPECT_EQ(third.truths().cached, 1U) << "and cached again";
}

TEST_F(CachedTruths, OfAMapByAnotherNameAreTheSame) {
    const HeightMap map = load_height_map(view_.height_map, view_.height_format);
    std::string raw;
    for (int row = map.height(); row-- > 0;) {
        for (int column = 0; column < map.width(); ++column) {
            const float height = map.texel(column, row);
            raw.append(reinterpret_cast<const char*>(&height), sizeof height);
        }
    }
    inputs().truth(view_);
    for (const char* name : {"one.raw", "two.raw"}) {
        const TemporaryFolder maps;
        write_text_file(maps / name, raw);
        ViewKey key = view_;
        key.height_map = {};
        key.height_map.name = (maps / name).string();
        key.height_map.raw = RawLayout{.size = map.heights.size, .sample_type = RawLayout::SampleType::float32};
        SharedInputs other = inputs();
        other.truth(key);
        EXPECT_EQ(other.truths().cached, 1U) << name;
    }
}

TEST_F(CachedTruths, ASecondRunOfASweepTracesNone) {
    const TechniqueLibrary library = find_techniques({default_technique_root()});
    const Json json = Json::parse(R"({
        "name": "twice", "techniques": ["flat", "qdm"], "truth": {"samples": 2}, "motion": {"frames": 3},
        "axes": {"heightmap": "rock", "heightmap_size": 16, "resolution": "8x8", "view_angle": [0, 60],
                 "base": ["plane", "cylinder"], "base_segments": 4},
        "sampling": {"rule": "fixed", "rounds": 1, "samples_per_visit": 1, "warm_up": 0, "minimum_pass_ms": 0}})");
    const Configuration configuration = parse_configuration(json, "test", {}, library.manifests());
    const std::vector<Cell> cells = expand(configuration, library.manifests());
    std::vector<TruthWork> work;
    for (const char* name : {"first", "second"}) {
        RunWriter writer(folder_ / name, Json::object());
        DeviceCells on_device(device(), library, configuration, cells, writer, {.cache = folder_ / "cache"});
        const RunOutcome outcome = run_cells(on_device, configuration, cells, writer, {}, steady_clock(), {});
        EXPECT_EQ(outcome.tally.ok, cells.size());
        work.push_back(outcome.split.truths);
    }
    EXPECT_GT(work[0].traced, 4U) << "those in motion, too";
    EXPECT_EQ(work[0].cached, 0U);
    EXPECT_EQ(work[1].traced, 0U);
    EXPECT_EQ(work[1].cached, work[0].traced);
}

}  // namespace
}  // namespace reliefbench
