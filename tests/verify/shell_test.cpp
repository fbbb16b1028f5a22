// The pipeline of the shell, by the technique that marches in it, against the exact truth.

#include "broken_shaders.hpp"
#include "core/file.hpp"
#include "verify_test.hpp"

#include <gmock/gmock.h>
#include <glm/geometric.hpp>

#include <cmath>
#include <memory>

namespace reliefbench::test {
namespace {

using testing::HasSubstr;

BaseSurface generated_base(BaseSource::Kind kind, double curvature, int segments) {
    return load_base({.kind = kind, .curvature = curvature, .segments = segments});
}

/// z = 3xy over a square of this size, whose normals turn about every edge of its grid, so that no side of a prism is
/// plane. Two charts of two columns each, which share positions along x = 0 and nothing else; triangles of the second
/// begin with another corner.
BaseSurface twisted_charts(float size) {
    constexpr int rows = 4;
    constexpr int columns_of_chart = 2;
    BaseMesh mesh;
    for (std::uint32_t chart = 0; chart < 2; ++chart) {
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        for (int row = 0; row <= rows; ++row) {
            for (int column = 0; column <= columns_of_chart; ++column) {
                const float u = 0.5f * static_cast<float>(chart) + 0.25f * static_cast<float>(column);
                const float v = 0.25f * static_cast<float>(row);
                const float x = u - 0.5f;
                const float y = v - 0.5f;
                mesh.vertices.push_back({size * glm::vec3(x, y, 3 * x * y),
                                         glm::normalize(glm::vec3(-3 * y, -3 * x, 1)),
                                         glm::vec2(u + 2 * static_cast<float>(chart), v)});
            }
        }
        constexpr std::uint32_t per_row = columns_of_chart + 1;
        for (std::uint32_t row = 0; row < rows; ++row) {
            for (std::uint32_t column = 0; column < columns_of_chart; ++column) {
                const std::uint32_t corner = first + row * per_row + column;
                for (BaseMesh::Triangle triangle :
                     {BaseMesh::Triangle{corner, corner + 1, corner + per_row + 1},
                      BaseMesh::Triangle{corner, corner + per_row + 1, corner + per_row}}) {
                    if (chart == 1) triangle = {triangle[1], triangle[2], triangle[0]};
                    mesh.triangles.push_back(triangle);
                    mesh.charts.push_back(chart);
                }
            }
        }
        mesh.chart_periods.emplace_back(0, 0);
    }
    return {MeshBase{std::make_shared<const BaseMesh>(std::move(mesh))}};
}

/// The plane's two triangles at another size.
BaseSurface scaled_square(float size) {
    BaseMesh mesh = curved_base(triangulated({}));
    for (MeshVertex& vertex : mesh.vertices)
        vertex.position *= size;
    return {MeshBase{std::make_shared<const BaseMesh>(std::move(mesh))}};
}

const ParameterValues fine_steps{{"steps_per_texel", 8.0}, {"max_steps", std::int64_t{4096}}};

/// Pixels whose truth hits, as do all pixels around, and is no tie.
template <typename Body>
void for_each_pixel_well_inside(const Truth& truth, const Body& body) {
    constexpr int margin = 2;
    const Resolution size = truth.hits.size;
    for (int j = margin; j < size.height - margin; ++j) {
        for (int i = margin; i < size.width - margin; ++i) {
            bool inside = truth.footprint.at(i, j) == in_footprint;
            for (int y = -margin; y <= margin && inside; ++y) {
                for (int x = -margin; x <= margin && inside; ++x)
                    inside = truth.hits.at(i + x, j + y).is_hit();
            }
            if (inside) body(i, j);
        }
    }
}

class Shell : public VerifyTest {
protected:
    struct Seams {
        int looked_at = 0;
        /// Missed, or hit farther behind the truth's hit than tetrahedra are off it.
        int torn = 0;
    };

    static Seams seams(const Technique& technique, const CoordinateScene& scene, const View& view,
                       double depth_tolerance) {
        const TruthComparison found =
            compare_with_truth(device(), technique, with_values(technique.manifest, fine_steps), scene, view);
        Seams result;
        for_each_pixel_well_inside(found.truth, [&](int i, int j) {
            ++result.looked_at;
            const Hit& hit = found.probe.hits.at(i, j);
            if (!hit.is_hit() || hit.t - found.truth.hits.at(i, j).t > depth_tolerance) ++result.torn;
        });
        return result;
    }

