#include "sweep/picture_axes.hpp"

#include "sweep/axis_kinds.hpp"

#include <bit>

namespace reliefbench {

namespace {

constexpr IntegerRange frame_counts{.minimum = 1, .maximum = 16};

/// Those of Vulkan's counts that devices have.
struct SampleCounts {
    static constexpr int maximum = 8;

    std::string text() const { return "1, 2, 4 or 8"; }
    int read(const JsonView& view) const {
        const auto count = static_cast<unsigned>(view.integer(1, maximum));
        if (!std::has_single_bit(count)) view.fail_expected(text());
        return static_cast<int>(count);
    }
};

}  // namespace

std::vector<ViewAxis> picture_axes() {
    std::vector<ViewAxis> axes;
    axes.push_back(number_axis(
        "samples_per_pixel",
        {.help = "multisampling with each sample searched and shaded; the picture is their mean",
         .also_called = {"msaa", "ssaa", "multisampling", "supersampling", "antialiasing", "aa", "spp"}},
        SampleCounts{}, [](auto& key) -> auto& { return key.view.samples_per_pixel; }));
    axes.push_back(number_axis(
        "frames",
        {.help = "of a still sequence with a jittered camera; the picture is their mean, the time is of one",
         .also_called = {"jitter", "taa", "temporal", "accumulation", "sequence"}},
        frame_counts, [](auto& key) -> auto& { return key.view.frames; }));
    return axes;
}

}  // namespace reliefbench
