// Per-pixel techniques over bases of triangles: against the plane where the base is all but flat, else against the
// base's own geometry.

#include "test_scene.hpp"

#include "scene/shading_normal.hpp"

#include <gmock/gmock.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace reliefbench {
namespace {

using namespace test;
using testing::HasSubstr;
using Files = TemporaryTechnique::Files;

const Resolution map_size{48, 32};

/// Smooth, with slopes that shade one another at grazing angles.
const HeightMap& hilly_map() {
    static const HeightMap map = make_map(map_size, [](int x, int y) {
        return 0.5 + 0.3 * std::sin(0.261799 * x) * std::cos(0.392699 * y) + 0.15 * std::sin(0.785398 * y);
    });
    return map;
}

BaseSurface generated(BaseSource::Kind kind, double curvature, int segments) {
    return load_base({.kind = kind, .curvature = curvature, .segments = segments});
}

/// A parallelogram of `mesh.triangles` from `origin`, whose sides are a unit of u and of v.
void add_parallelogram(BaseMesh& mesh, glm::vec3 origin, glm::vec3 along_u, glm::vec3 along_v, glm::vec2 uv = {0, 0}) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    const bool is_mirrored = glm::cross(along_u, along_v).z < 0;
    const glm::vec3 normal = glm::normalize(glm::cross(along_u, along_v)) * (is_mirrored ? -1.0f : 1.0f);
    for (const glm::vec2 corner : {glm::vec2(0, 0), glm::vec2(1, 0), glm::vec2(1, 1), glm::vec2(0, 1)})
        mesh.vertices.push_back({origin + corner.x * along_u + corner.y * along_v, normal, uv + corner});
    for (BaseMesh::Triangle triangle : {BaseMesh::Triangle{0, 1, 2}, BaseMesh::Triangle{0, 2, 3}}) {
        for (std::uint32_t& corner : triangle)
            corner += first;
        if (is_mirrored) std::swap(triangle[1], triangle[2]);
        mesh.triangles.push_back(triangle);
        mesh.charts.push_back(first / 4);
    }
    mesh.chart_periods.emplace_back(0, 0);
}

BaseSurface surface_of(BaseMesh mesh) {
    return {MeshBase{std::make_shared<const BaseMesh>(std::move(mesh))}};
}

class CurvedBase : public DeviceTest {
protected:
    static const TechniqueLibrary& shipped() {
        static const TechniqueLibrary library = find_techniques({default_technique_root()});
        return library;
    }
    static Probe probe(const Technique& technique, const View& view, const Lighting& lighting = Lighting{},
                       const ParameterValues& parameters = {}) {
        return make_renderer(device(), technique, hills(), view, lighting, parameters).probe();
    }
    static const SceneOnDevice& hills() {
        static const SceneOnDevice scene(device(), hilly_map(), grey_albedo());
        return scene;
    }
};

View slanted_view(Projection projection, double view_angle = 60) {
    View view = make_view(view_angle, projection);
    view.camera.azimuth = -65;
    view.relief.height_scale = 0.08;
    return view;
}

/// Texels between two hits.
double apart(const Hit& one, const Hit& other) {
    return std::hypot((double(one.u) - double(other.u)) * map_size.width,
                      (double(one.v) - double(other.v)) * map_size.height);
}

struct Difference {
    int compared = 0;
    /// Hit by one only, or more than a thousandth of a texel apart.
    int differing = 0;
};

Difference compare(const Probe& flat, const Probe& curved) {
    Difference difference;
    for (std::size_t i = 0; i < flat.hits.texels.size(); ++i) {
        const Hit& one = flat.hits.texels[i];
        const Hit& other = curved.hits.texels[i];
        if (!one.is_hit() && !other.is_hit()) continue;
        ++difference.compared;
        const bool same =
            one.is_hit() == other.is_hit() && apart(one, other) <= 1e-3 && std::abs(one.h - other.h) < 1e-4;
        if (!same) ++difference.differing;
    }
    return difference;
}

// What rounding moves over the edge of a hill lands elsewhere.
constexpr int max_differing = 2;

