// Rays that bend (ray_model), without a curved base: over the plane they are bent by hand, differently in every pixel,
// and each technique is held to a dense march along the same parabola that shares nothing with the shaders.

#include "verify_test.hpp"

#include "core/statistics.hpp"

#include <gmock/gmock.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace reliefbench::test {
namespace {

/// The bend grows along u and passes 1/4, from which on rays leave through the top; the way's grows along v.
constexpr double largest_bend = 0.8;
constexpr glm::dvec2 largest_uv_bend{0.05, -0.035};

/// Of the pixel at `entry`, in patch coordinates.
double bend_at(glm::dvec2 entry) {
    return largest_bend * (2 * entry.x - 1);
}

glm::dvec2 uv_bend_at(glm::dvec2 entry) {
    return largest_uv_bend * (2 * entry.y - 1);
}

/// The technique with those rays; `bend` is what is written for the height's.
BrokenCopy bent(const std::string& id, bool way_bends, const std::string& bend = "(1.6 * view_entry(uv).x - 0.8)",
                std::vector<Replacement> more = {}) {
    const std::string way = way_bends ? "(2.0 * view_entry(uv).y - 1.0) * vec2(0.05, -0.035)" : "vec2(0.0)";
    more.push_back(
        {"relief_ray.glsl",
         "#if defined(HAND_CURVATURE_CONSTANT) || defined(HAND_CURVATURE_PER_AXIS) || \\\n"
         "    (defined(RELIEFBENCH_CURVED) && (defined(RAY_MODEL_QUADRIC) || defined(RAY_MODEL_QUADRIC_UV)))",
         "#if 1"});
    more.push_back({"plane_ray.glsl", "ReliefRay plane_ray(",
                    "vec2 view_entry(vec2 uv) { return uv / scene.tiling; }\nReliefRay plane_ray("});
    more.push_back({"plane_ray.glsl", "dot(way, hand_fall() * way) / (2.0 * scene.height_scale)", "0.0"});
    more.push_back({"quad.frag", "bend_ray(ray, bend_of(ray.straight_offset), uv_bend_of(ray.straight_offset))",
                    "bend_ray(ray, " + bend + ", " + way + ")"});
    return {id, more};
}

constexpr double missed = -1;

struct BentRay {
    glm::dvec2 uv;
    glm::dvec2 offset;
    double bend;
    glm::dvec2 uv_bend;

    double end() const { return bend > 0.25 ? 1 / bend : 2 / (1 + std::sqrt(1 - 4 * bend)); }
    double height(double s) const { return 1 - s + bend * s * s; }

    /// Of a point of the ray: of the two at its height the one over its coordinates, by which it is then sharpened, as
    /// heights say little where the ray turns.
    double parameter_of(const Hit& hit) const {
        const glm::dvec2 found{hit.u, hit.v};
        const double depth = 1 - static_cast<double>(hit.h);
        const double root = std::sqrt(std::max(1 - 4 * bend * depth, 0.0));
        double s = 2 * depth / (1 + root);
        if (bend > 0 && root < 1) {
            const double second = (1 + root) / (2 * bend);
            if (glm::length(place(second) - found) < glm::length(place(s) - found)) s = second;
        }
        for (int step = 0; step < 3; ++step) {
            const glm::dvec2 speed = offset + 2 * s * uv_bend;
            s -= glm::dot(place(s) - found, speed) / glm::dot(speed, speed);
        }
        return s;
    }
    glm::dvec2 place(double s) const { return uv + s * offset + s * s * uv_bend; }
    double gap(const HeightMap& map, double s) const {
        const glm::dvec2 at = place(s);
        return height(s) - map.sample(at.x, at.y);
    }
};

/// Looks so often that nothing wider than a sixteenth of a texel is passed by.
double first_crossing(const HeightMap& map, const BentRay& ray) {
    if (ray.gap(map, 0) <= 1e-6) return 0;
    const double end = ray.end();
    const Resolution size = map.heights.size;
    const double speed = std::max(glm::length(ray.offset), glm::length(ray.offset + 2 * end * ray.uv_bend));
    const int looks = 1024 + static_cast<int>(16 * speed * end * std::max(size.width, size.height));
    double above = 0;
    for (int i = 1; i <= looks; ++i) {
        double beneath = end * i / looks;
        if (ray.gap(map, beneath) > 0) {
            above = beneath;
            continue;
        }
        if (i == looks && ray.bend > 0.25) break;
        for (int halving = 0; halving < 40; ++halving) {
            const double middle = 0.5 * (above + beneath);
            (ray.gap(map, middle) > 0 ? above : beneath) = middle;
        }
        return beneath;
    }
    return ray.bend > 0.25 ? missed : end;
}

/// What a technique found beside the first crossing, by pixel: s, and how far a unit of s is in texels there.
struct Found {
    double found = missed;
    double wanted = missed;
    double texels_per_s = 0;
    double bend = 0;