    static const CoordinateScene& level() {
        static const CoordinateScene scene(device(), map_of({8, 8}, [](int, int) { return 0.5; }));
        return scene;
    }
    static const CoordinateScene& rough() {
        static const CoordinateScene scene(device(), procedural("rock", {32, 32}));
        return scene;
    }
    /// Rough maps may be hit behind a peak that the true ray touches.
    static constexpr double any_depth = 1e9;
};

TEST_F(Shell, ShowsNoSeams) {
    const Technique technique = shipped("shell_march");
    for (const Projection projection : {Projection::perspective, Projection::parallel}) {
        for (const BaseSurface& base :
             {generated_base(BaseSource::Kind::sphere, 2, 8), generated_base(BaseSource::Kind::saddle, -2, 8),
              generated_base(BaseSource::Kind::cylinder, -2, 3), twisted_charts(1)}) {
            View view = perspective_view(60, -67);
            view.camera.projection = projection;
            view.relief.base = base;
            for (const CoordinateScene* scene : {&level(), &rough()}) {
                const Seams found = seams(technique, *scene, view, scene == &level() ? 0.02 : any_depth);
                EXPECT_GT(found.looked_at, 1000);
                EXPECT_EQ(found.torn, 0) << "of " << found.looked_at << ' ' << curved_base(base).name << ' '
                                         << (scene == &level());
            }
        }
    }
}

TEST_F(Shell, ShowsNoSeamsWhereUnitsAreSmall) {
    const Technique technique = shipped("shell_march");
    for (const float size : {0.01f, 100.0f}) {
        View view = perspective_view(60, -67);
        view.camera.distance = 1.5 * double(size);
        view.relief.base = twisted_charts(size);
        view.relief.height_scale = 0.1 * double(size);
        const Seams found = seams(technique, level(), view, 0.02 * double(size));
        EXPECT_GT(found.looked_at, 1000);
        EXPECT_EQ(found.torn, 0) << size;
    }
}

// h = 1 - u is where two tetrahedra meet, in both prisms of the plane: every pixel's hit is between two pieces.
TEST_F(Shell, LosesNoHitBetweenTwoPieces) {
    constexpr int texels = 64;
    Image<float> heights({texels, 4});
    for (int j = 0; j < heights.size.height; ++j) {
        for (int i = 0; i < texels; ++i)
            heights.at(i, j) = 1 - (static_cast<float>(i) + 0.5f) / texels;
    }
    const CoordinateScene ramp(device(), make_height_map(heights, HeightFormat::r32f, "ramp"));
    for (const Projection projection : {Projection::perspective, Projection::parallel}) {
        for (const float size : {0.01f, 1.0f, 100.0f}) {
            View view = perspective_view(50, -67);
            view.camera.projection = projection;
            view.camera.distance = 1.5 * double(size);
            view.resolution = {192, 192};
            view.relief.height_scale = 0.1 * double(size);
            view.relief.base = scaled_square(size);
            const TruthComparison found = compare("shell_march", {}, ramp, view);
            int looked_at = 0;
            int lost = 0;
            for_each_pixel_well_inside(found.truth, [&](int i, int j) {
                // From one end of the patch to the other, texels are blended over the seam.
                const Hit& truth = found.truth.hits.at(i, j);
                if (std::abs(truth.u - 0.5f) > 0.49f) return;
                ++looked_at;
                const Hit& hit = found.probe.hits.at(i, j);
                if (!hit.is_hit() || std::abs(hit.t - truth.t) > 1e-4f * size) ++lost;
            });
            EXPECT_GT(looked_at, 7000);
            EXPECT_EQ(lost, 0) << size;
        }
    }
}

TEST_F(Shell, IsTornByDiagonalsThatItsNeighboursDoNotShare) {
    const BrokenShaders shaders("shell_prism.glsl", "if (a.x != b.x) return a.x < b.x;", "return false;");
    View view = perspective_view(60, -67);
    view.relief.base = twisted_charts(1);
    EXPECT_GT(seams(shaders.compile("shell_march"), level(), view, 0.02).torn, 10);
}

TEST_F(Shell, CoversWhatIsSeenPastThePlanesBorder) {
    for (const double angle : {70.0, 80.0}) {
        View view = perspective_view(angle, -67);
        view.relief.height_scale = 0.2;
        const TruthComparison found = compare("shell_march", fine_steps, rough(), view);
        EXPECT_GT(found.errors.outside_quad_pixels, 500U);
        EXPECT_GE(found.errors.outside_quad_covered.value(), 0.99);
        EXPECT_LT(found.errors.missed + found.errors.false_hits, 0.002);
    }
}

// Chords of a surface without kinks; kinks, along the lines of texel centres, are within one step of another.
TEST_F(Shell, IsOfSecondOrderInItsSteps) {
    View view = perspective_view(70, -67);
    view.relief.height_scale = 0.2;
    const auto error = [&](double steps) {
        const ParameterValues changed{{"steps_per_texel", steps}, {"max_steps", std::int64_t{4096}}};
        return compare("shell_march", changed, rough(), view).errors.uv_texels.value().p50;
    };
    double before = error(1);
    EXPECT_LT(before, 0.03);
    for (const double steps : {2.0, 4.0, 8.0}) {
        const double now = error(steps);
        EXPECT_GT(before / now, 3.5) << steps;
        EXPECT_LT(before / now, 6) << steps;
        before = now;
    }
}

// (u, v, h) is linear in a tetrahedron, where the truth's (h - 1)·H·N has a product of both: along the base that is of
// first order in the length of edges, a quarter of what N changes along one, times H; along the normal of second.
TEST_F(Shell, ComesToTheTruthAsSegmentsAreAdded) {
    constexpr double curvature = 2;
    View view = perspective_view(60, -67);
    double uv_before = 0;
    double depth_before = 0;
    for (const int segments : {8, 16, 32, 64}) {
        view.relief.base = generated_base(BaseSource::Kind::sphere, curvature, segments);
        const HitErrors found = compare("shell_march", fine_steps, level(), view).errors;
        const double lateral = curvature * view.relief.height_scale / (4 * segments) * 8;
        EXPECT_LT(found.uv_texels->p50, lateral) << segments;
        const double depth = std::abs(found.depth->mean);
        if (uv_before > 0) {
            EXPECT_NEAR(uv_before / found.uv_texels->p50, 2, 0.2) << segments;
            EXPECT_NEAR(depth_before / depth, 4, 0.5) << segments;
        }
        uv_before = found.uv_texels->p50;
        depth_before = depth;
    }
}

// Seen from above each ray passes the three tetrahedra of its prism, with one step and two taps in each.
TEST_F(Shell, CountsTheWorkOfAllThatARayPasses) {
    const CoordinateScene floor(device(), map_of({8, 8}, [](int, int) { return 0.0; }));
    const View view = parallel_view(0);
    const TruthComparison found = compare("shell_march", {}, floor, view);
    int looked_at = 0;
    for (int j = 2; j < view.resolution.height - 2; ++j) {
        for (int i = 2; i < view.resolution.width - 2; ++i) {
            // The diagonal between the two prisms belongs to either.
            if (std::abs(i - (view.resolution.height - 1 - j)) < 2) continue;
            ++looked_at;
            const PixelWork& work = found.probe.work.at(i, j);
            EXPECT_EQ(work.taps, 6U) << i << ' ' << j;
            EXPECT_EQ(work.texels, 24U);
            EXPECT_EQ(work.steps, 3U);
        }
    }
    EXPECT_GT(looked_at, 8000);
}

TEST_F(Shell, WritesTheDepthOfWhatItHits) {
    for (const Projection projection : {Projection::perspective, Projection::parallel}) {
        View view = perspective_view(65, -67);
        view.camera.projection = projection;
        view.relief.base = generated_base(BaseSource::Kind::sphere, 2, 6);
        const Technique technique = shipped("shell_march");
        MapPreparation maps;
        Renderer renderer = make_renderer(device(), technique, technique.manifest.defaults(), rough(), view, maps);
        const Probe probe = renderer.probe();
        const TimedPicture picture = renderer.draw_timed(ColourTarget::linear_float);
        const glm::dmat4 clip_of = clip_from_world(view);
        int looked_at = 0;
        for (int j = 0; j < view.resolution.height; ++j) {
            for (int i = 0; i < view.resolution.width; ++i) {
                const Hit& hit = probe.hits.at(i, j);
                if (!hit.is_hit()) {
                    EXPECT_EQ(picture.depth.at(i, j), 1);
                    continue;
                }
                ++looked_at;
                const Ray ray = pixel_ray(view, i, j);
                const glm::dvec4 clip = clip_of * glm::dvec4(ray.origin + double(hit.t) * ray.direction, 1);
                EXPECT_NEAR(picture.depth.at(i, j), clip.z / clip.w, 1e-5);
            }
        }
        EXPECT_GT(looked_at, 1000);
    }
}

TEST_F(Shell, TellsWhatItCannotDraw) {
    const Technique technique = shipped("shell_march");
    const auto reason = [&](const View& view) {
        return unsupported_reason(device(), technique, technique.manifest.defaults(), view, {32, 32});
    };
    const View usual = perspective_view(60);
    EXPECT_EQ(reason(usual), "");
    View view = usual;
    view.self_shadow.mode = SelfShadow::Mode::hard;
    EXPECT_THAT(reason(view), HasSubstr("self-shadowing searches along the light's ray"));
    for (const DepthWrite depth : {DepthWrite::off, DepthWrite::conservative}) {
        view = usual;
        view.depth_write = depth;
        EXPECT_THAT(reason(view), HasSubstr("the nearest is found by its depth"));
    }
    view = usual;
    view.relief.boundary = Boundary::repeat;
    EXPECT_THAT(reason(view), HasSubstr("the shell ends at the border of its patch"));
    view.relief.base = generated_base(BaseSource::Kind::sphere, 1, 4);
    EXPECT_EQ(reason(view), "");
}

/// A technique of the shell that answers this, whatever the ray.
class ShellAnswer {
public:
    explicit ShellAnswer(const std::string& answer) {
        const std::filesystem::path folder = root_.path() / "shell_answer";
        std::filesystem::create_directories(folder);
        write_text_file(folder / "technique.json",
                        R"({"title": "Test", "contract": 2, "kind": "march", "citation": "none", "parameters": [],
                            "shape": "shell", "promises": []})");
        write_text_file(folder / "trace.glsl",
                        "#include \"shell_ray.glsl\"\nTrace trace_shell(ShellRay ray) { " + answer + " }\n");
    }
    Technique load() const { return find_techniques({root_.path()}).get("shell_answer"); }

private:
    TemporaryFolder root_;
};

TEST_F(Shell, RefusesAnswersOutOfRangeAndBesideTheRay) {
    const auto draw = [&](const std::string& answer) {
        compare_with_truth(device(), ShellAnswer(answer).load(), {}, level(), perspective_view(40));
    };
    EXPECT_NO_THROW(draw("return hit_on_ray(1.0, 1);"));
    for (const char* answer : {"return hit_on_ray(1.25, 1);", "return hit_on_ray(-0.25, 1);",
                               "return hit_on_ray(0.5, -1);", "return hit_off_ray(vec2(0.5), 0.5, 1);"})
        EXPECT_THROW(draw(answer), NoPicture) << answer;
}

TEST_F(Shell, IsShadedWithThePolygonsNormalWhereAskedTo) {
    View view = perspective_view(50, -67);
    view.relief.base = generated_base(BaseSource::Kind::sphere, 1.5, 8);
    const auto normals = [&](bool is_flat) {
        const std::string mark = is_flat ? "answer.flat_normal = true; " : "";
        const ShellAnswer answer("Trace answer = ray.from_base ? hit_on_ray(0.0, 0) : miss(0); " + mark +
                                 "return answer;");
        return compare_with_truth(device(), answer.load(), {}, rough(), view).probe;
    };
    const Probe flat = normals(true);
    const Probe relief = normals(false);
    int looked_at = 0;
    int tilted = 0;
    for (int j = 0; j < view.resolution.height; ++j) {
        for (int i = 0; i < view.resolution.width; ++i) {
            const Hit& hit = flat.hits.at(i, j);
            if (!hit.is_hit()) continue;
            ++looked_at;
            const auto vector = [&](const Probe& probe) {
                const auto& normal = probe.normals->at(i, j);
                return glm::dvec3(normal[0], normal[1], normal[2]);
            };
            const Ray ray = pixel_ray(view, i, j);
            // Of a sphere about (0, 0, -1/κ); its facets and their linear normals are off it by (κ/segments)²/8.
            const glm::dvec3 outward = ray.origin + double(hit.t) * ray.direction + glm::dvec3(0, 0, 1 / 1.5);
            EXPECT_LT(glm::length(vector(flat) - glm::normalize(outward)), 0.02);
            if (glm::dot(vector(flat), vector(relief)) < 0.99) ++tilted;
        }
    }
    EXPECT_GT(looked_at, 1000);
    EXPECT_GT(tilted, looked_at / 4);
}

}  // namespace
}  // namespace reliefbench::test