TEST_F(CurvedBase, ThatIsAllButFlatGivesThePlanesHits) {
    for (const Technique& technique : shipped().techniques) {
        if (technique.manifest.shape.kind != "quad") continue;
        // Of parallel rays the pixels are others, as the picture shows the floor past the base, too.
        View view = slanted_view(Projection::perspective);
        const Probe flat = probe(technique, view);
        view.relief.base = generated(BaseSource::Kind::sphere, 1e-6, 6);
        const Probe curved = probe(technique, view);
        const Difference difference = compare(flat, curved);
        EXPECT_GT(difference.compared, 800) << technique.manifest.id;
        EXPECT_LE(difference.differing, max_differing) << technique.manifest.id;
        EXPECT_TRUE(curved.faults.empty()) << technique.manifest.id;
    }
}

TEST_F(CurvedBase, ThatIsAllButFlatIsShadedAndShadowedAsThePlane) {
    for (const char* method : {"hard", "dykhta", "tatarchuk"}) {
        View view = slanted_view(Projection::perspective, 30);
        view.self_shadow.mode = method == std::string("hard") ? SelfShadow::Mode::hard : SelfShadow::Mode::soft;
        view.self_shadow.soft =
            method == std::string("dykhta") ? SelfShadow::Soft::dykhta : SelfShadow::Soft::tatarchuk;
        Lighting lighting;
        view.relief.height_scale = 0.4;
        lighting.lights = {{.direction = {0.5, 0.6, 0.25}, .colour = {1, 1, 1}}};
        const Probe flat = probe(shipped().get("max_mip"), view, lighting);
        view.relief.base = generated(BaseSource::Kind::saddle, 1e-6, 6);
        const Probe curved = probe(shipped().get("max_mip"), view, lighting);
        ASSERT_TRUE(curved.normals);
        EXPECT_FALSE(flat.normals);
        int shadowed = 0;
        int differing = 0;
        for (std::size_t i = 0; i < flat.hits.texels.size(); ++i) {
            if (!flat.hits.texels[i].is_hit() || !curved.hits.texels[i].is_hit()) continue;
            const auto& visibility = flat.light_visibility.texels[i];
            if (visibility[0] < 0.99f) ++shadowed;
            const bool same = std::abs(visibility[0] - curved.light_visibility.texels[i][0]) < 1e-3f &&
                              std::abs(flat.colour.texels[i][0] - curved.colour.texels[i][0]) < 1e-3f;
            if (!same) ++differing;
        }
        EXPECT_GT(shadowed, 100) << method;
        EXPECT_LE(differing, max_differing) << method;
    }
}

TEST_F(CurvedBase, FadesAndWritesDepthAsThePlane) {
    const Technique& technique = shipped().get("pom");
    for (const DepthWrite depth : {DepthWrite::on, DepthWrite::off, DepthWrite::conservative}) {
        View view = slanted_view(Projection::perspective);
        view.depth_write = depth;
        const ParameterValues fading{
            {"lod_fade", std::string("distance")}, {"lod_fade_end", 1.8}, {"lod_fade_width", 0.8}};
        Renderer flat = make_renderer(device(), technique, hills(), view, Lighting{}, fading);
        const View flat_view = view;
        view.relief.base = generated(BaseSource::Kind::cylinder, 1e-6, 6);
        Renderer curved = make_renderer(device(), technique, hills(), view, Lighting{}, fading);
        EXPECT_LE(compare(flat.probe(), curved.probe()).differing, max_differing);
        const TimedPicture flat_picture = flat.draw_timed(ColourTarget::linear_float);
        const TimedPicture picture = curved.draw_timed(ColourTarget::linear_float);
        // The near planes differ: what is compared is the depth along the view.
        const auto view_depth = [](const View& of, float stored) {
            const double cosine = cosine_of_picture_corner(of.camera, of.resolution);
            return nearest_depth(of.relief.base, of.camera, of.relief.height_scale, cosine) / 2 / (1 - double(stored));
        };
        int differing = 0;
        for (std::size_t i = 0; i < picture.depth.texels.size(); ++i) {
            if (flat_picture.depth.texels[i] == 1 || picture.depth.texels[i] == 1) continue;
            const double before = view_depth(flat_view, flat_picture.depth.texels[i]);
            if (std::abs(before - view_depth(view, picture.depth.texels[i])) > 1e-5) ++differing;
        }
        EXPECT_LE(differing, max_differing);
    }
}

