#include "metrics/motion_errors.hpp"

#include "scene/relief.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <numbers>
#include <optional>

namespace reliefbench {
namespace {

constexpr Resolution resolution{48, 40};
constexpr double height_scale = 0.1;
constexpr int map_size = 64;
/// Hits are floats: 6e-8 of the patch are 4e-6 texels of this map, and a score adds a few of them.
constexpr double rounding_texels = 5e-5;

/// Only its size matters here.
HeightMap some_map() {
    HeightMap map;
    map.heights = Image<float>({map_size, map_size});
    return map;
}

Relief relief_with(Boundary boundary) {
    Relief relief;
    relief.height_scale = height_scale;
    relief.boundary = boundary;
    return relief;
}

Hit on_plane(const Ray& ray, double h) {
    const double t = ((h - 1) * height_scale - ray.origin.z) / ray.direction.z;
    return {static_cast<float>(ray.origin.x + t * ray.direction.x + 0.5),
            static_cast<float>(ray.origin.y + t * ray.direction.y + 0.5), static_cast<float>(h), static_cast<float>(t)};
}

using Surface = std::function<Hit(const Ray&)>;

const Surface plane = [](const Ray& ray) { return on_plane(ray, 0.5); };

/// High at u < ½, low beyond, with a wall between that eyes at −x do not see.
const Surface cliff = [](const Ray& ray) {
    const Hit high = on_plane(ray, 1);
    return high.u < 0.5F ? high : on_plane(ray, 0);
};

/// A frame with a truth.
struct Frame {
    Frame(const Camera& from, const Surface& surface, Boundary boundary = Boundary::clip)
        : camera(from), hits(resolution), footprint(resolution) {
        for (int j = 0; j < resolution.height; ++j) {
            for (int i = 0; i < resolution.width; ++i) {
                const Ray ray = PixelRays(camera, resolution).at(i, j);
                footprint.at(i, j) = footprint_entry(ray) ? 1 : 0;
                const Hit hit = surface(ray);
                const bool on_patch = hit.u >= 0 && hit.u <= 1 && hit.v >= 0 && hit.v <= 1;
                if (on_patch || (boundary == Boundary::repeat && footprint.at(i, j) != 0)) hits.at(i, j) = hit;
            }
        }
    }

    TruthFrame truth() const { return {camera, hits, footprint}; }

    /// A technique that is wrong by (du, dv) texels.
    HitImage wrong_by(const std::function<glm::dvec2(const Hit& truth, int i, int j)>& texels) const {
        HitImage technique = hits;
        for (int j = 0; j < resolution.height; ++j) {
            for (int i = 0; i < resolution.width; ++i) {
                Hit& hit = technique.at(i, j);
                if (!hit.is_hit()) continue;
                const glm::dvec2 error = texels(hits.at(i, j), i, j) / double(map_size);
                hit.u = static_cast<float>(hit.u + error.x);
                hit.v = static_cast<float>(hit.v + error.y);
            }
        }
        return technique;
    }

    Camera camera;
    HitImage hits;
    Image<std::uint8_t> footprint;
};

struct Pair {
    explicit Pair(Projection projection, const Surface& surface = plane, Boundary boundary = Boundary::clip)
        : first({projection, 60, -90, 1.1, 45}, surface, boundary),
          second({projection, 58, -90, 1.1, 45}, surface, boundary),
          relief(relief_with(boundary)),
          motion(follow_truth(first.truth(), second.truth(), relief)) {}

    MotionChange compare(const HitImage& first_hits, const HitImage& second_hits) const {
        return compare_frames(motion.landings, first.hits, second.hits, first_hits, second_hits, some_map(), relief);
    }

