#include "scene/scene_object.hpp"

#include <gtest/gtest.h>

namespace reliefbench {
namespace {

SceneObject sphere() {
    SceneObject object;
    object.centre = {0.1, 0, -0.05};
    object.radius = 0.25;
    return object;
}

SceneObject box() {
    SceneObject object;
    object.shape = SceneObject::Shape::box;
    object.centre = {0.1, 0, -0.05};
    object.half_size = {0.1, 0.2, 0.3};
    return object;
}

TEST(SceneObject, IsMetOnItsNearSide) {
    const auto on_sphere = intersect(sphere(), {{0.1, 0, 1}, {0, 0, -1}}, Projection::perspective);
    ASSERT_TRUE(on_sphere);
    EXPECT_DOUBLE_EQ(on_sphere->t, 1.05 - 0.25);
    EXPECT_NEAR(on_sphere->normal.z, 1, 1e-15);  // (1.05 − 1.05 + 0.25) / 0.25 rounds
    EXPECT_EQ(glm::dvec2(on_sphere->normal), glm::dvec2(0));
    const auto on_box = intersect(box(), {{1.1, 0.1, -0.2}, {-1, 0, 0}}, Projection::perspective);
    ASSERT_TRUE(on_box);
    EXPECT_DOUBLE_EQ(on_box->t, 0.9);
    EXPECT_EQ(on_box->normal, glm::dvec3(1, 0, 0));
}

TEST(SceneObject, IsMissedBesideIt) {
    EXPECT_FALSE(intersect(sphere(), {{0.36, 0, 1}, {0, 0, -1}}, Projection::perspective));
    EXPECT_FALSE(intersect(box(), {{0.21, 0, 1}, {0, 0, -1}}, Projection::perspective));
    EXPECT_TRUE(intersect(box(), {{0.19, 0.19, 1}, {0, 0, -1}}, Projection::perspective));
    // Past a corner.
    EXPECT_FALSE(intersect(box(), {{0.4, 0.35, 0}, {-0.6, 0.8, 0}}, Projection::perspective));
}

// Parallel rays start at z = 0 and come from above it; those of an eye do not reach back.
TEST(SceneObject, AboveThePolygonIsMetByParallelRays) {
    const auto hit = intersect(sphere(), {{0.1, 0, 0}, {0, 0, -1}}, Projection::parallel);
    ASSERT_TRUE(hit);
    EXPECT_DOUBLE_EQ(hit->t, -0.2);
    EXPECT_FALSE(intersect(sphere(), {{0.1, 0, 0}, {0, 0, -1}}, Projection::perspective));
    EXPECT_FALSE(intersect(box(), {{0.1, 0, 0}, {0, 0, -1}}, Projection::perspective));
}

}  // namespace
}  // namespace reliefbench