struct BruteEntry {
    glm::dvec2 uv;
    double t = 0;
    glm::dvec3 normal;
    /// Smallest barycentric coordinate: what lies on an edge may belong to either side.
    double inside = 0;
};

/// The nearest front face that the ray meets, by trying all.
std::optional<BruteEntry> brute_entry(const BaseMesh& mesh, const Ray& ray) {
    std::optional<BruteEntry> nearest;
    for (const BaseMesh::Triangle& corners : mesh.triangles) {
        const MeshVertex& a = mesh.vertices[corners[0]];
        const MeshVertex& b = mesh.vertices[corners[1]];
        const MeshVertex& c = mesh.vertices[corners[2]];
        const glm::dvec3 side = glm::dvec3(b.position) - glm::dvec3(a.position);
        const glm::dvec3 other = glm::dvec3(c.position) - glm::dvec3(a.position);
        const glm::dvec3 facet = glm::cross(side, other);
        const double descent = -glm::dot(facet, ray.direction);
        if (descent <= 0) continue;
        const glm::dvec3 from = ray.origin - glm::dvec3(a.position);
        const double t = glm::dot(facet, from) / descent;
        const glm::dvec3 moment = glm::cross(from, -ray.direction);
        const double along = -glm::dot(other, moment) / descent;
        const double across = glm::dot(side, moment) / descent;
        const double inside = std::min({along, across, 1 - along - across});
        if (inside < 0 || (nearest && nearest->t < t)) continue;
        const auto mixed = [&](auto of_a, auto of_b, auto of_c) {
            return of_a + along * (of_b - of_a) + across * (of_c - of_a);
        };
        nearest = BruteEntry{
            .uv = mixed(glm::dvec2(a.uv), glm::dvec2(b.uv), glm::dvec2(c.uv)),
            .t = t,
            .normal = glm::normalize(mixed(glm::dvec3(a.normal), glm::dvec3(b.normal), glm::dvec3(c.normal))),
            .inside = inside};
    }
    return nearest;
}

TEST_F(CurvedBase, IsEnteredWhereThePixelsRayMeetsItsTriangles) {
    const TemporaryTechnique folder(Files{{"trace.glsl",
                                           "Trace trace(ReliefRay ray) { Trace polygon = hit_off_ray(ray.uv, 1.0, 0);\n"
                                           "polygon.flat_normal = true; return polygon; }\n"},
                                          {"technique.json", manifest_json("", R"(, "contract": 2)")}});
    const Technique technique = folder.load();
    for (const BaseSource::Kind kind :
         {BaseSource::Kind::cylinder, BaseSource::Kind::sphere, BaseSource::Kind::saddle}) {
        for (const Projection projection : {Projection::perspective, Projection::parallel}) {
            for (const double curvature : {-2.0, 3.0}) {
                View view = slanted_view(projection, 70);
                view.relief.boundary = Boundary::repeat;
                view.relief.base = generated(kind, curvature, 12);
                const Probe drawn = probe(technique, view);
                const PixelRays rays = pixel_rays(view);
                int compared = 0;
                int differing = 0;
                for (int j = 0; j < view.resolution.height; ++j) {
                    for (int i = 0; i < view.resolution.width; ++i) {
                        const Hit& hit = drawn.hits.at(i, j);
                        const auto entry = brute_entry(curved_base(view.relief.base), rays.at(i, j));
                        const bool seen = entry && glm::dot(entry->normal, rays.at(i, j).direction) < 0;
                        if (seen != hit.is_hit()) {
                            // Snapped corners, or the outline of N·V = 0.
                            ++differing;
                            continue;
                        }
                        if (!seen || entry->inside < 0.02) continue;
                        ++compared;
                        EXPECT_NEAR(hit.u, entry->uv.x, 1e-5);
                        EXPECT_NEAR(hit.v, entry->uv.y, 1e-5);
                        EXPECT_NEAR(hit.t, entry->t, 1e-5);
                        const auto& normal = drawn.normals->at(i, j);
                        EXPECT_LT(glm::length(glm::dvec3(normal[0], normal[1], normal[2]) - entry->normal), 1e-5);
                    }
                }
                EXPECT_GT(compared, 300);
                EXPECT_LE(differing, 12);
            }
        }
    }
}

