#include "scene/procedural.hpp"

#include "core/parallel.hpp"
#include "core/random.hpp"
#include "scene/periodic_noise.hpp"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <numbers>

namespace reliefbench {

namespace {

/// Height, before it is stretched to [0, 1], at a point of the unit square; repeats with period 1.
using Pattern = std::function<double(glm::dvec2 position)>;

/// Octaves from `period` on whose cells are at least four texels wide, so that none is mere texel noise.
int resolved_octaves(int period, Resolution size, int most) {
    int octaves = 1;
    while (octaves < most && (period << octaves) * 4 <= std::min(size.width, size.height))
        ++octaves;
    return octaves;
}

double smoothstep(double low, double high, double x) {
    const double s = std::clamp((x - low) / (high - low), 0.0, 1.0);
    return s * s * (3 - 2 * s);
}

int wrap(int index, int count) {
    return (index % count + count) % count;
}

/// Running bond: four bricks to a row, eight rows, every other row shifted by half a brick.
Pattern bricks(Resolution size, std::uint64_t seed) {
    constexpr int columns = 4;
    constexpr int rows = 8;
    constexpr double joint = 0.010;  // half the width of the mortar between two bricks
    constexpr double corner_radius = 0.014;
    constexpr double bevel = 0.012;
    const FractalNoise wobble({16, resolved_octaves(16, size, 2), 0.5}, mix_bits(seed ^ 1));
    const FractalNoise roughness({24, resolved_octaves(24, size, 4), 0.6}, mix_bits(seed ^ 2));
    return [=](glm::dvec2 position) {
        const double y = position.y * rows;
        const int row = static_cast<int>(std::floor(y));
        const double x = position.x * columns + (wrap(row, 2) == 1 ? 0.5 : 0.0);
        const int column = static_cast<int>(std::floor(x));

        // Signed distance to a rectangle with round corners, positive inside.
        const glm::dvec2 from_centre{(x - column - 0.5) / columns, (y - row - 0.5) / rows};
        const glm::dvec2 half{0.5 / columns - joint - corner_radius, 0.5 / rows - joint - corner_radius};
        const glm::dvec2 beyond = glm::abs(from_centre) - half;
        const double outside = glm::length(glm::max(beyond, 0.0)) + std::min(std::max(beyond.x, beyond.y), 0.0);
        const double inside = corner_radius - outside + 0.004 * wobble(position);

        const auto brick = [&](std::uint64_t purpose) {
            return random_at(mix_bits(seed + purpose), wrap(column, columns), wrap(row, rows));
        };
        const double tilt = 0.9 * ((brick(12) - 0.5) * from_centre.x + (brick(13) - 0.5) * 2 * from_centre.y);
        const double rough = roughness(position);
        const double face = 0.78 + 0.18 * brick(11) + tilt + 0.08 * rough;
        const double mortar = 0.10 + 0.10 * rough;
        return std::lerp(mortar, face, smoothstep(0, bevel, inside));
    };
}

/// One random point in each cell of a square grid that repeats: the feature points of Worley's cellular patterns.
class FeaturePoints {
public:
    struct Point {
        /// In cells, relative to the grid's origin.
        glm::dvec2 position;
        /// The cell it lies in, wrapped.
        int column = 0;
        int row = 0;
    };

    FeaturePoints(int grid, double jitter, std::uint64_t seed) : grid_(grid) {
        for (int y = -reach; y < grid + reach; ++y) {
            for (int x = -reach; x < grid + reach; ++x) {
                const int column = wrap(x, grid);
                const int row = wrap(y, grid);
                const glm::dvec2 offset{random_at(mix_bits(seed ^ 1), column, row) - 0.5,
                                        random_at(mix_bits(seed ^ 2), column, row) - 0.5};
                points_.push_back({glm::dvec2(x, y) + 0.5 + jitter * offset, column, row});
            }
        }
    }

    int grid() const { return grid_; }

