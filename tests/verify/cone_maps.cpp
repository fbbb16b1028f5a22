#include "cone_maps.hpp"

#include "core/parallel.hpp"
#include "core/random.hpp"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <span>

namespace reliefbench::test {

namespace {

constexpr double widest = 1.0;
constexpr double texel_tolerance = 0.01;

double ratio_to(double distance, double h, double apex) {
    return h > apex ? std::min(distance / (h - apex), widest) : widest;
}

/// The nearest repeat: in (−size/2, size/2].
int nearest(int offset, int size) {
    offset = ((offset % size) + size) % size;
    return offset > size / 2 ? offset - size : offset;
}

Ratios for_each_texel(const HeightMap& map, const std::function<double(int x, int y)>& ratio_of) {
    Ratios ratios(map.heights.size);
    parallel_for(ratios.texels.size(), 64, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            ratios.texels[i] = ratio_of(static_cast<int>(i) % map.width(), static_cast<int>(i) / map.width());
    });
    return ratios;
}

/// Texels around (x, y) ring by ring, until a ring lies beyond the cone's reach or around the whole map; `narrow` gives
/// the ratio that the texel at an offset leaves.
double narrowed_by_rings(const HeightMap& map, int x, int y,
                         const std::function<double(double ratio, int dx, int dy)>& narrow) {
    const double apex = map.texel(x, y);
    const double texel = std::min(1.0 / map.width(), 1.0 / map.height());
    const int last = std::max(map.width(), map.height()) / 2;
    double ratio = widest;
    for (int ring = 1; ring <= last && ring * texel < ratio * (1 - apex); ++ring) {
        for (int dy = -ring; dy <= ring; ++dy) {
            const int stride = std::abs(dy) == ring ? 1 : 2 * ring;
            for (int dx = -ring; dx <= ring; dx += stride) {
                const bool is_nearest = std::abs(dx) <= map.width() / 2 && std::abs(dy) <= map.height() / 2;
                if (is_nearest) ratio = std::min(ratio, narrow(ratio, dx, dy));
            }
        }
    }
    return ratio;
}

double distance_of(const HeightMap& map, int dx, int dy) {
    return std::hypot(static_cast<double>(dx) / map.width(), static_cast<double>(dy) / map.height());
}

/// Of the ray from the axis at h = 1 over (x, y) through the surface at the offset, followed down to h = 0.
double published_exit(const HeightMap& map, int x, int y, int dx, int dy, int search_steps, double give_up) {
    const double apex = map.texel(x, y);
    const double h = map.texel(x + dx, y + dy);
    const glm::dvec2 axis{(x + 0.5) / map.width(), (y + 0.5) / map.height()};
    const glm::dvec2 slope = glm::dvec2{static_cast<double>(dx) / map.width(), static_cast<double>(dy) / map.height()} /
                             std::max(1 - h, 1e-6);
    for (int i = 1; i < search_steps; ++i) {
        const double ray_h = h * (1 - static_cast<double>(i) / search_steps);
        const glm::dvec2 way = (1 - ray_h) * slope;
        const double ratio = ratio_to(glm::length(way), ray_h, apex);
        if (ratio >= give_up) return widest;
        if (map.sample(axis.x + way.x, axis.y + way.y) < ray_h) return ratio;
    }
    return widest;
}

/// Places all over the map, at most so many: one at random within each of `per_side`² parts of each texel, or some of
/// them.
std::vector<glm::dvec2> places_of(const HeightMap& map, int per_side, std::size_t most) {
    std::vector<glm::dvec2> places;
    const int columns = map.width() * per_side;
    const int rows = map.height() * per_side;
    Random random(7);
    for (int y = 0; y < rows; ++y) {
        for (int x = 0; x < columns; ++x)
            places.emplace_back((x + random.uniform()) / columns, (y + random.uniform()) / rows);
    }
    random.shuffle(std::span(places));
    places.resize(std::min(places.size(), most));
    return places;
}

double interpolated(const HeightMap& map, const Ratios& ratios, glm::dvec2 uv) {
    const glm::dvec2 place = uv * glm::dvec2{map.width(), map.height()} - 0.5;
    const glm::dvec2 low{std::floor(place.x), std::floor(place.y)};
    const glm::dvec2 within = place - low;
    const auto at = [&](int dx, int dy) {
        const int x = nearest(static_cast<int>(low.x) + dx, map.width());
        const int y = nearest(static_cast<int>(low.y) + dy, map.height());
        return ratios.at(x < 0 ? x + map.width() : x, y < 0 ? y + map.height() : y);
    };
    return std::lerp(std::lerp(at(0, 0), at(1, 0), within.x), std::lerp(at(0, 1), at(1, 1), within.x), within.y);
}

/// `depth` tells how deep the surface reaches into the cone at a place; positive is a failure.
ConeProof prove(const std::vector<glm::dvec2>& places, const std::function<double(glm::dvec2 place)>& depth) {
    std::vector<double> depths(places.size());
    parallel_for(places.size(), 64, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            depths[i] = depth(places[i]);
    });
    ConeProof proof{.places = places.size()};
    for (const double texels : depths) {
        proof.failures += texels > texel_tolerance ? 1 : 0;
        proof.deepest_texels = std::max(proof.deepest_texels, texels);
    }
    return proof;
}

}  // namespace

Ratios conservative_ratios(const HeightMap& map) {
    return for_each_texel(map, [&](int x, int y) {
        const double apex = map.texel(x, y);
        return narrowed_by_rings(map, x, y, [&](double, int dx, int dy) {
            return ratio_to(distance_of(map, dx, dy), map.texel(x + dx, y + dy), apex);
        });
    });
}

