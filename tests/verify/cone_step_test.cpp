#include "cone_maps.hpp"
#include "verify_test.hpp"

#include "verify/promise_checks.hpp"

#include <cmath>

namespace reliefbench::test {

namespace {

using namespace std::string_literals;

/// Bilinear, at texture coordinates, across repeats.
double filtered(const Ratios& texels, glm::dvec2 uv) {
    const glm::dvec2 place = uv * glm::dvec2(texels.size.width, texels.size.height) - 0.5;
    const glm::dvec2 cell = glm::floor(place);
    const glm::dvec2 part = place - cell;
    const auto at = [&](int x, int y) {
        const auto wrap = [](int i, int n) { return (i % n + n) % n; };
        return texels.at(wrap(static_cast<int>(cell.x) + x, texels.size.width),
                         wrap(static_cast<int>(cell.y) + y, texels.size.height));
    };
    return std::lerp(std::lerp(at(0, 0), at(1, 0), part.x), std::lerp(at(0, 1), at(1, 1), part.x), part.y);
}

/// Dummer 2006, as its listing has it: along the unit vector (du, dv, 1) / |(du, dv, 1)|, with the relief one unit
/// deep, so that the answer is a length in that space. The map has square roots of ratios; w is one texel of a square
/// map.
class DummersLoop {
public:
    explicit DummersLoop(const HeightMap& map)
        : map_(&map), roots_(stored(square_roots(conservative_ratios(map)))), w_(1.0 / map.width()) {}

    /// The ray parameter from h = 1 to h = 0 of the ray that enters at `uv`.
    double operator()(glm::dvec2 uv, glm::dvec2 max_offset) const {
        const double length = std::sqrt(glm::dot(max_offset, max_offset) + 1);
        const glm::dvec2 along = max_offset / length;
        const double down = 1 / length;
        const double across = glm::length(along);
        double way = 0;
        double height = map_->sample(uv.x, uv.y);
        double root = filtered(roots_, uv);
        bool stepped = false;
        while (1 - down * way > height) {
            way += w_ + (1 - down * way - height) / (down + across / (root * root));
            height = map_->sample(uv.x + way * along.x, uv.y + way * along.y);
            root = filtered(roots_, uv + way * along);
            stepped = true;
        }
        return stepped ? down * (way - w_) : 0;
    }

private:
    const HeightMap* map_;
    Ratios roots_;
    double w_;
};

class ConeStep : public VerifyTest {
protected:
    /// Parallel rays at 75 degrees, off the axes of the texture, over a relief that goes on for ever.
    static View steep_view() {
        View view = parallel_view(75, -67);
        view.relief.height_scale = 0.1;
        view.relief.boundary = Boundary::repeat;
        return view;
    }

    struct Figures {
        /// Fraction of the footprint in which the answer lies more than half a texel beyond the first hit.
        double beyond = 0;
        double taps = 0;
    };

    static Figures figures(const std::string& technique, const ParameterValues& changed, const CoordinateScene& scene,
                           const View& view) {
        const TruthComparison found = compare(technique, changed, scene, view);
        const auto footprint = static_cast<double>(found.errors.footprint);
        Figures figures;
        figures.beyond = static_cast<double>(pixels_beyond(found, scene.map, view, 1e-6)) / footprint;
        for (const PixelWork& work : found.probe.work.texels)
            figures.taps += work.taps / footprint;
        return figures;
    }
};

}  // namespace

TEST_F(ConeStep, IsDummersLoop) {
    for (const std::string name : {"rock", "bricks", "spikes"}) {
        const CoordinateScene scene(device(), procedural(name, {64, 64}));
        const DummersLoop dummers_loop(scene.map);
        for (View view : {parallel_view(60, -67), parallel_view(80, 20), perspective_view(50, -110)}) {
            view.relief.height_scale = 0.1;
            view.relief.tiling = 1.5;
            view.relief.boundary = Boundary::repeat;
            const TruthComparison found = compare("cone_step", {{"preparation", "exact"s}}, scene, view);
            std::size_t hits = 0;
            std::size_t same = 0;
            for (int j = 0; j < view.resolution.height; ++j) {
                for (int i = 0; i < view.resolution.width; ++i) {
                    const Hit& hit = found.probe.hits.at(i, j);
                    if (!hit.is_hit()) continue;
                    ++hits;
                    const Ray ray = pixel_ray(view, i, j);
                    const glm::dvec2 entry = view.relief.tiling * *footprint_entry(ray);
                    const glm::dvec2 max_offset =
                        view.relief.tiling * view.relief.height_scale / -ray.direction.z * glm::dvec2(ray.direction);
                    const double s = dummers_loop(entry, max_offset);
                    const glm::dvec2 expected = entry + s * max_offset;
                    const glm::dvec2 apart = view.relief.tiling * glm::dvec2(hit.u, hit.v) - expected;
                    same += glm::length(apart) * scene.map.width() < 0.01 ? 1 : 0;
                }
            }
            // Single floats decide some rays' last step otherwise.
            ASSERT_GT(hits, 1000U) << name;
            EXPECT_GT(static_cast<double>(same), 0.98 * static_cast<double>(hits)) << name;
        }
    }
}

/// What Dummer adds is shorter than a texel of a relief that is less deep than wide, and is taken back.
TEST_F(ConeStep, GoesBeyondTheSurfaceSeldomByThePublishedRule) {
    struct Case {
        const char* map;
        double most_beyond;
    };
    for (const Case& expected : {Case{"bricks", 0.17},
                                 {"cobbles", 0.004},
                                 {"rock", 0.004},
                                 {"waves", 0.001},
                                 {"spikes", 0.13},
                                 {"steps", 0.05}}) {
        const CoordinateScene scene(device(), procedural(expected.map, {128, 128}));
        const Figures published = figures("cone_step", {}, scene, steep_view());
        EXPECT_LT(published.beyond, expected.most_beyond) << expected.map;
        const Figures larger = figures("cone_step", {{"step_rule", "larger"s}}, scene, steep_view());
        EXPECT_GT(larger.beyond, 0.4) << expected.map;
        EXPECT_LT(published.taps, larger.taps) << expected.map;
    }
}

/// The square of an average of roots is no larger than the average of their squares: cones are narrower between texels.
TEST_F(ConeStep, SquareRootsKeepConesNarrowerBetweenTexels) {
    for (const std::string name : {"bricks", "spikes", "steps"}) {
        const CoordinateScene scene(device(), procedural(name, {128, 128}));
        const double roots = figures("cone_step", {{"minimum_step", 0.0}}, scene, steep_view()).beyond;
        const double linear =
            figures("cone_step", {{"minimum_step", 0.0}, {"cone_encoding", "linear"s}}, scene, steep_view()).beyond;
        EXPECT_LT(roots, 0.8 * linear) << name;
    }
}

/// Four cones in place of one, and all else alike.
TEST_F(ConeStep, QuadConesStepByTheSameRule) {
    const CoordinateScene scene(device(), procedural("rock", {128, 128}));
    EXPECT_LT(figures("quad_cone", {}, scene, steep_view()).beyond, 0.004);
    EXPECT_GT(figures("quad_cone", {{"step_rule", "larger"s}}, scene, steep_view()).beyond, 0.4);
}

}  // namespace reliefbench::test