    /// The points of the 5×5 cells around `position` (in cells, inside the grid).
    template <typename Body>
    void for_neighbours(glm::dvec2 position, const Body& body) const {
        const int column = static_cast<int>(position.x);
        const int row = static_cast<int>(position.y);
        for (int y = row; y <= row + 2 * reach; ++y) {
            const Point* points = points_.data() + static_cast<std::ptrdiff_t>(y) * (grid_ + 2 * reach);
            for (int x = column; x <= column + 2 * reach; ++x)
                body(points[x]);
        }
    }

private:
    static constexpr int reach = 2;
    int grid_;
    std::vector<Point> points_;
};

/// Domes over the cells of a Voronoi diagram.
Pattern cobbles(Resolution size, std::uint64_t seed) {
    constexpr double corner_sharpness = 18;
    // In cells of the grid.
    constexpr double gap = 0.03;
    constexpr double dome_width = 0.42;
    const FeaturePoints centres(8, 0.75, mix_bits(seed ^ 1));
    const FractalNoise grain({24, resolved_octaves(24, size, 4), 0.55}, mix_bits(seed ^ 2));
    return [=](glm::dvec2 position) {
        const glm::dvec2 scaled = position * double(centres.grid());
        const FeaturePoints::Point* stone = nullptr;
        double nearest = std::numeric_limits<double>::infinity();
        centres.for_neighbours(scaled, [&](const FeaturePoints::Point& point) {
            const glm::dvec2 apart = point.position - scaled;
            const double squared_distance = glm::dot(apart, apart);
            if (squared_distance < nearest) {
                nearest = squared_distance;
                stone = &point;
            }
        });

        // A smooth minimum of the distances to the cell's edges rounds the stone's corners.
        double sum = std::exp(-corner_sharpness);
        centres.for_neighbours(scaled, [&](const FeaturePoints::Point& point) {
            if (&point == stone) return;
            const glm::dvec2 apart = point.position - stone->position;
            const glm::dvec2 middle = (point.position + stone->position) * 0.5;
            const double to_edge = glm::dot(middle - scaled, apart) / glm::length(apart);
            if (to_edge < 1) sum += std::exp(-corner_sharpness * to_edge);
        });
        const double to_edge = -std::log(sum) / corner_sharpness;

        const double rough = grain(position);
        const double ground = 0.10 + 0.10 * rough;
        const double inside = std::clamp((to_edge - gap) / dome_width, 0.0, 1.0);
        const double dome = std::sqrt(1 - (1 - inside) * (1 - inside));
        const double top = 0.72 + 0.25 * random_at(mix_bits(seed ^ 4), stone->column, stone->row) + 0.05 * rough;
        return std::lerp(ground, top, dome);
    };
}

/// The upper envelope of tilted caps, one per feature point, flat near it and falling off fast enough that none beyond
/// the neighbourhood reaches the envelope: broken faces that meet in creases.
class BrokenFaces {
public:
    BrokenFaces(int grid, std::uint64_t seed) : points_(grid, 0.9, mix_bits(seed ^ 1)), faces_({grid, grid}) {
        Random random(mix_bits(seed ^ 2));
        for (Face& face : faces_.texels) {
            face = {{random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5)}, random.uniform(-0.3, 0.3)};
        }
    }