    bool both() const { return found >= 0 && wanted >= 0; }
    double texels_beyond() const { return (found - wanted) * texels_per_s; }
};

class BentRays : public VerifyTest {
protected:
    static View view_of_rays(double angle, double azimuth) {
        View view = parallel_view(angle, azimuth);
        view.resolution = {64, 64};
        view.relief.boundary = Boundary::repeat;
        view.relief.tiling = 1;
        return view;
    }

    static std::vector<Found> search(const Technique& technique, const ParameterValues& changed, const HeightMap& map,
                                     const View& view, bool way_bends) {
        const CoordinateScene scene(device(), map);
        const Probe probe =
            compare_with_truth(device(), technique, with_values(technique.manifest, changed), scene, view).probe;
        const double angle = view.camera.view_angle * std::numbers::pi / 180;
        const double azimuth = view.camera.azimuth * std::numbers::pi / 180;
        const glm::dvec2 offset =
            -view.relief.height_scale * std::tan(angle) * glm::dvec2(std::cos(azimuth), std::sin(azimuth));
        std::vector<Found> all;
        for (int j = 0; j < view.resolution.height; ++j) {
            for (int i = 0; i < view.resolution.width; ++i) {
                const glm::dvec2 entry{(i + 0.5) / view.resolution.width, 1 - (j + 0.5) / view.resolution.height};
                const BentRay ray{entry, offset, bend_at(entry), way_bends ? uv_bend_at(entry) : glm::dvec2(0)};
                Found found;
                const Hit& hit = probe.hits.at(i, j);
                if (hit.is_hit()) found.found = ray.parameter_of(hit);
                found.wanted = first_crossing(map, ray);
                const Resolution size = map.heights.size;
                const glm::dvec2 speed = ray.offset + 2 * std::max(found.wanted, 0.0) * ray.uv_bend;
                found.texels_per_s = std::hypot(speed.x * size.width, speed.y * size.height);
                found.bend = ray.bend;
                all.push_back(found);
            }
        }
        return all;
    }
};

struct Summary {
    double false_hits = 0;  // of pixels
    double missed_hits = 0;
    double beyond = 0;  // by more than half a texel
    double p99 = 0;     // texels
};

Summary summarise(const std::vector<Found>& all) {
    Summary summary;
    std::vector<double> errors;
    const double part = 1.0 / static_cast<double>(all.size());
    for (const Found& found : all) {
        if (found.found >= 0 && found.wanted < 0) summary.false_hits += part;
        if (found.found < 0 && found.wanted >= 0) summary.missed_hits += part;
        if (!found.both()) continue;
        errors.push_back(std::abs(found.texels_beyond()));
        if (found.texels_beyond() > 0.5) summary.beyond += part;
    }
    std::ranges::sort(errors);
    summary.p99 = errors[errors.size() * 99 / 100];
    return summary;
}

/// Of a technique that answers in front of the surface where its map resolves no more: only what it passes is wrong.
constexpr double stops_short = 1e9;

/// Of a technique with so many steps that what is left is its own way to answer.
struct Case {
    const char* id;
    ParameterValues changed;
    /// Largest error of s over a constant height.
    double s_error;
    /// Limits over maps: of the 99th percentile in texels, and of the pixels that find nothing or pass a crossing.
    double p99;
    double wrong;
};

const std::vector<Case>& cases() {
    static const std::vector<Case> all = [] {
        const ParameterValues layers{{"adaptive", false}, {"max_steps", std::int64_t{512}}};
        const ParameterValues steps{{"max_steps", std::int64_t{512}}};
        const ParameterValues slices{{"max_steps", std::int64_t{512}}, {"slices", std::int64_t{64}}};
        const ParameterValues falling{{"preparation", std::string("falling_edges")}};
        return std::vector<Case>{{"steep", layers, 0.01, 0.15, 0.002},
                                 {"pom", layers, 1e-4, 0.01, 0.002},
                                 {"relief", layers, 1e-3, 0.002, 0.002},
                                 {"secant", layers, 1e-4, 5e-4, 0.002},
                                 {"contact_refinement", layers, 1e-3, 0.002, 0.002},
                                 {"max_mip", {}, 1e-4, 1e-4, 0},
                                 {"qdm", {}, 1e-4, 1e-4, 0},
                                 {"robust_cone", {}, 0.005, 0.004, 0.001},
                                 {"robust_cone", falling, 0.005, 0.004, 0.001},
                                 {"cone_step", steps, 0.04, 0.4, 0.006},
                                 {"quad_cone", steps, 0.04, 0.6, 0.012},
                                 {"relaxed_cone", steps, 0.01, 0.02, 0.012},
                                 {"distance_map", slices, 1, stops_short, 0.001}};
    }();
    return all;
}

// 1 - s + bend * s^2 = 0.3: the ray that turns above it misses. A way that bends changes nothing.
TEST_F(BentRays, MeetAConstantHeightWhereTheParabolaDoes) {
    const HeightMap map = map_of({32, 32}, [](int, int) { return 0.3; });
    const double depth = 1 - map.heights.at(0, 0);
    for (const Case& tried : cases()) {
        if (tried.p99 >= stops_short) continue;
        const BrokenCopy copy = bent(tried.id, true);
        int misses = 0;
        for (const Found& found : search(copy.technique(), tried.changed, map, view_of_rays(65, -67), true)) {
            const double discriminant = 1 - 4 * found.bend * depth;
            if (std::abs(discriminant) < 0.1) continue;
            if (discriminant < 0) {
                EXPECT_LT(found.found, 0) << tried.id << " at a bend of " << found.bend;
                ++misses;
            } else {
                const double s = 2 * depth / (1 + std::sqrt(discriminant));
                EXPECT_NEAR(found.found, s, tried.s_error) << tried.id << " at a bend of " << found.bend;
            }
            if (HasFailure()) return;
        }
        EXPECT_GT(misses, 500);
    }
}

void expect_first_crossings(const std::vector<Found>& all, const Case& tried, const std::string& what) {
    const Summary summary = summarise(all);
    // What the march finds nothing of is grazed by less than it sees.
    if (tried.p99 < stops_short) {
        EXPECT_LE(summary.false_hits, 0.002) << what;
    }
    EXPECT_LE(summary.missed_hits, tried.wrong) << what;
    EXPECT_LE(summary.beyond, tried.wrong) << what;
    EXPECT_LE(summary.p99, tried.p99) << what;
}

TEST_F(BentRays, OfHeightAndWayFindTheFirstCrossing) {
    for (const Case& tried : cases()) {
        for (const bool way_bends : {false, true}) {
            const BrokenCopy copy = bent(tried.id, way_bends);
            // At 8 degrees ways along v turn back.
            for (const auto& [name, azimuth] : {std::pair("rock", 8.0), std::pair("cobbles", -67.0)}) {
                const std::string what = std::string(tried.id) + " on " + name + (way_bends ? ", way bent" : "");
                expect_first_crossings(search(copy.technique(), tried.changed, procedural(name, {96, 64}),
                                              view_of_rays(65, azimuth), way_bends),
                                       tried, what);
            }
        }
    }
}

// Thin features that a ray passes on its way up again.
TEST_F(BentRays, PassNoNeedleByHierarchyOrRobustCones) {
    for (const Case& tried : cases()) {
        const std::string id = tried.id;
        if (id != "max_mip" && id != "qdm" && id != "robust_cone") continue;
        const BrokenCopy copy = bent(id, true);
        const HeightMap map = procedural("spikes", {96, 64});
        for (const double azimuth : {-90.0, 8.0}) {
            const std::vector<Found> all =
                search(copy.technique(), tried.changed, map, view_of_rays(65, azimuth), true);
            EXPECT_LE(summarise(all).beyond, tried.wrong) << id;
            EXPECT_LE(summarise(all).missed_hits, tried.wrong) << id;
        }
    }
}

TEST_F(BentRays, LinearRefinementConvergesAtSecondOrder) {
    const BrokenCopy copy = bent("pom", true);
    const HeightMap map = procedural("waves", {256, 256});
    const auto error = [&](std::int64_t layers) {
        std::vector<Found> all =
            search(copy.technique(), {{"adaptive", false}, {"max_steps", layers}}, map, view_of_rays(60, -67), true);
        std::erase_if(all, [](const Found& found) { return !found.both(); });
        std::vector<double> errors;
        for (const Found& found : all)
            errors.push_back(std::abs(found.texels_beyond()));
        return median(errors);
    };
    EXPECT_NEAR(error(32) / error(64), 4, 0.8);
}

// That a wrong bend, and a bound that forgets where the ray is lowest, are seen.
TEST_F(BentRays, WithTheWrongSignOrBoundFail) {
    const HeightMap map = procedural("rock", {96, 64});
    const auto summary_of = [&](const char* id, const Replacement& mutation, const ParameterValues& changed) {
        const BrokenCopy copy = bent(id, true, "(1.6 * view_entry(uv).x - 0.8)", {mutation});
        return summarise(search(copy.technique(), changed, map, view_of_rays(65, 8), true));
    };
    const Replacement sign{"relief_ray.glsl", "1.0 - s * (1.0 - ray.bend * s)", "1.0 - s * (1.0 + ray.bend * s)"};
    EXPECT_GT(summary_of("max_mip", sign, {}).p99, 1);
    const Replacement way{"relief_ray.glsl", "(ray.straight_offset + s * ray.uv_bend)",
                          "(ray.straight_offset - s * ray.uv_bend)"};
    EXPECT_GT(summary_of("relief", way, {}).p99, 1);
    const Replacement bound{"bent_way.glsl", "clamp(lowest_of_ray(ray), s, s_end)", "s_end"};
    EXPECT_GT(summary_of("max_mip", bound, {}).missed_hits, 0.005);
    const Replacement cone{"cone_march.glsl", "length(ray.uv_bend) - ratio * ray.bend", "-0.5"};
    EXPECT_GT(summary_of("robust_cone", cone, {{"minimum_step", false}, {"refinement", std::string("none")}}).beyond,
              0.005);
}

}  // namespace
}  // namespace reliefbench::test
