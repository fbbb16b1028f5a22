#include "scene/camera.hpp"

#include "scene/relief.hpp"

#include <gtest/gtest.h>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include <cmath>
#include <numbers>
#include <vector>

namespace reliefbench {
namespace {

constexpr double tolerance = 1e-12;

std::vector<Camera> cameras(Projection projection) {
    std::vector<Camera> all;
    for (const double view_angle : {0.0, 30.0, 60.0, 85.0, 89.0}) {
        for (const double azimuth : {-90.0, 0.0, 37.0, 180.0}) {
            all.push_back({projection, view_angle, azimuth, 1.5, 45});
        }
    }
    all.push_back({projection, 50, 20, 0.4, 70});  // an eye above the patch itself
    all.push_back({projection, 10, 20, 8, 10});
    return all;
}

const std::vector<Resolution> resolutions{{8, 8}, {16, 9}, {5, 11}};

void expect_near(glm::dvec3 actual, glm::dvec3 expected, double bound = tolerance) {
    EXPECT_NEAR(actual.x, expected.x, bound);
    EXPECT_NEAR(actual.y, expected.y, bound);
    EXPECT_NEAR(actual.z, expected.z, bound);
}

glm::dvec3 project(const glm::dmat4& clip_from_world, glm::dvec3 point) {
    const glm::dvec4 clip = clip_from_world * glm::dvec4(point, 1);
    EXPECT_GT(clip.w, 0);
    return glm::dvec3(clip) / clip.w;
}

TEST(Camera, FrameIsOrthonormalAndRightHanded) {
    for (const Projection projection : {Projection::perspective, Projection::parallel}) {
        for (const Camera& camera : cameras(projection)) {
            const CameraFrame frame = camera_frame(camera);
            EXPECT_NEAR(glm::length(frame.forward), 1, tolerance);
            EXPECT_NEAR(glm::length(frame.right), 1, tolerance);
            EXPECT_NEAR(glm::length(frame.up), 1, tolerance);
            EXPECT_NEAR(glm::dot(frame.forward, frame.up), 0, tolerance);
            expect_near(glm::cross(frame.right, frame.up), -frame.forward);
        }
    }
}

TEST(Camera, HeadOnThePictureStandsAsInTheFile) {
    const CameraFrame frame = camera_frame(Camera{});
    expect_near(frame.eye, {0, 0, 1.5});
    expect_near(frame.forward, {0, 0, -1});
    expect_near(frame.right, {1, 0, 0});
    expect_near(frame.up, {0, 1, 0});
}

TEST(Camera, EyeLooksFromTheAzimuthAtTheOrigin) {
    // 60° from the normal, towards +x: eye = 1.5·(sin 60°, 0, cos 60°).
    const CameraFrame frame = camera_frame({Projection::perspective, 60, 0, 1.5, 45});
    expect_near(frame.eye, {1.5 * std::sqrt(3) / 2, 0, 0.75});
    expect_near(frame.forward, {-std::sqrt(3) / 2, 0, -0.5});
    expect_near(frame.right, {0, 1, 0});
    expect_near(frame.up, {-0.5, 0, std::sqrt(3) / 2});
}

TEST(Camera, PointsOnAPixelsRayAreProjectedToThePixel) {
    for (const Projection projection : {Projection::perspective, Projection::parallel}) {
        for (Camera camera : cameras(projection)) {
            for (const double view_angle : {camera.view_angle, -camera.view_angle}) {
                camera.view_angle = view_angle;
                for (const Resolution resolution : resolutions) {
                    const PixelRays rays(camera, resolution);
                    for (const glm::dvec2 pixel : {glm::dvec2(0, 0), glm::dvec2(2.25, 6.5), glm::dvec2(-1, 20)}) {
                        const Ray ray = rays.at(pixel.x, pixel.y);
                        const auto seen = rays.project(ray.origin + 0.7 * ray.direction);
                        ASSERT_TRUE(seen);
                        // A point 20 pixels away from a picture of five is far off the axis.
                        EXPECT_NEAR(seen->x, pixel.x, 1e-10);
                        EXPECT_NEAR(seen->y, pixel.y, 1e-10);
                    }
                }
            }
        }
    }
}

TEST(Camera, ShiftedRaysAreThoseBesideThePixelsCentres) {
    for (const Projection projection : {Projection::perspective, Projection::parallel}) {
        for (Camera camera : cameras(projection)) {
            const Resolution size{8, 5};
            const PixelRays centred(camera, size);
            camera.shift = {0.25 / size.width, -0.375 / size.height};
            const PixelRays shifted(camera, size);
            const glm::dmat4 clip = clip_from_world(View{.camera = camera, .relief = {}, .resolution = size});
            for (const glm::dvec2 pixel : {glm::dvec2(0, 0), glm::dvec2(6, 3)}) {
                const Ray ray = shifted.at(pixel.x, pixel.y);
                const Ray expected = centred.at(pixel.x + 0.25, pixel.y - 0.375);
                expect_near(ray.origin, expected.origin);
                expect_near(ray.direction, expected.direction);
                const glm::dvec3 point = ray.origin + 1.2 * ray.direction;
                const auto seen = shifted.project(point);
                ASSERT_TRUE(seen);
                EXPECT_NEAR(seen->x, pixel.x, 1e-10);
                EXPECT_NEAR(seen->y, pixel.y, 1e-10);
                const glm::dvec3 device = project(clip, point);
                EXPECT_NEAR((device.x + 1) / 2 * size.width, pixel.x + 0.5, 1e-10);
                EXPECT_NEAR((device.y + 1) / 2 * size.height, pixel.y + 0.5, 1e-10);
            }
        }
    }
}

TEST(Camera, WhatIsBehindTheEyeIsSeenNowhere) {
    const Camera camera{Projection::perspective, 60, 0, 1.5, 45};
    const CameraFrame frame = camera_frame(camera);
    EXPECT_FALSE(PixelRays(camera, {8, 8}).project(frame.eye - frame.forward));
}

TEST(Camera, PerspectiveRaysFollowTheFormula) {
    constexpr double degree = std::numbers::pi / 180;
    for (const Camera& camera : cameras(Projection::perspective)) {
        const double st = std::sin(camera.view_angle * degree), ct = std::cos(camera.view_angle * degree);
        const double sp = std::sin(camera.azimuth * degree), cp = std::cos(camera.azimuth * degree);
        const glm::dvec3 forward{-st * cp, -st * sp, -ct};
        const glm::dvec3 up{-ct * cp, -ct * sp, st};
        const glm::dvec3 right = glm::cross(forward, up);
        for (const Resolution size : resolutions) {
            const double tangent = std::tan(camera.fov / 2 * degree);
            for (int j = 0; j < size.height; ++j) {
                for (int i = 0; i < size.width; ++i) {
                    const glm::dvec3 along =
                        forward + right * ((2 * (i + 0.5) / size.width - 1) * tangent * size.width / size.height) +
                        up * ((1 - 2 * (j + 0.5) / size.height) * tangent);
                    const Ray ray = PixelRays(camera, size).at(i, j);
                    expect_near(ray.origin, camera.distance * glm::dvec3(st * cp, st * sp, ct));
                    expect_near(ray.direction, along / glm::length(along));
                }
            }
        }
    }
}

TEST(Camera, ParallelRaysFillTheTarget) {
    for (const Camera& camera : cameras(Projection::parallel)) {
        for (const Resolution size : resolutions) {
            for (int j = 0; j < size.height; ++j) {
                for (int i = 0; i < size.width; ++i) {
                    const Ray ray = PixelRays(camera, size).at(i, j);
                    const auto entry = footprint_entry(ray);
                    ASSERT_TRUE(entry);
                    EXPECT_NEAR(entry->x, (i + 0.5) / size.width, tolerance);
                    EXPECT_NEAR(entry->y, 1 - (j + 0.5) / size.height, tolerance);
                    EXPECT_EQ(ray.origin.z, 0);
                    EXPECT_EQ(ray.direction, camera_frame(camera).forward);
                }
            }
        }
    }
}

TEST(Camera, ProjectsPointsOfAPixelsRayOntoItsCentre) {
    for (const Projection projection : {Projection::perspective, Projection::parallel}) {
        for (const Camera& camera : cameras(projection)) {
            for (const Resolution size : resolutions) {
                const glm::dmat4 clip = clip_from_world(View{.camera = camera, .relief = {}, .resolution = size});
                for (int j = 0; j < size.height; ++j) {
                    for (int i = 0; i < size.width; ++i) {
                        const Ray ray = PixelRays(camera, size).at(i, j);
                        for (const double t : {0.3, 1.0, 2.5}) {
                            const glm::dvec3 device = project(clip, ray.origin + t * ray.direction);
                            // Sliding along grazing rays multiplies rounding by tan θ, up to 57 here.
                            EXPECT_NEAR((device.x + 1) / 2 * size.width, i + 0.5, 1e-10);
                            EXPECT_NEAR((device.y + 1) / 2 * size.height, j + 0.5, 1e-10);
                        }
                    }
                }
            }
        }
    }
}

TEST(Camera, DepthOfVisibleReliefIsInRangeAndGrowsAlongRays) {
    for (const Projection projection : {Projection::perspective, Projection::parallel}) {
        for (const Camera& camera : cameras(projection)) {
            const Resolution size{16, 9};
            const glm::dmat4 clip = clip_from_world(View{.camera = camera, .relief = {}, .resolution = size});
            for (int j = 0; j < size.height; ++j) {
                for (int i = 0; i < size.width; ++i) {
                    const Ray ray = PixelRays(camera, size).at(i, j);
                    if (!footprint_entry(ray)) continue;
                    double previous = -1;
                    for (int step = 0; step <= 10; ++step) {
                        const double t = (-step / 10.0 - ray.origin.z) / ray.direction.z;
                        const double depth = project(clip, ray.origin + t * ray.direction).z;
                        EXPECT_GE(depth, 0);
                        EXPECT_LE(depth, 1 + tolerance);
                        EXPECT_GT(depth, previous);
                        previous = depth;
                    }
                }
            }
        }
    }
}

TEST(Camera, ThePatchesCornersAreInFrontOfTheNearPlane) {
    for (const Camera& camera : cameras(Projection::perspective)) {
        if (camera.distance < 1) continue;
        const glm::dmat4 clip = clip_from_world(View{.camera = camera, .relief = {}, .resolution = {8, 8}});
        for (const double x : {-0.5, 0.5}) {
            for (const double y : {-0.5, 0.5}) {
                for (const double z : {0.0, -1.0}) {
                    const double depth = project(clip, {x, y, z}).z;
                    EXPECT_GT(depth, 0);
                    EXPECT_LT(depth, 1);
                }
            }
        }
    }
}

TEST(Footprint, IsTheClosedUnitSquareSeenFromAbove) {
    const auto straight_down = [](double x, double y) { return footprint_entry({{x, y, 1}, {0, 0, -1}}); };
    EXPECT_EQ(straight_down(-0.5, 0.5), glm::dvec2(0, 1));
    EXPECT_EQ(straight_down(0.25, -0.25), glm::dvec2(0.75, 0.25));
    EXPECT_FALSE(straight_down(-0.5001, 0));
    EXPECT_FALSE(straight_down(0, 0.5001));
    EXPECT_FALSE(footprint_entry({{0, 0, 1}, {0, 0, 1}}));
    EXPECT_FALSE(footprint_entry({{0, 0, 1}, {1, 0, 0}}));
    EXPECT_FALSE(footprint_entry({{0, 0, -1}, {0, 0, -1}}));
}

TEST(Camera, NamesAreTheConfigurationsWords) {
    EXPECT_EQ(to_string(Projection::perspective), "perspective");
    EXPECT_EQ(to_string(Projection::parallel), "parallel");
    EXPECT_EQ(to_string(Boundary::clip), "clip");
    EXPECT_EQ(to_string(Boundary::repeat), "repeat");
}

}  // namespace
}  // namespace reliefbench