std::vector<double> published_relaxed_ratios(const HeightMap& map, int search_steps,
                                             const std::vector<Resolution>& texels) {
    std::vector<double> ratios;
    for (const Resolution& texel : texels) {
        double ratio = widest;
        for (int sy = 0; sy < map.height(); ++sy) {
            for (int sx = 0; sx < map.width(); ++sx) {
                const int dx = nearest(sx - texel.width, map.width());
                const int dy = nearest(sy - texel.height, map.height());
                if (dx != 0 || dy != 0)
                    ratio = std::min(ratio, published_exit(map, texel.width, texel.height, dx, dy, search_steps,
                                                           std::numeric_limits<double>::infinity()));
            }
        }
        ratios.push_back(ratio);
    }
    return ratios;
}

Ratios published_relaxed_ratios(const HeightMap& map, int search_steps) {
    return for_each_texel(map, [&](int x, int y) {
        return narrowed_by_rings(map, x, y, [&](double ratio, int dx, int dy) {
            return published_exit(map, x, y, dx, dy, search_steps, ratio);
        });
    });
}

Ratios falling_edge_ratios(const HeightMap& map) {
    return for_each_texel(map, [&](int x, int y) {
        const double apex = map.texel(x, y);
        return narrowed_by_rings(map, x, y, [&](double ratio, int dx, int dy) {
            const int sx = x + dx;
            const int sy = y + dy;
            const double h = map.texel(sx, sy);
            const double there = ratio_to(distance_of(map, dx, dy), h, apex);
            if (there >= ratio) return ratio;
            const bool falls = (dx >= 0 && map.texel(sx + 1, sy) < h) || (dx <= 0 && map.texel(sx - 1, sy) < h) ||
                               (dy >= 0 && map.texel(sx, sy + 1) < h) || (dy <= 0 && map.texel(sx, sy - 1) < h);
            return falls ? there : ratio;
        });
    });
}

Ratios narrowest_around(const Ratios& ratios) {
    const auto [width, height] = ratios.size;
    Ratios result = ratios;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            for (int dy = -1; dy <= 1; ++dy) {
                for (int dx = -1; dx <= 1; ++dx)
                    result.at(x, y) =
                        std::min(result.at(x, y), ratios.at((x + dx + width) % width, (y + dy + height) % height));
            }
        }
    }
    return result;
}

Ratios stored(const Ratios& ratios) {
    constexpr double steps = 65535;
    Ratios result = ratios;
    for (double& ratio : result.texels)
        ratio = std::floor(ratio * steps) / steps;
    return result;
}

Ratios square_roots(const Ratios& ratios) {
    Ratios result = ratios;
    for (double& ratio : result.texels)
        ratio = std::sqrt(ratio);
    return result;
}

ConeProof prove_conservative(const HeightMap& map, const Ratios& encoded, std::size_t places, ConeEncoding encoding) {
    constexpr int samples_per_texel = 4;
    const glm::dvec2 texel{1.0 / map.width(), 1.0 / map.height()};
    const double texels = 1 / std::min(texel.x, texel.y);
    return prove(places_of(map, 2, places), [&](glm::dvec2 place) {
        const double between = interpolated(map, encoded, place);
        const double ratio = encoding == ConeEncoding::square_root ? between * between : between;
        const double apex = map.sample(place.x, place.y);
        const double reach = ratio * (1 - apex);
        double deepest = 0;
        const glm::dvec2 step = texel / static_cast<double>(samples_per_texel);
        const int columns = static_cast<int>(reach / step.x);
        const int rows = static_cast<int>(reach / step.y);
        for (int y = -rows; y <= rows; ++y) {
            for (int x = -columns; x <= columns; ++x) {
                const glm::dvec2 way = glm::dvec2(x, y) * step;
                const double distance = glm::length(way);
                if (distance >= reach) continue;
                const double h = map.sample(place.x + way.x, place.y + way.y);
                deepest = std::max(deepest, (ratio * (h - apex) - distance) * texels);
            }
        }
        return deepest;
    });
}

ConeProof prove_relaxed(const HeightMap& map, const Ratios& ratios, std::size_t places) {
    constexpr int directions = 24;
    constexpr int heights = 8;
    constexpr int slopes = 6;
    constexpr double samples_per_texel = 8;
    const double texel = std::min(1.0 / map.width(), 1.0 / map.height());
    const auto depth_of_ray = [&](glm::dvec2 place, glm::dvec2 direction, double start, double slope, double apex,
                                  double ratio) {
        bool was_beneath = false;
        for (double way = texel / samples_per_texel;; way += texel / samples_per_texel) {
            const double ray_h = start - slope * way;
            const double depth = ratio * (ray_h - apex) - way;
            if (depth <= 0) return 0.0;
            const glm::dvec2 point = place + way * direction;
            const double gap = ray_h - map.sample(point.x, point.y);
            if (was_beneath && gap > 1e-9) return depth / texel;
            was_beneath = gap < -1e-9;
        }
    };
    return prove(places_of(map, 1, places), [&](glm::dvec2 place) {
        const double ratio = interpolated(map, ratios, place);
        const double apex = map.sample(place.x, place.y);
        double deepest = 0;
        for (int i = 0; i < directions; ++i) {
            const double angle = 2 * std::numbers::pi * (i + 0.5) / directions;
            const glm::dvec2 direction{std::cos(angle), std::sin(angle)};
            for (int j = 0; j < heights; ++j) {
                const double start = apex + (1 - apex) * (j + 1.0) / heights;
                for (int k = 0; k < slopes; ++k) {
                    // From level to so steep that the mantle is met half-way down to the apex.
                    const double slope = k / ratio / slopes;
                    deepest = std::max(deepest, depth_of_ray(place, direction, start, slope, apex, ratio));
                }
            }
        }
        return deepest;
    });
}

}  // namespace reliefbench::test