// On a flat parallelogram the tangent plane is the base: whatever its chart, an exact search meets the surface, and the
// ray is there where it says.
TEST_F(CurvedBase, OfStretchedSkewedAndMirroredChartsIsHitOnTheSurface) {
    struct Chart {
        glm::vec3 along_u;
        glm::vec3 along_v;
    };
    const glm::vec3 middle{0.02, -0.03, 0.1};
    for (const Chart& chart : {Chart{{1.2, 0, 0}, {0, 0.4, 0}}, Chart{{0.9, 0.1, 0.2}, {0.5, 0.7, -0.1}},
                               Chart{{-0.8, 0.1, 0}, {0.3, 0.9, 0.2}}}) {
        BaseMesh mesh;
        mesh.is_unit_square = true;
        add_parallelogram(mesh, middle - (chart.along_u + chart.along_v) / 2.0f, chart.along_u, chart.along_v);
        for (const Projection projection : {Projection::perspective, Projection::parallel}) {
            View view = slanted_view(projection, 50);
            view.relief.base = surface_of(mesh);
            Renderer renderer = make_renderer(device(), shipped().get("max_mip"), hills(), view);
            const Probe drawn = renderer.probe();
            const TimedPicture picture = renderer.draw_timed(ColourTarget::linear_float);
            const PixelRays rays = pixel_rays(view);
            const glm::dmat4 clip_of = clip_from_world(view);
            int compared = 0;
            for (int j = 0; j < view.resolution.height; ++j) {
                for (int i = 0; i < view.resolution.width; ++i) {
                    const Hit& hit = drawn.hits.at(i, j);
                    if (!hit.is_hit()) continue;
                    ++compared;
                    const BaseTriangle triangle = base_triangle(*std::get<MeshBase>(view.relief.base.kind).mesh, 0);
                    const glm::dvec2 uv(hit.u, hit.v);
                    const glm::dvec3 normal = glm::normalize(triangle.linear_normal(uv));
                    const glm::dvec3 point =
                        triangle.point(uv) + (double(hit.h) - 1) * view.relief.height_scale * normal;
                    const Ray ray = rays.at(i, j);
                    EXPECT_LT(glm::length(point - (ray.origin + double(hit.t) * ray.direction)), 1e-5);
                    EXPECT_NEAR(hit.h, hilly_map().sample(hit.u, hit.v), 2e-4);
                    const glm::dvec4 clip = clip_of * glm::dvec4(point, 1);
                    EXPECT_NEAR(picture.depth.at(i, j), clip.z / clip.w, 1e-5);
                    const auto& shaded = drawn.normals->at(i, j);
                    const glm::dvec3 expected = relief_normal(
                        triangle, uv, 0, shading_slope(height_derivatives(hilly_map()), view.relief, uv.x, uv.y));
                    EXPECT_LT(glm::length(glm::dvec3(shaded[0], shaded[1], shaded[2]) - expected), 5e-3);
                }
            }
            EXPECT_GT(compared, 300);
        }
    }
}

/// Where the ray meets the floor of a relief of constant height, `below` under a cylinder of curvature κ that is bent
/// along v: v, or nothing.
std::optional<double> v_on_cylinder(const Ray& ray, double curvature, double below) {
    const double radius = 1 / curvature - below;
    const glm::dvec2 from(ray.origin.y, ray.origin.z + 1 / curvature);
    const glm::dvec2 way(ray.direction.y, ray.direction.z);
    const double half = glm::dot(from, way);
    const double discriminant = half * half - glm::dot(way, way) * (glm::dot(from, from) - radius * radius);
    if (discriminant < 0) return std::nullopt;
    const glm::dvec2 point = from - way * ((half + std::sqrt(discriminant)) / glm::dot(way, way));
    return std::atan2(point.x, point.y) / curvature + 0.5;
}

