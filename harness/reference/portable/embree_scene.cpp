#include "reference/embree_scene.hpp"

#include "core/error.hpp"

#include <cassert>

namespace reliefbench {

namespace {

[[noreturn]] void refuse(const std::string& what) {
    fail("this portable build has no Embree, which {} needs: use the base 'plane', or a full build", what);
}

}  // namespace

struct BoxScene::Scene {};
struct TriangleScene::Scene {};

BoxScene::BoxScene(std::span<const Box>, const std::string& what) {
    refuse(what);
}

BoxScene::~BoxScene() = default;
BoxScene::BoxScene(BoxScene&&) noexcept = default;
BoxScene& BoxScene::operator=(BoxScene&&) noexcept = default;

void BoxScene::visit_boxes(const Ray&, void*, double (*)(void*, std::uint32_t)) const {
    assert(false);
}

TriangleScene::TriangleScene(std::span<const Vertex>, const std::string& what) {
    refuse(what);
}

TriangleScene::~TriangleScene() = default;
TriangleScene::TriangleScene(TriangleScene&&) noexcept = default;
TriangleScene& TriangleScene::operator=(TriangleScene&&) noexcept = default;

std::optional<TriangleScene::Met> TriangleScene::first_front(const Ray&) const {
    assert(false);
    return std::nullopt;
}

}  // namespace reliefbench
