#include "technique/blue_noise.hpp"

#include "core/cache_folder.hpp"
#include "core/error.hpp"
#include "scene/void_and_cluster.hpp"

#include <algorithm>
#include <cstring>
#include <span>
#include <string>
#include <string_view>

namespace reliefbench {

namespace {

constexpr int noise_side = 64;
constexpr double noise_sigma = 1.5;
/// Another one where what is made changes.
constexpr const char* noise_key = "void_and_cluster_64_1";
constexpr std::uint64_t max_cached_noise_bytes = 1 << 20;

}  // namespace

Image<float> load_blue_noise(const std::filesystem::path& cache) {
    const CachedFiles files{
        .folder = cache, .extension = ".noise", .content = "noise textures", .max_bytes = max_cached_noise_bytes};
    Image<std::uint16_t> ranks({noise_side, noise_side});
    const std::span<std::byte> bytes = std::as_writable_bytes(std::span(ranks.texels));
    const bool is_cached = files.read(noise_key, [&](std::string_view content) {
        if (content.size() != bytes.size()) fail("it has {} bytes, not {}", content.size(), bytes.size());
        std::memcpy(bytes.data(), content.data(), bytes.size());
    });
    if (!is_cached) {
        const Image<std::uint16_t> made = void_and_cluster(noise_side, noise_sigma);
        std::ranges::copy(made.texels, ranks.texels.begin());
        files.write(noise_key, std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
    }
    Image<float> noise(ranks.size);
    std::ranges::transform(ranks.texels, noise.texels.begin(), [&](std::uint16_t rank) {
        return (static_cast<float>(rank) + 0.5F) / static_cast<float>(ranks.texels.size());
    });
    return noise;
}

gpu::Binding BlueNoiseOnDevice::binding(const std::filesystem::path& cache) const {
    if (!texture_) {
        const Image<float> noise = load_blue_noise(cache);
        const vk::Extent2D extent{noise_side, noise_side};
        gpu::Texture texture(*device_, extent, vk::Format::eR32Sfloat, 1,
                             vk::ImageUsageFlagBits::eSampled | vk::ImageUsageFlagBits::eTransferDst);
        gpu::upload_texture(*device_, texture, std::as_bytes(std::span(noise.texels)));
        texture_.emplace(std::move(texture));
        sampler_.emplace(gpu::make_sampler(*device_, {.filter = vk::Filter::eNearest}));
    }
    return gpu::sampled_image(blue_noise_name, texture_->view, *sampler_, vk::ImageLayout::eShaderReadOnlyOptimal);
}

}  // namespace reliefbench
