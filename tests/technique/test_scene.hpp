#pragma once

#include "core/file.hpp"
#include "gpu/device.hpp"
#include "gpu/shader_cache.hpp"
#include "scene/albedo.hpp"
#include "scene/height_map.hpp"
#include "support/temporary_folder.hpp"
#include "technique/renderer.hpp"
#include "technique/technique.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <map>
#include <string>

namespace reliefbench::test {

/// One device for all tests of this executable: opening one costs more than most tests. Every test ends with a look at
/// what the validation layer said.
class DeviceTest : public testing::Test {
protected:
    static void SetUpTestSuite() {
        if (!shared_device())
            shared_device() = std::make_unique<gpu::Device>(gpu::DeviceOptions{.choice = "", .validation = true});
    }

    void SetUp() override { messages_before_ = device().validation_messages().size(); }

    void TearDown() override {
        const std::vector<std::string> messages = device().validation_messages();
        for (std::size_t i = messages_before_; i < messages.size(); ++i)
            ADD_FAILURE() << messages[i];
    }

    static const gpu::Device& device() { return *shared_device(); }

    static std::unique_ptr<gpu::Device>& shared_device() {
        static std::unique_ptr<gpu::Device> device;
        return device;
    }

private:
    std::size_t messages_before_ = 0;
};

inline const char* const shortest_manifest =
    R"({"title": "Test", "kind": "march", "citation": "none", "promises": [], "shape": "quad", "parameters": []})";

/// A technique folder that lives as long as the object.
class TemporaryTechnique {
public:
    using Files = std::map<std::string, std::string>;

    /// Files by name; technique.json gets what is not given.
    explicit TemporaryTechnique(const Files& files) {
        static int count = 0;
        folder_ = root_ / ("technique_" + std::to_string(++count));
        std::filesystem::create_directories(folder_);
        for (const auto& [file, text] : files)
            write_text_file(folder_ / file, text);
        if (!files.contains("technique.json")) write_text_file(folder_ / "technique.json", shortest_manifest);
    }

    Technique load() const { return find_techniques({root()}).get(folder_.filename().string()); }
    const std::filesystem::path& folder() const { return folder_; }
    /// Holds the folder and nothing else.
    const std::filesystem::path& root() const { return root_.path(); }

private:
    TemporaryFolder root_;
    std::filesystem::path folder_;
};

inline HeightMap make_map(Resolution size, const std::function<double(int x, int y)>& height,
                          HeightFormat format = HeightFormat::r16) {
    Image<float> heights(size);
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x)
            heights.at(x, y) = static_cast<float>(height(x, y));
    }
    return make_height_map(heights, format, "test");
}

/// One float texel for each texel of the map.
inline Albedo make_albedo(Resolution size, const std::function<std::array<float, 4>(int x, int y)>& colour) {
    Albedo albedo;
    albedo.format = Albedo::Format::float32;
    albedo.texels = Image<std::array<float, 4>>(size);
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x)
            albedo.texels.at(x, y) = colour(x, y);
    }
    return albedo;
}

inline Albedo grey_albedo() {
    return make_albedo({1, 1}, [](int, int) { return std::array<float, 4>{0.5f, 0.5f, 0.5f, 1}; });
}

inline View make_view(double view_angle, Projection projection, Resolution resolution = {64, 64}) {
    View view;
    view.camera.projection = projection;
    view.camera.view_angle = view_angle;
    view.resolution = resolution;
    return view;
}

inline Lighting lights_off() {
    Lighting lighting;
    lighting.enabled = false;
    return lighting;
}

/// A renderer that has been prepared.
inline Renderer make_renderer(const gpu::Device& device, const Technique& technique, const SceneOnDevice& scene,
                              const View& view, const Lighting& lighting = Lighting{},
                              ParameterValues parameters = {}) {
    for (const auto& [name, value] : technique.manifest.defaults())
        parameters.emplace(name, value);
    Renderer renderer(device, technique, parameters, scene, view, lighting);
    renderer.prepare();
    return renderer;
}

inline int shader_compilations(const gpu::Device& device) {
    return device.shader_cache().compilations();
}

/// A manifest that differs from the shortest in `parameters` and `more` (", \"maps\": ..." and so on).
inline std::string manifest_json(const std::string& parameters, const std::string& more = "",
                                 const std::string& shape = "\"quad\"") {
    return R"({"title": "Test", "kind": "march", "citation": "none", "promises": [], "shape": )" + shape +
           R"(, "parameters": [)" + parameters + "]" + more + "}";
}

/// The polygon: what `flat` answers.
inline const char* const flat_trace = "Trace trace(ReliefRay ray) { return hit_off_ray(ray.uv, 1.0, 0); }\n";

/// Layers from the top, then the chord.
inline const char* const march_trace = R"(
Trace trace(ReliefRay ray) {
    const int layers = 512;
    float above = 1.0 - tap_height(ray.uv);
    if (above <= 0.0) return hit_on_ray(0.0, 0);
    for (int i = 1; i <= layers; ++i) {
        float s = float(i) / float(layers);
        float gap = 1.0 - s - tap_height(point_on_ray(ray, s));
        if (gap <= 0.0) return hit_on_ray(s - gap / (gap - above) / float(layers), i);
        above = gap;
    }
    return unconverged(hit_on_ray(1.0, layers));
}
)";

}  // namespace reliefbench::test
