#include "reference/stored_truth.hpp"

#include "core/cache_folder.hpp"
#include "core/error.hpp"
#include "core/json.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <vector>

namespace reliefbench {

namespace {

constexpr int stored_truth_format = 1;
constexpr const char* stored_truth_name = "a stored truth";
constexpr int max_stored_side = 1 << 20;

/// What a truth has beside that which all have.
constexpr const char* with_noise = "noise";
constexpr const char* with_front = "front";
constexpr const char* with_curved = "curved";

/// Calls visit(image) for each image that the truth has, in the order of the file.
template <typename SomeTruth, typename Visit>
void visit_images(SomeTruth& truth, const Visit& visit) {
    visit(truth.hits);
    visit(truth.footprint);
    visit(truth.colour);
    visit(truth.light_visibility.fractions);
    if (truth.standard_error) visit(*truth.standard_error);
    if (truth.half_picture) visit(*truth.half_picture);
    if (truth.front) visit(*truth.front);
    if (truth.curved) {
        visit(truth.curved->normals);
        visit(truth.curved->entry_triangles);
        visit(truth.curved->off_chart);
    }
}

template <typename Texel>
bool is_same(const Texel& a, const Texel& b) {
    static_assert(std::is_trivially_copyable_v<Texel>);
    return std::memcmp(&a, &b, sizeof(Texel)) == 0;
}

/// Of an image whose texels are all equal one is stored.
template <typename Texel>
bool is_uniform(const Image<Texel>& image) {
    return !image.texels.empty() && std::all_of(image.texels.begin(), image.texels.end(), [&](const Texel& texel) {
        return is_same(texel, image.texels.front());
    });
}

template <typename Texel>
void take_texels(std::string_view& bytes, Image<Texel>& image, bool uniform) {
    const std::size_t size = (uniform ? 1 : image.texels.size()) * sizeof(Texel);
    if (bytes.size() < size) fail("{} ends within its images", stored_truth_name);
    if (uniform) {
        Texel texel;
        std::memcpy(&texel, bytes.data(), size);
        std::fill(image.texels.begin(), image.texels.end(), texel);
    } else {
        std::memcpy(image.texels.data(), bytes.data(), size);
    }
    bytes.remove_prefix(size);
}

Truth empty_truth(const JsonView& header) {
    header.require_only({"format", "resolution", "samples", "background", "light_standard_error", "with", "uniform"});
    header.at("format").integer(stored_truth_format, stored_truth_format);
    const std::vector<JsonView> sides = header.at("resolution").items();
    const std::vector<JsonView> background = header.at("background").items();
    if (sides.size() != 2 || background.size() != 3) fail("{} has another shape", stored_truth_name);
    const Resolution size{static_cast<int>(sides[0].integer(1, max_stored_side)),
                          static_cast<int>(sides[1].integer(1, max_stored_side))};
    Truth truth;
    truth.hits = HitImage(size);
    truth.footprint = FootprintImage(size);
    truth.colour = Image<std::array<float, 3>>(size);
    truth.samples = static_cast<int>(header.at("samples").integer(1, max_truth_samples));
    for (std::size_t channel = 0; channel < 3; ++channel)
        truth.background[channel] = static_cast<float>(background[channel].number());
    truth.light_visibility.fractions = Image<std::array<float, 3>>(size);
    const JsonView error = header.at("light_standard_error");
    if (!error.json().is_null()) truth.light_visibility.standard_error = error.number();
    for (const JsonView& part : header.at("with").items()) {
        const std::string name = part.string();
        if (name == with_noise) {
            truth.standard_error = Image<float>(size);
            truth.half_picture = Image<std::array<float, 3>>(size);
        } else if (name == with_front) {
            truth.front = Image<Front>(size);
        } else if (name == with_curved) {
            truth.curved = CurvedTruth{.normals = Image<std::array<float, 3>>(size),
                                       .entry_triangles = Image<std::uint32_t>(size),
                                       .off_chart = Image<std::uint8_t>(size)};
        } else {
            fail("{} has '{}', which is unknown", stored_truth_name, name);
        }
    }
    return truth;
}

}  // namespace

std::string stored_truth(const Truth& truth) {
    Json header;
    header["format"] = stored_truth_format;
    header["resolution"] = {truth.hits.size.width, truth.hits.size.height};
    header["samples"] = truth.samples;
    header["background"] = truth.background;
    const std::optional<double>& error = truth.light_visibility.standard_error;
    header["light_standard_error"] = error ? Json(*error) : Json();
    header["with"] = Json::array();
    if (truth.standard_error) header["with"].push_back(with_noise);
    if (truth.front) header["with"].push_back(with_front);
    if (truth.curved) header["with"].push_back(with_curved);
    std::size_t size = 0;
    header["uniform"] = Json::array();
    visit_images(truth, [&](const auto& image) {
        const bool uniform = is_uniform(image);
        header["uniform"].push_back(uniform);
        size += (uniform ? 1 : image.texels.size()) * sizeof(image.texels[0]);
    });
    std::string bytes = header.dump() + '\n';
    // With room for the line that CachedFiles puts before it.
    bytes.reserve(bytes.size() + size + 64);
    auto uniform = header["uniform"].begin();
    visit_images(truth, [&](const auto& image) {
        const std::size_t texels = (uniform++)->template get<bool>() ? 1 : image.texels.size();
        bytes.append(reinterpret_cast<const char*>(image.texels.data()), texels * sizeof(image.texels[0]));
    });
    return bytes;
}

Truth parse_stored_truth(std::string_view bytes) {
    const Json json = parse_json(take_line(bytes), stored_truth_name);
    const JsonView header(json, stored_truth_name);
    Truth truth = empty_truth(header);
    const std::vector<JsonView> uniform = header.at("uniform").items();
    std::size_t image_index = 0;
    visit_images(truth, [&](auto& image) {
        if (image_index == uniform.size()) fail("{} lacks an image", stored_truth_name);
        take_texels(bytes, image, uniform[image_index++].boolean());
    });
    if (!bytes.empty() || image_index != uniform.size()) fail("{} has more than its images", stored_truth_name);
    return truth;
}

}  // namespace reliefbench
