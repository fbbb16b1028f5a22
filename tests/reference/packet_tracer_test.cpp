#include "reference/packet_tracer.hpp"
#include "core/random.hpp"
#include "reference/exact_tracer.hpp"

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

namespace reliefbench {
namespace {

/// Highway takes this instruction set only, as long as it lives.
class InstructionSet {
public:
    explicit InstructionSet(std::int64_t target) { choose(target); }
    InstructionSet(const InstructionSet&) = delete;
    InstructionSet& operator=(const InstructionSet&) = delete;
    ~InstructionSet() { choose(0); }

private:
    static void choose(std::int64_t target) {
        hwy::SetSupportedTargetsForTest(target);
        hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    }
};

/// All that the machine has, and the one that needs nothing of it.
std::vector<std::int64_t> instruction_sets() {
    std::vector<std::int64_t> sets{HWY_SCALAR};
    for (std::int64_t left = hwy::SupportedTargets(); left != 0; left &= left - 1) {
        const std::int64_t lowest = left & -left;
        if (lowest != HWY_SCALAR) sets.push_back(lowest);
    }
    return sets;
}

std::array<std::uint64_t, 4> bits(const ExactHit& hit) {
    return {std::bit_cast<std::uint64_t>(hit.u), std::bit_cast<std::uint64_t>(hit.v),
            std::bit_cast<std::uint64_t>(hit.h), std::bit_cast<std::uint64_t>(hit.t)};
}

/// Every instruction set, and packets of several sizes.
void expect_same_hits(const HeightMap& map, const Relief& relief, const std::vector<Ray>& rays,
                      const std::string& what) {
    const ExactTracer tracer(map, relief);
    std::vector<std::optional<ExactHit>> expected;
    for (const Ray& ray : rays)
        expected.push_back(tracer.trace(ray));
    for (const std::int64_t set : instruction_sets()) {
        const InstructionSet chosen(set);
        for (const std::size_t size : {rays.size(), std::size_t{67}}) {
            std::vector<std::optional<ExactHit>> hits(rays.size());
            for (std::size_t first = 0; first < rays.size(); first += size) {
                const std::size_t count = std::min(size, rays.size() - first);
                tracer.trace(std::span(rays).subspan(first, count), std::span(hits).subspan(first, count));
            }
            std::size_t different = 0;
            for (std::size_t i = 0; i < rays.size(); ++i) {
                const bool same = hits[i].has_value() == expected[i].has_value() &&
                                  (!hits[i] || bits(*hits[i]) == bits(*expected[i]));
                different += same ? 0 : 1;
            }
            EXPECT_EQ(different, 0) << what << ", " << hwy::TargetName(set) << ", packets of " << size << ", of "
                                    << rays.size() << " rays";
        }
    }
}

View view_of(const Camera& camera, const Relief& relief, Resolution resolution) {
    View view;
    view.camera = camera;
    view.relief = relief;
    view.resolution = resolution;
    return view;
}

std::vector<Ray> rays_of(const View& view) {
    const PixelRays pixels = pixel_rays(view);
    std::vector<Ray> rays;
    for (int j = 0; j < view.resolution.height; ++j) {
        for (int i = 0; i < view.resolution.width; ++i)
            rays.push_back(pixels.at(i, j));
    }
    return rays;
}

void expect_same_pictures(const HeightMap& map, const std::vector<double>& angles, Resolution resolution) {
    for (const double tiling : {1.0, 2.37}) {
        for (const Boundary boundary : {Boundary::clip, Boundary::repeat}) {
            for (const Projection projection : {Projection::parallel, Projection::perspective}) {
                for (const double angle : angles) {
                    for (const double azimuth : {-90.0, -70.0, 41.0, 135.0}) {
                        const View view = view_of({projection, angle, azimuth}, {0.08, tiling, boundary}, resolution);
                        expect_same_hits(map, view.relief, rays_of(view),
                                         map.name + " " + to_string(projection) + " " + to_string(boundary) + " " +
                                             std::to_string(angle) + " " + std::to_string(azimuth) + " tiling " +
                                             std::to_string(tiling));
                    }
                }
            }
        }
    }
}

HeightMap map_of(Resolution size, const std::string& name, const auto& height) {
    Image<float> heights(size);
    for (int j = 0; j < size.height; ++j) {
        for (int i = 0; i < size.width; ++i)
            heights.at(i, j) = static_cast<float>(height(i, j));
    }
    return make_height_map(heights, HeightFormat::r32f, name);
}

HeightMap random_heights(Resolution size) {
    return map_of(size, "random", [](int i, int j) { return random_at(3, i, j); });
}

HeightMap smooth_heights(Resolution size) {
    return map_of(size, "smooth", [&](int i, int j) {
        return 0.5 + 0.3 * std::sin(6 * std::numbers::pi * i / size.width) +
               0.19 * std::cos(4 * std::numbers::pi * j / size.height);
    });
}

TEST(PacketTracer, SmoothReliefIsHitTheSameByAllInstructionSets) {
    expect_same_pictures(smooth_heights({64, 64}), {0, 30, 60, 80, 89}, {32, 32});
    expect_same_pictures(smooth_heights({37, 101}), {0.5, 45, 75}, {32, 32});
}

TEST(PacketTracer, RoughReliefOfAnySizeIsHitTheSame) {
    for (const Resolution size : {Resolution{1, 1}, Resolution{2, 2}, Resolution{1, 7}, Resolution{5, 3},
                                  Resolution{17, 9}, Resolution{64, 64}})
        expect_same_pictures(random_heights(size), {20, 70}, {19, 17});
}

/// Rays through texel centres and along borders, where all is decided by rounding.
TEST(PacketTracer, PlateausAndCheckerboardsAreHitTheSame) {
    const Resolution size{16, 16};
    const HeightMap checker = map_of(size, "checkerboard", [](int i, int j) { return (i + j) % 2; });
    const HeightMap plateau = map_of(size, "plateau", [](int i, int j) { return i / 4 % 2 == 0 && j / 4 % 2 == 0; });
    const HeightMap flat = map_of(size, "top", [](int, int) { return 1; });
    const HeightMap floor = map_of(size, "floor", [](int, int) { return 0; });
    for (const HeightMap* map : {&checker, &plateau, &flat, &floor}) {
        expect_same_pictures(*map, {0, 45, 60, 85}, size);
        expect_same_pictures(*map, {60}, {33, 15});
    }
}

/// Of all kinds at once: beneath the sheet, from beside and above, upwards, along the axes, far away, flat.
TEST(PacketTracer, RaysOfAllKindsInOnePacketAreTracedTheSame) {
    Random random(11);
    const auto texel_centre = [&] { return (static_cast<double>(random.below(64)) + 0.5) / 64 - 0.5; };
    std::vector<Ray> rays;
    for (int index = 0; index < 1000; ++index) {
        glm::dvec3 origin{random.uniform(-1.5, 1.5), random.uniform(-1.5, 1.5), random.uniform(-0.1, 0.1)};
        const double flat = std::pow(10, random.uniform(-3, 1));
        glm::dvec3 direction{random.uniform(-1, 1), random.uniform(-1, 1), -flat};
        switch (random.below(12)) {
            case 0:
                direction.x = 0;
                break;
            case 1:
                direction.y = 0;
                break;
            case 2:
                direction.z = -direction.z;
                break;
            case 3:
                origin *= 1e6;
                break;
            case 4:
                direction.x *= 1e-9;
                break;
            case 5:
                direction = {0, 0, -1};
                break;
            case 6:
                origin = {texel_centre(), texel_centre(), 0};
                break;
            case 7:
                direction.y = direction.x;
                break;
            default:
                break;
        }
        const double length =
            std::sqrt(direction.x * direction.x + direction.y * direction.y + direction.z * direction.z);
        rays.push_back({origin, direction / length});
    }
    for (const HeightMap& map : {random_heights({64, 64}), smooth_heights({64, 32}), random_heights({9, 50})}) {
        for (const double tiling : {1.0, 0.3, 7.1}) {
            for (const Boundary boundary : {Boundary::clip, Boundary::repeat})
                expect_same_hits(map, {0.1, tiling, boundary}, rays, map.name + " tiling " + std::to_string(tiling));
        }
    }
}

/// From one point, as the rays of a light are.
TEST(PacketTracer, RaysThatMeetInAPointAreTracedTheSame) {
    const HeightMap map = smooth_heights({64, 64});
    Random random(12);
    std::vector<Ray> rays;
    for (int point = 0; point < 20; ++point) {
        const glm::dvec3 through{random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5), -0.07};
        for (int index = 0; index < 64; ++index) {
            glm::dvec3 direction{0.8 + random.uniform(-0.02, 0.02), 0.5 + random.uniform(-0.02, 0.02), -0.33};
            direction /= std::sqrt(direction.x * direction.x + direction.y * direction.y + direction.z * direction.z);
            rays.push_back({through - direction * (through.z / direction.z), direction});
        }
    }
    for (const Boundary boundary : {Boundary::clip, Boundary::repeat})
        expect_same_hits(map, {0.1, 1, boundary}, rays, "light");
}

/// Or all that is told here of packets would be told of single rays.
TEST(PacketTracer, NearlyAllRaysOfAPictureAreDecidedInPackets) {
    const HeightMap map = smooth_heights({64, 64});
    const WindowMaxima windows(map);
    const PacketScene scene{map.heights.texels.data(), 64, 64, 0.08, 64, 64, true, &windows};
    const View view = view_of({Projection::parallel, 60, -70}, {0.08, 1, Boundary::clip}, {16, 16});
    for (const std::int64_t set : instruction_sets()) {
        const InstructionSet chosen(set);
        PacketCrossings crossings;
        find_crossings(scene, rays_of(view), crossings);
        EXPECT_LE(std::ranges::count(crossings, not_decided), 4) << hwy::TargetName(set);
    }
}

TEST(PacketTracer, FewRaysAndNoneAreTracedTheSame) {
    const HeightMap map = smooth_heights({64, 64});
    const View view = view_of({Projection::perspective, 60, -70}, {0.08, 1, Boundary::clip}, {40, 1});
    const std::vector<Ray> all = rays_of(view);
    for (std::size_t count = 0; count <= all.size(); ++count)
        expect_same_hits(map, view.relief, {all.begin(), all.begin() + static_cast<std::ptrdiff_t>(count)}, "few");
}

}  // namespace
}  // namespace reliefbench
