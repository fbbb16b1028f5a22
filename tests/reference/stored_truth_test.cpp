#include "reference/stored_truth.hpp"

#include "core/error.hpp"
#include "reference/truth_code.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <string>

namespace reliefbench {
namespace {

Truth truth_with_everything(const View& view, int samples, bool has_object) {
    HeightMapSource source;
    source.name = "rock";
    source.size = {16, 16};
    const HeightMap map = load_height_map(source, HeightFormat::r16);
    const SceneObject object;
    Lighting low_sun;
    low_sun.lights = {{.direction = {-1, 0.3, 0.15}}};
    return trace_exact_truth(map, load_albedo({}, map), view, low_sun,
                             {.samples = samples, .object = has_object ? &object : nullptr});
}

template <typename Texel>
bool same_bytes(const Image<Texel>& a, const Image<Texel>& b) {
    return a.size == b.size && a.texels.size() == b.texels.size() &&
           std::memcmp(a.texels.data(), b.texels.data(), a.texels.size() * sizeof(Texel)) == 0;
}

template <typename Value>
bool same_bytes(const std::optional<Image<Value>>& a, const std::optional<Image<Value>>& b) {
    return a.has_value() == b.has_value() && (!a || same_bytes(*a, *b));
}

void expect_same(const Truth& a, const Truth& b) {
    EXPECT_TRUE(same_bytes(a.hits, b.hits));
    EXPECT_TRUE(same_bytes(a.footprint, b.footprint));
    EXPECT_TRUE(same_bytes(a.colour, b.colour));
    EXPECT_EQ(a.samples, b.samples);
    EXPECT_TRUE(same_bytes(a.standard_error, b.standard_error));
    EXPECT_TRUE(same_bytes(a.half_picture, b.half_picture));
    EXPECT_EQ(a.background, b.background);
    EXPECT_TRUE(same_bytes(a.light_visibility.fractions, b.light_visibility.fractions));
    EXPECT_EQ(a.light_visibility.standard_error, b.light_visibility.standard_error);
    EXPECT_TRUE(same_bytes(a.front, b.front));
    ASSERT_EQ(a.curved.has_value(), b.curved.has_value());
    if (!a.curved) return;
    EXPECT_TRUE(same_bytes(a.curved->normals, b.curved->normals));
    EXPECT_TRUE(same_bytes(a.curved->entry_triangles, b.curved->entry_triangles));
    EXPECT_TRUE(same_bytes(a.curved->off_chart, b.curved->off_chart));
}

View shadowed_view() {
    View view{.camera = {.view_angle = 60}, .relief = {}, .resolution = {20, 15}};
    view.self_shadow.mode = SelfShadow::Mode::soft;
    return view;
}

TEST(StoredTruth, IsTheSameBitForBit) {
    View curved = shadowed_view();
    curved.relief.base = load_base({.kind = BaseSource::Kind::sphere, .segments = 3});
    for (const View& view : {View{.camera = {}, .relief = {}, .resolution = {9, 7}}, shadowed_view(), curved}) {
        for (const int samples : {1, 4}) {
            for (const bool has_object : {false, true}) {
                const Truth truth = truth_with_everything(view, samples, has_object);
                const std::string bytes = stored_truth(truth);
                expect_same(parse_stored_truth(bytes), truth);
                EXPECT_EQ(stored_truth(parse_stored_truth(bytes)), bytes);
            }
        }
    }
}

TEST(StoredTruth, WithoutShadowsTakesNoRoomForThem) {
    View view = shadowed_view();
    const std::size_t shadowed = stored_truth(truth_with_everything(view, 1, false)).size();
    view.self_shadow.mode = SelfShadow::Mode::off;
    const std::size_t plain = stored_truth(truth_with_everything(view, 1, false)).size();
    EXPECT_LT(plain + 11 * view.resolution.pixels(), shadowed);
}

TEST(StoredTruth, OfOtherBytesIsRefused) {
    const std::string bytes = stored_truth(truth_with_everything(shadowed_view(), 2, true));
    EXPECT_THROW(parse_stored_truth(bytes.substr(0, bytes.size() - 1)), Error);
    EXPECT_THROW(parse_stored_truth(bytes + "x"), Error);
    EXPECT_THROW(parse_stored_truth("{}"), Error);
    EXPECT_THROW(parse_stored_truth(""), Error);
    std::string later = bytes;
    later.replace(later.find("\"format\":1"), 10, "\"format\":2");
    EXPECT_THROW(parse_stored_truth(later), Error);
}

TEST(TruthCode, IsAHash) {
    EXPECT_EQ(truth_code().size(), 64U);
    EXPECT_EQ(truth_code().find_first_not_of("0123456789abcdef"), std::string_view::npos);
}

}  // namespace
}  // namespace reliefbench
