#pragma once

#include "manifest/parameter.hpp"
#include "scene/albedo.hpp"
#include "scene/height_map.hpp"
#include "scene/hit.hpp"
#include "scene/lighting.hpp"
#include "scene/pixel_work.hpp"
#include "scene/relief.hpp"
#include "scene/scene_object.hpp"
#include "technique/answer_fault.hpp"
#include "technique/technique.hpp"

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace reliefbench {

namespace gpu {
class Device;
}

/// Height map, derivatives and albedo as textures, and the meshes of the bases that renderers draw. Shared by every
/// renderer of a block.
class SceneOnDevice {
public:
    SceneOnDevice(const gpu::Device& device, const HeightMap& map, const Albedo& albedo);
    ~SceneOnDevice();
    SceneOnDevice(SceneOnDevice&&) noexcept;

    struct Textures;
    const Textures& textures() const { return *textures_; }

private:
    std::unique_ptr<Textures> textures_;
};

/// One draw of the probed compilation, of one sample through each pixel's centre, and the picture.
struct Probe {
    HitImage hits;
    /// The picture that is measured: linear RGB, with the object where it is in front; the background where nothing was
    /// drawn. Of several samples and frames (View) their mean, nothing clamped before.
    Image<std::array<float, 3>> colour;
    /// Pixels that ran a fragment of the technique (with misses, which are not in `hits`).
    Image<std::uint8_t> covered;
    Image<PixelWork> work;
    /// How much of each light reaches the hit, in the lights' order; 1 without shadows and without a hit.
    Image<std::array<float, 3>> light_visibility;
    /// Taps of the shadows of each pixel, which are not in `work`.
    Image<std::uint32_t> shadow_taps;
    /// Of the surface as it is shaded, in the world, unit vectors; zeros where there is no hit. Empty over a flat base,
    /// where they follow from the hits.
    std::optional<Image<std::array<float, 3>>> normals = std::nullopt;
    /// What is in front, as the timed compilation's depths decide it; `hits` are the relief's, whatever covers them.
    /// Empty without an object.
    std::optional<Image<Front>> front;
    /// Taps and texels of vertex and tessellation stages, summed over the draw, and whether any of their loops were
    /// cut.
    PixelWork stages;
    /// Answers out of range, row by row: nothing else of the draw means anything where there is one.
    std::vector<AnswerFault> faults = {};
};

/// One draw of the timed compilation, for checking it against the probed one.
struct TimedPicture {
    Image<std::array<float, 4>> colour;
    /// Empty with several samples for each pixel.
    Image<float> depth;
};

enum class ColourTarget {
    /// 8 bits, sRGB-encoded: what is timed.
    display,
    /// 32-bit float, linear.
    linear_float,
};

/// How far a preparation that is cut into slices has come.
struct PreparationProgress {
    std::string pass;
    /// Of the pass, in [0, 1].
    double fraction = 0;
    /// Negative where nothing is known: later slices cost less than earlier ones.
    double remaining_s = -1;
};

struct PreparationSettings {
    int samples = 1;
    /// A preparation in slices that will take longer than this, in seconds on the device, is given up.
    double limit_s = std::numeric_limits<double>::infinity();
    /// Where maps made in slices are kept (core/cache_folder.hpp), and blue noise; empty: nowhere.
    std::filesystem::path cache = {};
    /// Whether maps kept there earlier do.
    bool take_kept = true;
    std::function<void(const PreparationProgress&)> on_progress = {};
};

/// Preparation: compute passes run in the manifest's order, and then the mips of a filtered material.
struct Preparation {
    /// Milliseconds of each run, by pass (all levels and slices of a pass together); of maps that were kept, those of
    /// making them.
    std::map<std::string, std::vector<double>> pass_ms;
    /// Device memory of the derived maps and of the material's mips; without scratch maps, which are gone by then.
    std::uint64_t bytes = 0;
    /// Whether the maps were taken from the cache.
    bool kept = false;
    /// Not empty when it would have taken longer than the limit: why it was given up. Nothing can be drawn then.
    std::string given_up;
};

/// Pipeline statistics of one draw by their Vulkan names without prefix, for example "fragment_shader_invocations".
/// Empty where the device has none.
using PipelineStatistics = std::map<std::string, std::uint64_t>;

/// What the driver tells of the timed pipeline's stages, by stage and statistic (gpu/executable_statistics.hpp). Empty
/// where it tells nothing.
using ExecutableStatistics = std::map<std::string, std::map<std::string, double>>;

/// One technique with one set of parameters before one view. Construction compiles the shaders (an Error names file,
/// line and technique) and allocates; `prepare` must come before everything else. Device and scene must outlive it.
class Renderer {
public:
    Renderer(const gpu::Device& device, const Technique& technique, const ParameterValues& parameters,
             const SceneOnDevice& scene, const View& view, const Lighting& lighting,
             const std::optional<SceneObject>& object = std::nullopt);
    ~Renderer();
    Renderer(Renderer&&) noexcept;

    Preparation prepare(const PreparationSettings& settings = {});
    /// The same for all renderers whose maps, with or without the material's mips, are made in the same way from the
    /// same height map, whatever they draw.
    std::string maps_key() const;
    Probe probe();
    /// The same from another camera, with the maps prepared once, and without the object; of a sequence's frame where
    /// one is given (View::frame), whose picture then has all samples, and the object.
    Probe probe_from(const Camera& camera, std::optional<int> frame = std::nullopt);
    /// What is timed: of several frames the first.
    TimedPicture draw_timed(ColourTarget target);
    PipelineStatistics pipeline_statistics();
    ExecutableStatistics executable_statistics();

    /// `samples` isolated timings of the draw, each of `repeats` draws inside one timestamp pair, in milliseconds per
    /// draw. All in one submission, which is recorded anew only where the numbers change.
    std::vector<double> time_draw(int samples, int repeats = 1);
    /// The same in two halves, with the device at work between them. One at a time.
    void submit_draw(int samples, int repeats = 1);
    std::vector<double> collect_draw();

private:
    struct State;
    std::unique_ptr<State> state_;
};

/// `samples` timings of a pass that does nothing: what the measurement itself costs. Never subtracted.
std::vector<double> time_empty_pass(const gpu::Device& device, int samples);

/// Empty when the device can run the technique with the parameters on the map and view, and these are what the
/// technique needs; else the reason for skipping the cell.
std::string unsupported_reason(const gpu::Device& device, const Technique& technique, const ParameterValues& parameters,
                               const View& view, Resolution height_map);

/// Of the technique's derived maps on the device, those that exist while they are made only included.
std::uint64_t derived_map_bytes(const Technique& technique, const ParameterValues& parameters, Resolution height_map);

/// Of albedo and derivatives with their mip chains, beside the textures that every cell has; 0 where the material is
/// read at level 0.
std::uint64_t material_mip_bytes(const MaterialFilter& filter, Resolution height_map, Resolution albedo);

/// At most, of the triangles of a base that is not flat on the device, with what finds those of a chart.
std::uint64_t base_bytes(const BaseMesh& mesh);

/// What u, v and h of the technique's hits may leave [0, 1] by.
double range_tolerance(const Manifest& manifest);

/// Of the device's own memory: its largest heap.
std::uint64_t device_memory_bytes(const gpu::Device& device);

/// The largest deviation δ of a filtered tap from exact bilinear interpolation of the stored values, for heights in
/// [0, 1], measured with a compute pass. The filter's floor is δ·H·tanθ·N·tiling texels.
double measure_filter_deviation(const gpu::Device& device, HeightFormat format);

}  // namespace reliefbench