// Of a constant map, across the bend: what the models leave of the tangent plane's error. Predicted from the ray's
// series for κ = 1, h = 0.3, H = 0.05 at 60 degrees: 0.41 to 0.44 with the height bent, 0.01 to 0.07 with the way bent,
// too.
TEST_F(CurvedBase, IsFollowedToSecondOrderByBentRays) {
    const TemporaryTechnique folder(
        Files{{"trace.glsl", "Trace trace(ReliefRay ray) { return hit_on_ray(s_at_height(ray, 0.3), 1); }\n"},
              {"technique.json", manifest_json("", R"(, "contract": 2, "include": ["ray_model.json"])")}});
    const Technique technique = folder.load();
    const HeightMap constant = make_map(
        {4, 4}, [](int, int) { return 0.3; }, HeightFormat::r32f);
    const SceneOnDevice scene(device(), constant, grey_albedo());
    View view = make_view(60, Projection::perspective);
    view.relief.boundary = Boundary::repeat;
    view.relief.base = generated(BaseSource::Kind::cylinder, 1, 512);
    std::map<std::string, double> error;
    for (const char* model : {"straight", "quadric", "quadric_uv"}) {
        const Probe drawn =
            make_renderer(device(), technique, scene, view, Lighting{}, {{"ray_model", std::string(model)}}).probe();
        const PixelRays rays = pixel_rays(view);
        int compared = 0;
        for (int j = 0; j < view.resolution.height; ++j) {
            for (int i = 0; i < view.resolution.width; ++i) {
                const Hit& hit = drawn.hits.at(i, j);
                const auto v = v_on_cylinder(rays.at(i, j), 1, 0.7 * view.relief.height_scale);
                if (!hit.is_hit() || !v) continue;
                ++compared;
                EXPECT_NEAR(hit.h, 0.3, 1e-5);
                error[model] += std::abs(double(hit.v) - *v);
            }
        }
        ASSERT_GT(compared, 500);
        error[model] /= compared;
    }
    EXPECT_GT(error["straight"], 1e-3);
    EXPECT_NEAR(error["quadric"] / error["straight"], 0.43, 0.05);
    EXPECT_LT(error["quadric_uv"] / error["straight"], 0.08);
}

// The same bent base under a skewed and stretched chart: the shape operator of (u, v) is not symmetric there.
TEST_F(CurvedBase, BendsRaysAlikeUnderWhateverChart) {
    const TemporaryTechnique folder(
        Files{{"trace.glsl", "Trace trace(ReliefRay ray) { return hit_on_ray(s_at_height(ray, 0.3), 1); }\n"},
              {"technique.json", manifest_json("", R"(, "contract": 2, "include": ["ray_model.json"])")}});
    const Technique technique = folder.load();
    View view = slanted_view(Projection::perspective);
    view.relief.boundary = Boundary::repeat;
    const ParameterValues bent{{"ray_model", std::string("quadric_uv")}};
    BaseMesh mesh = curved_base(generated(BaseSource::Kind::cylinder, 1.5, 24));
    view.relief.base = surface_of(mesh);
    const Probe before = probe(technique, view, Lighting{}, bent);
    const auto charted = [](auto u, auto v) { return glm::vec2(3 * float(u) + 2 * float(v), 0.5f * float(v)); };
    for (MeshVertex& vertex : mesh.vertices)
        vertex.uv = charted(vertex.uv.x, vertex.uv.y);
    view.relief.base = surface_of(mesh);
    const Probe after = probe(technique, view, Lighting{}, bent);
    int compared = 0;
    for (std::size_t i = 0; i < before.hits.texels.size(); ++i) {
        const Hit& hit = before.hits.texels[i];
        const Hit& moved = after.hits.texels[i];
        if (!hit.is_hit() || !moved.is_hit()) continue;
        ++compared;
        const glm::vec2 expected = charted(hit.u, hit.v);
        EXPECT_NEAR(moved.u, expected.x, 1e-4);
        EXPECT_NEAR(moved.v, expected.y, 1e-4);
        EXPECT_NEAR(moved.t, hit.t, 1e-5);
    }
    EXPECT_GT(compared, 500);
}

TEST_F(CurvedBase, ShowsTheNextFrontFaceWhereTheFirstIsMissed) {
    const TemporaryTechnique folder(Files{{"trace.glsl",
                                           "Trace trace(ReliefRay ray) { if (ray.uv.x < 1.0) return miss(3);\n"
                                           "return hit_on_ray(0.0, 5); }\n"},
                                          {"technique.json", manifest_json("", R"(, "contract": 2)")}});
    BaseMesh mesh;
    add_parallelogram(mesh, {-0.5, -0.5, 0.1}, {1, 0, 0}, {0, 1, 0});
    add_parallelogram(mesh, {-0.5, -0.5, -0.1}, {1, 0, 0}, {0, 1, 0}, {1, 0});
    View view = make_view(0, Projection::parallel);
    view.relief.boundary = Boundary::repeat;
    view.relief.base = surface_of(mesh);
    const Probe drawn = probe(folder.load(), view);
    const Hit& hit = drawn.hits.at(32, 32);
    EXPECT_NEAR(hit.u, 1.5, 0.02);
    EXPECT_NEAR(hit.t, 0.2, 1e-5);
    EXPECT_EQ(drawn.work.at(32, 32).steps, 8U);
}