    double operator()(glm::dvec2 position) const {
        const glm::dvec2 scaled = (position - glm::floor(position)) * double(points_.grid());
        double envelope = -std::numeric_limits<double>::infinity();
        points_.for_neighbours(scaled, [&](const FeaturePoints::Point& point) {
            const Face& face = faces_.at(point.column, point.row);
            const glm::dvec2 apart = scaled - point.position;
            const double squared = glm::dot(apart, apart);
            const double fall = squared * (0.15 + 0.08 * squared);
            envelope = std::max(envelope, face.height + glm::dot(face.tilt, apart) - fall);
        });
        return envelope;
    }

private:
    struct Face {
        glm::dvec2 tilt;
        double height = 0;
    };
    FeaturePoints points_;
    Image<Face> faces_;
};

/// Broken faces with creases between them, smaller ones turned over for sharp crests, on a fractal mass; bent by noise,
/// with fractal grain down to the texel.
Pattern rock(Resolution size, std::uint64_t seed) {
    constexpr double bend = 0.03;
    const BrokenFaces boulders(4, mix_bits(seed ^ 1));
    const BrokenFaces chips(11, mix_bits(seed ^ 2));
    const FractalNoise bend_x({5, resolved_octaves(5, size, 3), 0.5}, mix_bits(seed ^ 3));
    const FractalNoise bend_y({5, resolved_octaves(5, size, 3), 0.5}, mix_bits(seed ^ 4));
    const FractalNoise mass({2, resolved_octaves(2, size, 2), 0.5}, mix_bits(seed ^ 5));
    const FractalNoise grain({12, resolved_octaves(12, size, 6), 0.6}, mix_bits(seed ^ 6));
    return [=](glm::dvec2 position) {
        const glm::dvec2 bent = position + bend * glm::dvec2(bend_x(position), bend_y(position));
        return boulders(bent) - 0.45 * chips(bent) + 0.35 * mass(bent) + 0.10 * grain(position);
    };
}

/// A few wave trains in nearly one direction, crests narrower than troughs: smooth to any order, no wave shorter than a
/// sixth of the patch.
Pattern waves(Resolution, std::uint64_t seed) {
    struct Wave {
        glm::dvec2 number;
        double amplitude;
        double phase;
    };
    constexpr std::array<std::array<int, 2>, 6> numbers{{{0, 3}, {1, 3}, {-1, 4}, {2, 3}, {-2, 4}, {1, 5}}};
    std::vector<Wave> components;
    Random random(seed);
    for (const auto& [across, up] : numbers) {
        const glm::dvec2 number(across, up);
        components.push_back({number, random.uniform(1.5, 3.0) / glm::dot(number, number), random.uniform()});
    }
    return [=](glm::dvec2 position) {
        double height = 0;
        for (const Wave& wave : components) {
            const double angle = 2 * std::numbers::pi * (glm::dot(wave.number, position) + wave.phase);
            height += wave.amplitude * std::exp(std::sin(angle) - 1);
        }
        return height;
    };
}

/// Terraces: smooth hills cut to a few levels, so that neighbouring texels differ by nothing or by a whole cliff.
Pattern steps(Resolution, std::uint64_t seed) {
    constexpr int levels = 6;
    const FractalNoise hills({2, 3, 0.45}, mix_bits(seed ^ 1));
    return [=](glm::dvec2 position) {
        const double height = 0.5 + 0.9 * hills(position);
        return std::clamp(std::floor(height * levels), 0.0, levels - 1.0) / (levels - 1);
    };
}

Image<float> evaluate(const Pattern& pattern, Resolution size) {
    Image<float> heights(size);
    parallel_for(size.height, 8, [&](std::size_t begin, std::size_t end) {
        for (std::size_t y = begin; y < end; ++y) {
            for (int x = 0; x < size.width; ++x) {
                const glm::dvec2 position{(x + 0.5) / size.width, (double(y) + 0.5) / size.height};
                heights.at(x, static_cast<int>(y)) = static_cast<float>(pattern(position));
            }
        }
    });
    return heights;
}

/// Draws onto a map in texels, so that features keep their width in texels whatever the map's size.
class Spikes {
public:
    Spikes(Resolution size, std::uint64_t seed) : heights_(size), random_(seed) {}

    Image<float> draw(std::uint64_t seed) {
        const FractalNoise ground({3, 2, 0.5}, mix_bits(seed));
        heights_ = evaluate([&](glm::dvec2 position) { return 0.07 + 0.07 * ground(position); }, heights_.size);
        const int columns = std::clamp(heights_.size.width / 14, 1, 18);
        const int rows = std::clamp(heights_.size.height / 14, 1, 18);
        for (int row = 0; row < rows; ++row) {
            for (int column = 0; column < columns; ++column) {
                const glm::dvec2 cell(double(heights_.size.width) / columns, double(heights_.size.height) / rows);
                const glm::dvec2 place((column + random_.uniform(0.15, 0.85)) * cell.x,
                                       (row + random_.uniform(0.15, 0.85)) * cell.y);
                if (random_.uniform() < wall_share) {
                    wall(place, cell);
                } else {
                    peak(place);
                }
            }
        }
        return std::move(heights_);
    }

private:
    void raise(int x, int y, double height) {
        float& texel = heights_.at(wrap(x, heights_.size.width), wrap(y, heights_.size.height));
        texel = std::max(texel, static_cast<float>(height));
    }

