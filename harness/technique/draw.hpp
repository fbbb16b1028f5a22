#pragma once

// Internal to this layer: includes Vulkan.

#include "gpu/executable_statistics.hpp"
#include "gpu/memory.hpp"
#include "gpu/pipeline.hpp"
#include "technique/object_draw.hpp"
#include "technique/pipeline/draw_pipeline.hpp"
#include "technique/program.hpp"
#include "technique/renderer.hpp"
#include "technique/work_counters.hpp"

#include <array>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace reliefbench {

/// What a draw of a technique needs besides the technique.
struct DrawSetup {
    View view;
    ParameterValues parameters;
    gpu::SpecializationValues constants;
    std::vector<gpu::Binding> bindings;
    /// By name, what is made and bound only where a stage uses it.
    std::map<std::string, std::function<gpu::Binding()>> on_demand = {};
    DrawGeometry geometry;
    /// Drawn first, into what is timed.
    std::optional<ObjectOnDevice> object = {};
    /// Linear RGB.
    std::array<float, 3> background{};
};

/// Targets, pipeline and work counters of one compilation of a technique.
class Draw {
public:
    enum class Kind { probed, timed_display, timed_float };

    /// What is timed has the view's samples for each pixel, resolved at the end of each pass; a probed draw has one.
    Draw(const gpu::Device& device, const Technique& technique, Kind kind, const DrawSetup& setup);

    /// Brings targets into their layouts and clears the work counters; once per submission, before the first draw.
    void begin(const vk::raii::CommandBuffer& commands) const;
    /// One whole pass: clear, draw, store.
    void record(const vk::raii::CommandBuffer& commands) const;

    /// Row 0 is the top. After the submission has ended.
    std::vector<std::byte> read_target(std::size_t colour_target) const;
    /// Of a draw with one sample for each pixel.
    std::vector<std::byte> read_depth() const;
    /// Probed only.
    const WorkCounters& work() const { return *work_; }

private:
    const gpu::Device* device_;
    vk::Extent2D extent_;
    const DrawPipeline* draws_by_;
    DrawGeometry geometry_;
    /// One texel for each pixel.
    std::vector<gpu::Texture> colours_;
    /// What is drawn into where pixels have several samples, which `colours_` are resolved from; else empty.
    std::vector<gpu::Texture> sampled_colours_;
    std::vector<vk::ClearColorValue> clears_;
    gpu::Texture depth_;
    std::optional<WorkCounters> work_;
    gpu::Pipeline pipeline_;
    std::optional<gpu::Pipeline> object_pipeline_;
};

/// Of what is timed.
gpu::ExecutableStatistics read_executable_statistics(const gpu::Device& device, const Technique& technique,
                                                     const DrawSetup& setup);

}  // namespace reliefbench
