#include "metrics/frame_history.hpp"

#include "scene/picture_mean.hpp"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace reliefbench {
namespace {

using Colours = Image<std::array<float, 3>>;

constexpr Resolution size{24, 20};

Camera camera_at(Projection projection, double azimuth = -70, double view_angle = 50) {
    Camera camera;
    camera.projection = projection;
    camera.azimuth = azimuth;
    camera.view_angle = view_angle;
    return camera;
}

/// Picture number `seed` of noise.
Colours noise(unsigned seed) {
    Colours picture(size);
    std::uint32_t state = seed * 2654435761U + 1;
    for (auto& texel : picture.texels) {
        for (float& channel : texel) {
            state = state * 1664525U + 1013904223U;
            channel = static_cast<float>(state >> 8U) / 16777216.0F;
        }
    }
    return picture;
}

double largest_difference(const Colours& a, const Colours& b) {
    double largest = 0;
    for (std::size_t pixel = 0; pixel < a.texels.size(); ++pixel) {
        for (std::size_t channel = 0; channel < 3; ++channel)
            largest = std::max(largest, std::abs(double(a.texels[pixel][channel]) - b.texels[pixel][channel]));
    }
    return largest;
}

/// Of points on the plane z = 0, seen in all pixels.
Image<double> distances_of_plane(const Camera& camera) {
    Image<double> distances(size);
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            const Ray ray = PixelRays(camera, size).at(x, y);
            distances.at(x, y) = -ray.origin.z / ray.direction.z;
        }
    }
    return distances;
}

const Projection projections[] = {Projection::perspective, Projection::parallel};

TEST(Reprojection, BetweenFramesOfAStillCameraMovesNothingWhateverTheirJitter) {
    for (const Projection projection : projections) {
        Camera jittered = camera_at(projection);
        jittered.shift = {0.4 / size.width, -0.3 / size.height};
        const Reprojection reprojection(jittered, camera_at(projection), size, Relief{});
        for (const double distance : {0.3, 1.7, no_distance}) {
            const auto position = reprojection(5, 7, distance);
            ASSERT_TRUE(position);
            EXPECT_EQ(*position, glm::dvec2(5, 7));
        }
    }
}

TEST(Reprojection, FollowsThePointThatThePixelsOwnDepthNames) {
    for (const Projection projection : projections) {
        Camera from = camera_at(projection);
        const Camera to = camera_at(projection, -69, 52);
        const PixelRays there(to, size);
        const PixelRays centred(from, size);
        from.shift = {0.25 / size.width, 0.125 / size.height};
        for (const double distance : {0.5, 1.4}) {
            const Ray ray = PixelRays(from, size).at(9, 11);
            const glm::dvec3 point = ray.origin + distance * ray.direction;
            const auto position = Reprojection(from, to, size, Relief{})(9, 11, distance);
            ASSERT_TRUE(position);
            // What is a quarter of a pixel beside the centre here is so there, too.
            const glm::dvec2 expected = *there.project(point) - glm::dvec2(0.25, 0.125);
            EXPECT_NEAR(position->x, expected.x, 1e-9);
            EXPECT_NEAR(position->y, expected.y, 1e-9);
        }
    }
}

TEST(Reprojection, TheBackgroundTurnsWithAPerspectiveCameraAndStandsStillInParallelRays) {
    const auto moved = [](Projection projection, double distance) {
        const Reprojection reprojection(camera_at(projection), camera_at(projection, -68), size, Relief{});
        return *reprojection(12, 10, distance) - glm::dvec2(12, 10);
    };
    EXPECT_EQ(moved(Projection::parallel, no_distance), glm::dvec2(0));
    const glm::dvec2 background = moved(Projection::perspective, no_distance);
    const glm::dvec2 far_away = moved(Projection::perspective, 1e9);
    EXPECT_NEAR(background.x, far_away.x, 1e-6);
    EXPECT_NEAR(background.y, far_away.y, 1e-6);
    EXPECT_GT(glm::length(background), 0.5);
    EXPECT_LT(glm::length(moved(Projection::perspective, 1.5)), 0.5) << "the origin, about which the camera turns";
}

class StillHistory : public testing::TestWithParam<Projection> {
protected:
    Colours next(const Colours& history, const Colours& frame, const HistorySettings& settings) const {
        return next_history(history, {frame, distances_, reprojection_}, settings);
    }

    Camera camera_ = camera_at(GetParam());
    Image<double> distances_ = distances_of_plane(camera_);
    Reprojection reprojection_{camera_, camera_, size, Relief{}};
};

TEST_P(StillHistory, WithoutWeightIsTheFrameBitForBit) {
    for (const bool clamp : {false, true})
        EXPECT_EQ(next(noise(1), noise(2), {0, clamp}).texels, noise(2).texels);
}

TEST_P(StillHistory, WeighsFramesExponentially) {
    constexpr double weight = 0.8;
    constexpr int frames = 12;
    Colours history = noise(0);
    Image<std::array<double, 3>> expected(size);
    for (int frame = 0; frame <= frames; ++frame) {
        const Colours picture = noise(static_cast<unsigned>(frame));
        if (frame > 0) history = next(history, picture, {weight, false});
        const double share = std::pow(weight, frames - frame) * (frame > 0 ? 1 - weight : 1);
        for (std::size_t pixel = 0; pixel < expected.texels.size(); ++pixel) {
            for (std::size_t channel = 0; channel < 3; ++channel)
                expected.texels[pixel][channel] += share * static_cast<double>(picture.texels[pixel][channel]);
        }
    }
    for (std::size_t pixel = 0; pixel < expected.texels.size(); ++pixel) {
        for (std::size_t channel = 0; channel < 3; ++channel)
            EXPECT_NEAR(history.texels[pixel][channel], expected.texels[pixel][channel], 1e-6);
    }
}