// A chart of any shape: the bent patch without a quarter of it.
TEST_F(CurvedBase, EndsWhereTheChartEndsThatThePixelEnters) {
    View view = slanted_view(Projection::perspective, 50);
    view.relief.height_scale = 0.2;
    BaseMesh mesh = curved_base(generated(BaseSource::Kind::cylinder, 1, 16));
    mesh.is_unit_square = false;
    std::erase_if(mesh.triangles, [&](const BaseMesh::Triangle& corners) {
        const glm::vec2 middle =
            (mesh.vertices[corners[0]].uv + mesh.vertices[corners[1]].uv + mesh.vertices[corners[2]].uv) / 3.0f;
        return middle.x > 0.5f && middle.y > 0.5f;
    });
    mesh.charts.resize(mesh.triangles.size());
    view.relief.base = surface_of(mesh);
    const Probe clipped = probe(shipped().get("max_mip"), view);
    view.relief.boundary = Boundary::repeat;
    const Probe open = probe(shipped().get("max_mip"), view);
    int beyond = 0;
    int within = 0;
    for (std::size_t i = 0; i < open.hits.texels.size(); ++i) {
        const Hit& hit = open.hits.texels[i];
        if (!hit.is_hit()) continue;
        // By how much it lies outside of the L.
        const float outside = std::max({-hit.u, -hit.v, hit.u - 1, hit.v - 1, std::min(hit.u - 0.5f, hit.v - 0.5f)});
        if (std::abs(outside) < 1e-5f) continue;
        EXPECT_EQ(clipped.hits.texels[i].is_hit(), outside < 0) << hit.u << ' ' << hit.v;
        ++(outside < 0 ? within : beyond);
    }
    EXPECT_GT(within, 300);
    EXPECT_GT(beyond, 50);
}

TEST_F(CurvedBase, IsTheSameByItsChartAsByTheUnitSquare) {
    View view = slanted_view(Projection::perspective, 30);
    view.relief.height_scale = 0.3;
    view.self_shadow.mode = SelfShadow::Mode::hard;
    Lighting lighting;
    lighting.lights = {{.direction = {0.5, 0.6, 0.25}, .colour = {1, 1, 1}}};
    BaseMesh mesh = curved_base(generated(BaseSource::Kind::sphere, 0.5, 8));
    view.relief.base = surface_of(mesh);
    const Probe square = probe(shipped().get("max_mip"), view, lighting);
    mesh.is_unit_square = false;
    view.relief.base = surface_of(mesh);
    const Probe charted = probe(shipped().get("max_mip"), view, lighting);
    int shadowed = 0;
    int differing = 0;
    for (std::size_t i = 0; i < square.hits.texels.size(); ++i) {
        const bool same = square.hits.texels[i] == charted.hits.texels[i] &&
                          square.light_visibility.texels[i] == charted.light_visibility.texels[i];
        if (!same) ++differing;
        if (square.light_visibility.texels[i][0] < 1) ++shadowed;
    }
    EXPECT_GT(shadowed, 50);
    EXPECT_LE(differing, 6);
}

TEST_F(CurvedBase, IsNotDrawnByTechniquesOfContract1) {
    const TemporaryTechnique folder(Files{{"trace.glsl", flat_trace}});
    View view = slanted_view(Projection::perspective);
    const Technique technique = folder.load();
    EXPECT_EQ(unsupported_reason(device(), technique, {}, view, map_size), "");
    view.relief.base = generated(BaseSource::Kind::sphere, 1, 4);
    EXPECT_THAT(unsupported_reason(device(), technique, {}, view, map_size), HasSubstr("contract 1"));
}

}  // namespace
}  // namespace reliefbench