    Frame first;
    Frame second;
    Relief relief;
    TruthMotion motion;
};

std::size_t footprint_hits(const Frame& frame) {
    std::size_t count = 0;
    for (std::size_t pixel = 0; pixel < frame.hits.texels.size(); ++pixel) {
        count += frame.footprint.texels[pixel] != 0 && frame.hits.texels[pixel].is_hit() ? 1 : 0;
    }
    return count;
}

double largest(const std::vector<double>& values) {
    return *std::max_element(values.begin(), values.end());
}

double mean(const std::vector<double>& values) {
    double sum = 0;
    for (const double value : values) {
        sum += value;
    }
    return sum / static_cast<double>(values.size());
}

struct Circumstance {
    Projection projection;
    Boundary boundary;
};

class MotionErrors : public testing::TestWithParam<Circumstance> {
protected:
    const Pair pair_{GetParam().projection, plane, GetParam().boundary};
};

TEST_P(MotionErrors, FollowNearlyAllOfTheFootprintAndCountTheRest) {
    const MotionChange change = pair_.compare(pair_.first.hits, pair_.second.hits);
    const std::size_t hits = footprint_hits(pair_.first);
    EXPECT_GT(change.texels.size(), hits * 9 / 10);
    EXPECT_EQ(change.texels.size() + pair_.motion.unseen, hits);
    EXPECT_EQ(change.hit_once, 0U);
}

TEST_P(MotionErrors, AreNoneForATechniqueWithoutError) {
    const MotionChange change = pair_.compare(pair_.first.hits, pair_.second.hits);
    EXPECT_EQ(largest(change.texels), 0);
    EXPECT_EQ(change.first.texels, change.second.texels);
}

TEST_P(MotionErrors, AreNoneForAnErrorThatDoesNotChange) {
    const auto constant = [](const Hit&, int, int) { return glm::dvec2(7, -11); };
    const MotionChange change = pair_.compare(pair_.first.wrong_by(constant), pair_.second.wrong_by(constant));
    EXPECT_LT(largest(change.texels), rounding_texels);
}

TEST_P(MotionErrors, AreTheSizeOfAJump) {
    const auto before = [](const Hit&, int, int) { return glm::dvec2(7, -11); };
    const auto after = [](const Hit&, int, int) { return glm::dvec2(10, -7); };
    const MotionChange change = pair_.compare(pair_.first.wrong_by(before), pair_.second.wrong_by(after));
    ASSERT_FALSE(change.texels.empty());
    for (const double texels : change.texels) {
        EXPECT_NEAR(texels, 5, rounding_texels);
    }
    // The second frame's error, where the first frame sees the point.
    for (std::size_t pixel = 0; pixel < change.second.texels.size(); ++pixel) {
        if (!pair_.motion.landings.texels[pixel].is_seen()) continue;
        EXPECT_NEAR(change.second.texels[pixel].u - pair_.first.hits.texels[pixel].u, 10.0 / map_size, 1e-6);
        EXPECT_NEAR(change.second.texels[pixel].v - pair_.first.hits.texels[pixel].v, -7.0 / map_size, 1e-6);
    }
}

TEST_P(MotionErrors, TellAnErrorThatSwimsFromOneThatSticksToTheSurface) {
    constexpr double waves = 2;
    const auto sticks = [](const Hit& truth, int, int) {
        return glm::dvec2(2 * std::sin(2 * std::numbers::pi * waves * truth.v), 0);
    };
    const auto swims = [](const Hit&, int, int j) {
        return glm::dvec2(2 * std::sin(2 * std::numbers::pi * waves * j / resolution.height), 0);
    };
    const auto score = [&](const auto& error) {
        return mean(pair_.compare(pair_.first.wrong_by(error), pair_.second.wrong_by(error)).texels);
    };
    // Of an amplitude of 2, interpolation leaves at most (π · waves / rows)² / 2, with 16 rows of relief and more.
    EXPECT_LT(score(sticks), 0.15);
    EXPECT_GT(score(swims), 2 * score(sticks));
}

INSTANTIATE_TEST_SUITE_P(, MotionErrors,
                         testing::Values(Circumstance{Projection::perspective, Boundary::clip},
                                         Circumstance{Projection::parallel, Boundary::clip},
                                         Circumstance{Projection::parallel, Boundary::repeat}));

TEST(MotionOfTheTruth, DoesNotCompareWhatTheOtherFrameHides) {
    for (const Projection projection : {Projection::perspective, Projection::parallel}) {
        // From −x over the edge of the cliff: towards grazing more of the low ground is hidden.
        const Frame first({projection, 60, 180, 1.1, 45}, cliff);
        const Frame second({projection, 66, 180, 1.1, 45}, cliff);
        const TruthMotion motion = follow_truth(first.truth(), second.truth(), relief_with(Boundary::clip));
        const TruthMotion back = follow_truth(second.truth(), first.truth(), relief_with(Boundary::clip));
        std::size_t followed = 0;
        std::size_t hidden_at_the_edge = 0;
        for (int j = 0; j < resolution.height; ++j) {
            for (int i = 0; i < resolution.width; ++i) {
                const Landing& landing = motion.landings.at(i, j);
                const Hit& hit = first.hits.at(i, j);
                const double shadow_end = 0.5 + height_scale * std::tan(64 * std::numbers::pi / 180);
                const bool behind_the_edge = hit.is_hit() && hit.h == 0 && hit.u < shadow_end;
                hidden_at_the_edge += behind_the_edge && !landing.is_seen() ? 1 : 0;
                if (!landing.is_seen()) continue;
                ++followed;
                for (std::size_t each = 0; each < landing.weights.size(); ++each) {
                    if (landing.weights[each] == 0) continue;
                    const int x = landing.x + static_cast<int>(each % 2);
                    const int y = landing.y + static_cast<int>(each / 2);
                    EXPECT_EQ(second.hits.at(x, y).h, hit.h) << i << ' ' << j;
                }
            }
        }
        EXPECT_GT(followed, 400U);
        EXPECT_GT(hidden_at_the_edge, 20U);
        EXPECT_GT(motion.unseen, back.unseen);
    }
}

TEST(MotionOfTheTruth, EndsWhereThePictureDoes) {
    const Frame first({Projection::parallel, 60, -90, 1.1, 45}, plane);
    const Frame second({Projection::parallel, 50, -90, 1.1, 45}, plane);
    const TruthMotion motion = follow_truth(first.truth(), second.truth(), relief_with(Boundary::clip));
    // A point at depth d is seen through v − d·tanθ: it moves up in the picture.
    const double moved_rows =
        0.5 * height_scale * (std::tan(std::numbers::pi / 3) - std::tan(std::numbers::pi * 5 / 18)) * resolution.height;
    ASSERT_GT(moved_rows, 0.6);
    ASSERT_LT(moved_rows, 1.4);
    for (int i = 0; i < resolution.width; ++i) {
        EXPECT_FALSE(motion.landings.at(i, 0).is_seen());
        EXPECT_TRUE(motion.landings.at(i, 10).is_seen());
    }
}

TEST(MotionOfTheTruth, ComparesNoTies) {
    Pair pair(Projection::perspective);
    std::fill(pair.first.footprint.texels.begin(), pair.first.footprint.texels.end(), tie_in_footprint);
    const TruthMotion from_ties = follow_truth(pair.first.truth(), pair.second.truth(), pair.relief);
    EXPECT_EQ(from_ties.unseen, 0U);
    for (const Landing& landing : from_ties.landings.texels)
        EXPECT_FALSE(landing.is_seen());
}

TEST(MotionChanges, CountWhatIsHitInOneFrameOnly) {
    const Pair pair(Projection::parallel);
    HitImage first = pair.first.hits;
    HitImage second = pair.second.hits;
    const auto all = pair.compare(first, second).texels.size();
    first.at(20, 20) = Hit{};
    const float nan = std::numeric_limits<float>::quiet_NaN();
    first.at(24, 20) = {nan, nan, nan, 1};
    MotionChange change = pair.compare(first, second);
    EXPECT_EQ(change.hit_once, 2U);
    EXPECT_EQ(change.texels.size(), all - 2);
    EXPECT_FALSE(change.first.at(20, 20).is_hit());
    EXPECT_TRUE(change.second.at(20, 20).is_hit());
    EXPECT_FALSE(change.first.at(24, 20).is_hit());

    std::fill(second.texels.begin(), second.texels.end(), Hit{});
    change = pair.compare(pair.first.hits, second);
    EXPECT_EQ(change.hit_once, all);
    EXPECT_TRUE(change.texels.empty());
}

TEST(MotionChanges, GoTheShortestWayRoundAChartAndLeaveOutOtherCharts) {
    const Pair pair(Projection::perspective);
    auto mesh = std::make_shared<BaseMesh>();
    mesh->charts = {0};
    mesh->chart_periods = {glm::vec2(2, 0)};
    Relief relief = pair.relief;
    relief.base = {MeshBase{mesh}};
    const Image<std::uint32_t> entries(resolution, 0);
    const auto follow = [&](const Image<std::uint8_t>& first, const Image<std::uint8_t>& second) {
        TruthFrame before = pair.first.truth();
        TruthFrame after = pair.second.truth();
        before.charts.emplace(FrameCharts{entries, first});
        after.charts.emplace(FrameCharts{entries, second});
        return follow_truth(before, after, relief);
    };
    const Image<std::uint8_t> on_chart(resolution, 0);
    const Image<std::uint8_t> off_chart(resolution, 1);
    const TruthMotion motion = follow(on_chart, on_chart);
    // The technique goes on past the seam in the first frame only, and half a texel too far in the second.
    const HitImage first = pair.first.wrong_by([](const Hit&, int, int) { return glm::dvec2(2 * map_size, 0); });
    const HitImage second = pair.second.wrong_by([](const Hit&, int, int) { return glm::dvec2(0.5, 0); });
    const MotionChange change =
        compare_frames(motion.landings, pair.first.hits, pair.second.hits, first, second, some_map(), relief);
    EXPECT_GT(change.texels.size(), 400U);
    for (const double texels : change.texels)
        EXPECT_NEAR(texels, 0.5, rounding_texels);

    EXPECT_EQ(follow(off_chart, on_chart).unseen, 0U) << "as of ties nothing is asked of them";
    const TruthMotion lost = follow(on_chart, off_chart);
    EXPECT_GT(lost.unseen, 400U);
    for (const Landing& landing : lost.landings.texels)
        EXPECT_FALSE(landing.is_seen());
}

TEST(MotionFigures, AreMeansOverPairsAndTheLargest) {
    MotionFigures figures;
    EXPECT_FALSE(figures.values());
    figures.add({});
    EXPECT_FALSE(figures.values());
    figures.add(std::vector<double>{1, 1, 1, 1});
    figures.add(std::vector<double>{0, 10});
    const auto values = figures.values();
    ASSERT_TRUE(values);
    EXPECT_EQ(values->mean, 3);
    EXPECT_DOUBLE_EQ(values->p95, (1 + 9.5) / 2);
    EXPECT_EQ(values->max, 10);
}

TEST(FollowTruth, OverTrianglesAPointIsWhereItsRayHits) {
    // The plane once more, of two triangles whose (u, v) name no places of it.
    auto mesh = std::make_shared<BaseMesh>();
    mesh->vertices = {{{-0.5F, -0.5F, 0}, {0, 0, 1}, {3, 0}},
                      {{0.5F, -0.5F, 0}, {0, 0, 1}, {5, 1}},
                      {{0.5F, 0.5F, 0}, {0, 0, 1}, {4, 9}},
                      {{-0.5F, 0.5F, 0}, {0, 0, 1}, {0, 7}}};
    mesh->triangles = {{0, 1, 2}, {0, 2, 3}};
    mesh->charts = {0, 0};
    Camera camera;
    camera.view_angle = 50;
    Camera next = camera;
    next.azimuth += 3;
    Frame first(camera, cliff);
    Frame second(next, cliff);
    const Relief flat = relief_with(Boundary::clip);
    Relief curved = flat;
    curved.base = {MeshBase{mesh}};
    const auto follow = [&](const Relief& relief) {
        return follow_truth({camera, first.hits, first.footprint}, {next, second.hits, second.footprint}, relief);
    };
    const TruthMotion expected = follow(flat);
    for (Frame* frame : {&first, &second}) {
        for (Hit& hit : frame->hits.texels)
            hit.u = hit.v = 7;
    }
    const TruthMotion motion = follow(curved);
    EXPECT_EQ(motion.unseen, expected.unseen);
    for (std::size_t pixel = 0; pixel < expected.landings.texels.size(); ++pixel) {
        const Landing& landing = motion.landings.texels[pixel];
        ASSERT_EQ(landing.is_seen(), expected.landings.texels[pixel].is_seen()) << pixel;
        for (std::size_t corner = 0; corner < 4; ++corner)
            ASSERT_NEAR(landing.weights[corner], expected.landings.texels[pixel].weights[corner], 1e-3) << pixel;
    }
}

}  // namespace
}  // namespace reliefbench