/// Of a sequence that repeats: the history of its frames is at most so far from their mean as the weights of its frames
/// are from equal ones, and its mean over a period is theirs.
TEST_P(StillHistory, ConvergesToTheMeanOfItsFrames) {
    constexpr int period = 4;
    PictureMean mean;
    for (unsigned frame = 0; frame < period; ++frame)
        mean.add(noise(frame));
    double before = 1;
    for (const double weight : {0.5, 0.9, 0.98}) {
        Colours history(size, {0.5F, 0.5F, 0.5F});
        const int rounds = static_cast<int>(std::log(1e-7) / std::log(weight)) / period + 1;
        for (int round = 0; round < rounds; ++round) {
            for (unsigned frame = 0; frame < period; ++frame)
                history = next(history, noise(frame), {weight, false});
        }
        // The weight of each place in the period, the newest frame's last.
        double unequal = 0;
        for (int age = 0; age < period; ++age)
            unequal += std::abs((1 - weight) * std::pow(weight, age) / (1 - std::pow(weight, period)) - 1.0 / period);
        const double distance = largest_difference(history, mean.mean());
        EXPECT_LE(distance, unequal + 1e-5);
        EXPECT_LT(distance, before);
        before = distance;
        PictureMean over_period;
        for (unsigned frame = 0; frame < period; ++frame) {
            history = next(history, noise(frame), {weight, false});
            over_period.add(history);
        }
        EXPECT_LT(largest_difference(over_period.mean(), mean.mean()), 1e-5);
    }
    EXPECT_LT(before, 0.03);
}

TEST_P(StillHistory, ThatIsWithinTheNeighbourhoodIsNotClamped) {
    EXPECT_EQ(next(noise(3), noise(3), {0.9, true}).texels, next(noise(3), noise(3), {0.9, false}).texels);
}

INSTANTIATE_TEST_SUITE_P(, StillHistory, testing::ValuesIn(projections));

/// A red bar in front of a grey wall, which has gone on by a few pixels: the wall that it hid is seen for the first
/// time.
TEST(MovingHistory, ShowsWhatHidTheWallAndTheClampTakesItAway) {
    const Camera camera = camera_at(Projection::parallel);
    const Reprojection reprojection(camera, camera, size, Relief{});
    const Image<double> distances = distances_of_plane(camera);
    const auto bar_at = [](int left) {
        Colours picture(size, {0.25F, 0.25F, 0.25F});
        for (int y = 0; y < size.height; ++y) {
            for (int x = left; x < left + 4; ++x)
                picture.at(x, y) = {0.9F, 0.05F, 0.05F};
        }
        return picture;
    };
    const Colours history = bar_at(8);
    const Colours frame = bar_at(14);
    const Colours kept = next_history(history, {frame, distances, reprojection}, {0.9, false});
    const Colours clamped = next_history(history, {frame, distances, reprojection}, {0.9, true});
    for (int y = 0; y < size.height; ++y) {
        for (int x = 8; x < 12; ++x) {
            EXPECT_NEAR(kept.at(x, y)[0], 0.9 * 0.9 + 0.1 * 0.25, 1e-6) << "a ghost";
            for (const float channel : clamped.at(x, y))
                EXPECT_NEAR(channel, 0.25, 1e-6);
        }
    }
}

TEST(MovingHistory, TakesOnlyTheFrameWhereItsPointWasOutsideThePicture) {
    const Camera from = camera_at(Projection::parallel, -90, 60);
    Camera to = from;
    to.view_angle = 40;
    // Below the base, so that with the angle points move along the picture's columns.
    Image<double> distances = distances_of_plane(from);
    for (double& distance : distances.texels)
        distance += 0.4;
    const Reprojection reprojection(from, to, size, Relief{});
    const Colours history(size, {1, 1, 1});
    const Colours frame(size, {0, 0, 0});
    const Colours next = next_history(history, {frame, distances, reprojection}, {0.75, false});
    int without = 0;
    for (int y = 0; y < size.height; ++y) {
        const double row = reprojection(3, y, distances.at(3, y))->y;
        const bool was_inside = row >= -0.5 && row <= size.height - 0.5;
        without += was_inside ? 0 : 1;
        EXPECT_NEAR(next.at(3, y)[0], was_inside ? 0.75 : 0.0, 1e-6) << y;
    }
    EXPECT_GT(without, 1);
    EXPECT_LT(without, size.height / 2);
}

TEST(MovingHistory, IsSampledByACubicThatKeepsLines) {
    const Camera from = camera_at(Projection::parallel, -90, 60);
    Camera to = from;
    to.view_angle = 59;
    Image<double> distances = distances_of_plane(from);
    for (double& distance : distances.texels)
        distance += 0.1;
    const Reprojection reprojection(from, to, size, Relief{});
    Colours history(size);
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x)
            history.at(x, y) = {0.01F * static_cast<float>(y), 0.01F * static_cast<float>(x), 0.5F};
    }
    const Colours frame(size);
    const Colours next = next_history(history, {frame, distances, reprojection}, {0.5, false});
    const glm::dvec2 position = *reprojection(10, 10, distances.at(10, 10));
    EXPECT_GT(std::abs(position.y - std::round(position.y)), 0.01);
    EXPECT_NEAR(next.at(10, 10)[0], 0.5 * 0.01 * position.y, 1e-6);
    EXPECT_NEAR(next.at(10, 10)[1], 0.5 * 0.01 * position.x, 1e-6);
    EXPECT_NEAR(next.at(10, 10)[2], 0.25, 1e-6);
}

}  // namespace
}  // namespace reliefbench
