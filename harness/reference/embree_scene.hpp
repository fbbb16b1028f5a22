#pragma once

#include "scene/ray.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>

namespace reliefbench {

/// An axis-aligned box in single precision.
struct Box {
    std::array<float, 3> low;
    std::array<float, 3> high;
};

/// Boxes in a hierarchy (Embree's, user primitives), visited along rays from near to far. Single precision: boxes have
/// to be widened by whoever cannot do with that. The portable build has no Embree: there the constructor throws Error.
/// Immutable after construction: any number of threads may visit.
class BoxScene {
public:
    /// `what` is for the Error's message where the memory does not do: "the relief over 'mesh.obj'". Does not refer to
    /// the boxes afterwards.
    BoxScene(std::span<const Box> boxes, const std::string& what);
    ~BoxScene();
    BoxScene(BoxScene&&) noexcept;
    BoxScene& operator=(BoxScene&&) noexcept;

    /// Calls visit(index) for boxes that the ray meets from t = 0 on up to what the last call returned: the t beyond
    /// which nothing matters any more. Roughly from near to far; a box may come twice.
    template <typename Visit>
    void visit(const Ray& ray, Visit&& visit) const {
        visit_boxes(ray, &visit,
                    [](void* visitor, std::uint32_t box) -> double { return (*static_cast<Visit*>(visitor))(box); });
    }

private:
    void visit_boxes(const Ray& ray, void* visitor, double (*call)(void* visitor, std::uint32_t box)) const;

    struct Scene;
    std::unique_ptr<Scene> scene_;
};

/// Triangles in a hierarchy (Embree's own, robust, single precision). The portable build has no Embree: there the
/// constructor throws Error.
class TriangleScene {
public:
    using Vertex = std::array<float, 3>;

    /// Three vertices each, counterclockwise as seen from their front.
    TriangleScene(std::span<const Vertex> vertices, const std::string& what);
    ~TriangleScene();
    TriangleScene(TriangleScene&&) noexcept;
    TriangleScene& operator=(TriangleScene&&) noexcept;

    struct Met {
        std::uint32_t triangle = 0;
        double t = 0;
    };
    /// The first triangle that the ray meets from its front, from t = 0 on.
    std::optional<Met> first_front(const Ray& ray) const;

private:
    struct Scene;
    std::unique_ptr<Scene> scene_;
};

}  // namespace reliefbench