    /// One, two or three texels wide; the widest ones taper.
    void peak(glm::dvec2 place) {
        const auto width = static_cast<int>(1 + random_.below(3));
        const double top = random_.uniform(0.55, 1.0);
        const int left = static_cast<int>(place.x);
        const int below = static_cast<int>(place.y);
        for (int y = 0; y < width; ++y) {
            for (int x = 0; x < width; ++x) {
                const int from_centre = width == 3 ? std::abs(x - 1) + std::abs(y - 1) : 0;
                raise(left + x, below + y, top * (1 - 0.3 * from_centre));
            }
        }
    }

    /// A straight wall, one texel thick, as long as a cell of the layout or a little more.
    void wall(glm::dvec2 place, glm::dvec2 cell) {
        const double angle = std::numbers::pi * double(random_.below(8)) / 8;
        const double top = random_.uniform(0.5, 0.9);
        const double length = std::min(cell.x, cell.y) * random_.uniform(0.7, 1.3);
        const glm::dvec2 direction{std::cos(angle), std::sin(angle)};
        for (double along = -length / 2; along <= length / 2; along += 0.5) {
            const glm::dvec2 point = place + along * direction;
            raise(static_cast<int>(std::floor(point.x)), static_cast<int>(std::floor(point.y)), top);
        }
    }

    static constexpr double wall_share = 0.15;
    Image<float> heights_;
    Random random_;
};

void stretch_to_unit(Image<float>& heights) {
    const auto [smallest, largest] = std::minmax_element(heights.texels.begin(), heights.texels.end());
    const float low = *smallest;
    const float extent = *largest - low;
    for (float& height : heights.texels) {
        height = extent > 0 ? std::clamp((height - low) / extent, 0.0f, 1.0f) : std::clamp(height, 0.0f, 1.0f);
    }
}

struct Generator {
    ProceduralMap map;
    Image<float> (*generate)(Resolution, std::uint64_t);
};

template <Pattern (*pattern)(Resolution, std::uint64_t)>
Image<float> from_pattern(Resolution size, std::uint64_t seed) {
    return evaluate(pattern(size, seed), size);
}

Image<float> spikes(Resolution size, std::uint64_t seed) {
    return Spikes(size, seed).draw(seed);
}

const std::vector<Generator>& generators() {
    static const std::vector<Generator> all{
        {{"bricks", "brick wall in running bond, deep joints, each brick a little off"}, from_pattern<bricks>},
        {{"cobbles", "round stones over the cells of a Voronoi diagram"}, from_pattern<cobbles>},
        {{"rock", "craggy rock: broken faces on fractal noise, with detail down to the texel"}, from_pattern<rock>},
        {{"waves", "smooth water: a few long waves, for orders of convergence"}, from_pattern<waves>},
        {{"spikes", "needles and walls one to three texels thin, which coarse marching misses"}, spikes},
        {{"steps", "terraces with vertical cliffs between neighbouring texels"}, from_pattern<steps>},
    };
    return all;
}

}  // namespace

const std::vector<ProceduralMap>& procedural_maps() {
    static const std::vector<ProceduralMap> maps = [] {
        std::vector<ProceduralMap> result;
        for (const Generator& generator : generators())
            result.push_back(generator.map);
        return result;
    }();
    return maps;
}

Image<float> generate_height_map(const std::string& name, Resolution size, std::uint64_t seed) {
    const auto& all = generators();
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const Generator& generator) { return generator.map.name == name; });
    assert(found != all.end() && size.width > 0 && size.height > 0);
    Image<float> heights = found->generate(size, seed);
    stretch_to_unit(heights);
    return heights;
}

}  // namespace reliefbench
