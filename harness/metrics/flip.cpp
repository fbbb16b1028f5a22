#include "metrics/flip.hpp"

#include "core/parallel.hpp"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <span>
#include <vector>

namespace reliefbench {

namespace {

using Rgb = std::array<float, 3>;

/// Constants of the paper by its symbols.
constexpr float q_c = 0.7F;
constexpr float p_c = 0.4F;
constexpr float p_t = 0.95F;
constexpr float q_f = 0.5F;
/// Width of the feature detector in degrees.
constexpr double w = 0.082;

/// Contrast sensitivity as the sum of two Gaussians, table 1: a₁, b₁, a₂, b₂.
struct Sensitivity {
    double a1, b1, a2, b2;
};
constexpr Sensitivity achromatic{1, 0.0047, 0, 1e-5};
constexpr Sensitivity red_green{1, 0.0053, 0, 1e-5};
constexpr Sensitivity blue_yellow{34.1, 0.04, 13.5, 0.025};
constexpr double widest_sensitivity = 0.04;
/// Filters end at three standard deviations.
constexpr double extent_in_deviations = 3;

constexpr float ratio(double numerator, double denominator) {
    return static_cast<float>(numerator / denominator);
}

/// CIE XYZ of the sRGB primaries at D65.
constexpr std::array<std::array<float, 3>, 3> rgb_to_xyz{
    {{ratio(10135552, 24577794), ratio(8788810, 24577794), ratio(4435075, 24577794)},
     {ratio(2613072, 12288897), ratio(8788810, 12288897), ratio(887015, 12288897)},
     {ratio(1425312, 73733382), ratio(8788810, 73733382), ratio(70074185, 73733382)}}};

constexpr float row_sum(std::size_t row) {
    return rgb_to_xyz[row][0] + rgb_to_xyz[row][1] + rgb_to_xyz[row][2];
}
constexpr std::array<float, 3> white{row_sum(0), row_sum(1), row_sum(2)};

constexpr double determinant_2(double a, double b, double c, double d) {
    return a * d - b * c;
}

/// Of rgb_to_xyz with its rows divided by the white point, by cofactors.
constexpr std::array<std::array<float, 3>, 3> make_relative_xyz_to_rgb() {
    std::array<std::array<double, 3>, 3> m{};
    for (std::size_t row = 0; row < 3; ++row) {
        for (std::size_t column = 0; column < 3; ++column) {
            m[row][column] = static_cast<double>(rgb_to_xyz[row][column]) / static_cast<double>(white[row]);
        }
    }
    std::array<std::array<double, 3>, 3> cofactors{};
    for (std::size_t row = 0; row < 3; ++row) {
        for (std::size_t column = 0; column < 3; ++column) {
            const std::size_t r1 = (row + 1) % 3, r2 = (row + 2) % 3;
            const std::size_t c1 = (column + 1) % 3, c2 = (column + 2) % 3;
            cofactors[row][column] = determinant_2(m[r1][c1], m[r1][c2], m[r2][c1], m[r2][c2]);
        }
    }
    const double determinant = m[0][0] * cofactors[0][0] + m[0][1] * cofactors[0][1] + m[0][2] * cofactors[0][2];
    std::array<std::array<float, 3>, 3> inverse{};
    for (std::size_t row = 0; row < 3; ++row) {
        for (std::size_t column = 0; column < 3; ++column) {
            inverse[row][column] = static_cast<float>(cofactors[column][row] / determinant);
        }
    }
    return inverse;
}
constexpr auto relative_xyz_to_rgb = make_relative_xyz_to_rgb();

/// The linearised opponent space of the filters.
struct YCxCz {
    float y, cx, cz;
};

struct Lab {
    float l, a, b;
};

/// X, Y, Z divided by the white point.
std::array<float, 3> relative_xyz(const Rgb& linear) {
    std::array<float, 3> xyz{};
    for (std::size_t row = 0; row < 3; ++row) {
        xyz[row] = (rgb_to_xyz[row][0] * linear[0] + rgb_to_xyz[row][1] * linear[1] + rgb_to_xyz[row][2] * linear[2]) /
                   white[row];
    }
    return xyz;
}

YCxCz to_ycxcz(const Rgb& linear) {
    const auto [x, y, z] = relative_xyz(linear);
    return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

Rgb clamped(Rgb colour) {
    for (float& channel : colour) {
        channel = std::clamp(channel, 0.0F, 1.0F);
    }
    return colour;
}

Rgb to_linear(const YCxCz& colour) {
    const float y = (colour.y + 16) / 116;
    const float x = y + colour.cx / 500;
    const float z = y - colour.cz / 200;
    Rgb rgb{};
    for (std::size_t row = 0; row < 3; ++row) {
        rgb[row] = relative_xyz_to_rgb[row][0] * x + relative_xyz_to_rgb[row][1] * y + relative_xyz_to_rgb[row][2] * z;
    }
    return rgb;
}

/// Of t > 0, to a float's precision. glibc's cbrtf took a third of the whole time; this one is inlined and vectorised.
float cube_root(float t) {
    // An exponent divided by three, with the offset that makes the error of the guess least (Kahan, 1991).
    constexpr std::uint32_t offset = 709958130;
    auto root = std::bit_cast<float>(std::bit_cast<std::uint32_t>(t) / 3 + offset);
    for (int halley = 0; halley < 2; ++halley) {
        const float cube = root * root * root;
        root *= (cube + 2 * t) / (2 * cube + t);
    }
    return root;
}

/// CIE 1976 L*a*b* with chroma scaled by lightness (the Hunt effect).
Lab to_hunt_adjusted_lab(const Rgb& linear) {
    constexpr float delta = 6.0F / 29;
    const auto curve = [](float t) {
        return t > delta * delta * delta ? cube_root(t) : t / (3 * delta * delta) + 4.0F / 29;
    };
    const auto [x, y, z] = relative_xyz(linear);
    const float f_y = curve(y);
    const float lightness = 116 * f_y - 16;
    const float hunt = 0.01F * lightness;
    return {lightness, hunt * 500 * (curve(x) - f_y), hunt * 200 * (f_y - curve(z))};
}

/// Abasi, Amani Tehran and Fairchild 2019: city-block in lightness, Euclidean in chroma.
float hyab(const Lab& first, const Lab& second) {
    const float a = first.a - second.a;
    const float b = first.b - second.b;
    return std::abs(first.l - second.l) + std::sqrt(a * a + b * b);
}

/// The largest colour difference, between green and blue.
float largest_colour_difference() {
    return std::pow(hyab(to_hunt_adjusted_lab({0, 1, 0}), to_hunt_adjusted_lab({0, 0, 1})), q_c);
}

/// Equation 5's redistribution of the colour difference to [0, 1].
float colour_difference(const Lab& first, const Lab& second, float c_max) {
    const float difference = std::pow(hyab(first, second), q_c);
    const float knee = p_c * c_max;
    return difference < knee ? p_t / knee * difference : p_t + (difference - knee) / (c_max - knee) * (1 - p_t);
}

/// Weights of taps −radius ... radius.
using Kernel = std::vector<float>;

/// Without the outer taps that a float sum does not feel.
Kernel trimmed(Kernel kernel) {
    constexpr float negligible = 1e-8F;
    while (kernel.size() > 1 && std::abs(kernel.front()) < negligible) {
        kernel.erase(kernel.begin());
        kernel.pop_back();
    }
    return kernel;
}

int radius_of(const Kernel& kernel) {
    return static_cast<int>(kernel.size() / 2);
}

/// exp(−x² / (2 σ²)), unnormalised, in pixels.
std::vector<double> gaussian(int radius, double deviation) {
    std::vector<double> values;
    for (int x = -radius; x <= radius; ++x) {
        values.push_back(std::exp(-x * x / (2 * deviation * deviation)));
    }
    return values;
}

double sum_of(const std::vector<double>& values) {
    double sum = 0;
    for (const double value : values) {
        sum += value;
    }
    return sum;
}

Kernel scaled(const std::vector<double>& values, double factor) {
    Kernel kernel;
    for (const double value : values) {
        kernel.push_back(static_cast<float>(value * factor));
    }
    return kernel;
}

/// The sensitivity's filter is the sum of `weight` · kernel(x) · kernel(y) over its Gaussians, and sums to 1.
struct SensitivityFilter {
    std::array<Kernel, 2> kernels;
    std::array<float, 2> weights{};
};

SensitivityFilter make_sensitivity_filter(const Sensitivity& channel, double pixels_per_degree, int radius) {
    const std::array<double, 2> a{channel.a1, channel.a2};
    const std::array<double, 2> b{channel.b1, channel.b2};
    SensitivityFilter filter;
    std::array<double, 2> volumes{};
    for (std::size_t i = 0; i < 2; ++i) {
        // a √(π/b) exp(−π² z / b), z in square degrees.
        const double deviation = std::sqrt(b[i] / 2) / std::numbers::pi * pixels_per_degree;
        const std::vector<double> values = gaussian(radius, deviation);
        const double sum = sum_of(values);
        volumes[i] = a[i] * std::sqrt(std::numbers::pi / b[i]) * sum * sum;
        filter.kernels[i] = trimmed(scaled(values, 1 / sum));
    }
    for (std::size_t i = 0; i < 2; ++i) {
        filter.weights[i] = static_cast<float>(volumes[i] / (volumes[0] + volumes[1]));
    }
    return filter;
}

/// Positive weights sum to 1 and negative ones to −1.
Kernel balanced(std::vector<double> values) {
    double positive = 0;
    double negative = 0;
    for (const double value : values) {
        (value > 0 ? positive : negative) += value;
    }
    for (double& value : values) {
        value /= value > 0 ? positive : -negative;
    }
    return scaled(values, 1);
}

struct Filters {
    SensitivityFilter achromatic, red_green, blue_yellow;
    /// Of the feature detector: a Gaussian and its first and second derivatives.
    Kernel smooth, edge, point;
    int radius = 0;
};

Filters make_filters(double pixels_per_degree) {
    const double widest_deviation = std::sqrt(widest_sensitivity / 2) / std::numbers::pi * pixels_per_degree;
    const int radius = static_cast<int>(std::ceil(extent_in_deviations * widest_deviation));
    Filters filters;
    filters.achromatic = make_sensitivity_filter(achromatic, pixels_per_degree, radius);
    filters.red_green = make_sensitivity_filter(red_green, pixels_per_degree, radius);
    filters.blue_yellow = make_sensitivity_filter(blue_yellow, pixels_per_degree, radius);

    const double deviation = 0.5 * w * pixels_per_degree;
    const int feature_radius = static_cast<int>(std::ceil(extent_in_deviations * deviation));
    const std::vector<double> smooth = gaussian(feature_radius, deviation);
    std::vector<double> edge = smooth;
    std::vector<double> point = smooth;
    for (int x = -feature_radius; x <= feature_radius; ++x) {
        const auto tap = static_cast<std::size_t>(x + feature_radius);
        edge[tap] *= -x;
        point[tap] *= x * x / (deviation * deviation) - 1;
    }
    filters.smooth = scaled(smooth, 1 / sum_of(smooth));
    filters.edge = balanced(edge);
    filters.point = balanced(point);
    filters.radius = std::max(radius, feature_radius);
    return filters;
}

/// out[x] = Σ kernel[k] · taps[k][x]: the accumulators of a few columns stay in registers.
void weigh(const Kernel& kernel, std::span<const float* const> taps, std::span<float> out) {
    constexpr std::size_t columns = 16;
    std::size_t x = 0;
    for (; x + columns <= out.size(); x += columns) {
        std::array<float, columns> sums{};
        for (std::size_t k = 0; k < kernel.size(); ++k) {
            const float* const in = taps[k] + x;
            for (std::size_t i = 0; i < columns; ++i) {
                sums[i] += kernel[k] * in[i];
            }
        }
        std::copy(sums.begin(), sums.end(), &out[x]);
    }
    for (; x < out.size(); ++x) {
        float sum = 0;
        for (std::size_t k = 0; k < kernel.size(); ++k) {
            sum += kernel[k] * taps[k][x];
        }
        out[x] = sum;
    }
}

/// Rows of floats of one width, each with `padding` more at both ends.
class Rows {
public:
    Rows(std::size_t rows, std::size_t width, std::size_t padding)
        : width_(width), padding_(padding), values_(rows * (width + 2 * padding)) {}

    float* row(std::size_t index) { return &values_[index * (width_ + 2 * padding_) + padding_]; }
    const float* row(std::size_t index) const { return &values_[index * (width_ + 2 * padding_) + padding_]; }

    /// Repeats the outermost values into the padding.
    void extend(std::size_t index) {
        float* const begin = row(index);
        std::fill(begin - padding_, begin, begin[0]);
        std::fill(begin + width_, begin + width_ + padding_, begin[width_ - 1]);
    }

private:
    std::size_t width_;
    std::size_t padding_;
    std::vector<float> values_;
};

/// What the final comparison needs of one row of one image.
struct FilteredRow {
    std::vector<float> y, cx, cz;
    std::vector<float> edge_x, edge_y, point_x, point_y;
};

/// A strip of rows of one image with all filters applied along x; those along y are applied row by row. Rows beyond
/// the image repeat its outermost ones.
class FilteredStrip {
public:
    FilteredStrip(const Image<Rgb>& image, const Filters& filters, std::size_t begin, std::size_t end)
        : filters_(&filters),
          width_(static_cast<std::size_t>(image.size.width)),
          halo_(static_cast<std::size_t>(filters.radius)),
          begin_(begin) {
        const std::size_t rows = end - begin + 2 * halo_;
        for (Rows* plane : {&y_, &red_green_, &blue_yellow_[0], &blue_yellow_[1], &smooth_, &edge_, &point_}) {
            *plane = Rows(rows, width_, 0);
        }
        Rows y(1, width_, halo_);
        Rows cx(1, width_, halo_);
        Rows cz(1, width_, halo_);
        for (std::size_t row = 0; row < rows; ++row) {
            const auto source = static_cast<std::ptrdiff_t>(begin + row) - static_cast<std::ptrdiff_t>(halo_);
            convert(image, static_cast<int>(std::clamp<std::ptrdiff_t>(source, 0, image.size.height - 1)), y, cx, cz);
            along_x(filters.achromatic.kernels[0], y, y_.row(row));
            along_x(filters.red_green.kernels[0], cx, red_green_.row(row));
            along_x(filters.blue_yellow.kernels[0], cz, blue_yellow_[0].row(row));
            along_x(filters.blue_yellow.kernels[1], cz, blue_yellow_[1].row(row));
            // The detector works on Y as a fraction; its kernels for edges and points do not see the offset.
            along_x(filters.smooth, y, smooth_.row(row));
            along_x(filters.edge, y, edge_.row(row));
            along_x(filters.point, y, point_.row(row));
        }
    }

    /// `row` of the image.
    void finish(std::size_t row, FilteredRow& out) const {
        along_y(filters_->achromatic.kernels[0], y_, row, out.y);
        along_y(filters_->red_green.kernels[0], red_green_, row, out.cx);
        along_y(filters_->blue_yellow.kernels[0], blue_yellow_[0], row, out.cz);
        std::vector<float> second(width_);
        along_y(filters_->blue_yellow.kernels[1], blue_yellow_[1], row, second);
        const auto [first_weight, second_weight] = filters_->blue_yellow.weights;
        for (std::size_t x = 0; x < width_; ++x) {
            out.cz[x] = first_weight * out.cz[x] + second_weight * second[x];
        }
        along_y(filters_->smooth, edge_, row, out.edge_x);
        along_y(filters_->edge, smooth_, row, out.edge_y);
        along_y(filters_->smooth, point_, row, out.point_x);
        along_y(filters_->point, smooth_, row, out.point_y);
    }

private:
    void convert(const Image<Rgb>& image, int source, Rows& y, Rows& cx, Rows& cz) const {
        for (std::size_t x = 0; x < width_; ++x) {
            const YCxCz colour = to_ycxcz(clamped(image.at(static_cast<int>(x), source)));
            y.row(0)[x] = colour.y;
            cx.row(0)[x] = colour.cx;
            cz.row(0)[x] = colour.cz;
        }
        for (Rows* plane : {&y, &cx, &cz}) {
            plane->extend(0);
        }
    }

    void along_x(const Kernel& kernel, const Rows& in, float* out) const {
        std::vector<const float*> taps;
        for (std::size_t k = 0; k < kernel.size(); ++k) {
            taps.push_back(in.row(0) + k - radius_of(kernel));
        }
        weigh(kernel, taps, {out, width_});
    }

    void along_y(const Kernel& kernel, const Rows& in, std::size_t row, std::vector<float>& out) const {
        std::vector<const float*> taps;
        const std::size_t first = row - begin_ + halo_ - static_cast<std::size_t>(radius_of(kernel));
        for (std::size_t k = 0; k < kernel.size(); ++k) {
            taps.push_back(in.row(first + k));
        }
        out.resize(width_);
        weigh(kernel, taps, out);
    }

    const Filters* filters_;
    std::size_t width_;
    std::size_t halo_;
    std::size_t begin_;
    Rows y_{0, 0, 0}, red_green_{0, 0, 0}, smooth_{0, 0, 0}, edge_{0, 0, 0}, point_{0, 0, 0};
    std::array<Rows, 2> blue_yellow_{Rows{0, 0, 0}, Rows{0, 0, 0}};
};

float length(float x, float y) {
    return std::sqrt(x * x + y * y);
}

/// Equation 6: the difference of edges or points, whichever is larger.
float feature_difference(const FilteredRow& first, const FilteredRow& second, std::size_t x) {
    constexpr float y_range = 116;
    const float edge = std::abs(length(first.edge_x[x], first.edge_y[x]) - length(second.edge_x[x], second.edge_y[x]));
    const float point =
        std::abs(length(first.point_x[x], first.point_y[x]) - length(second.point_x[x], second.point_y[x]));
    static_assert(q_f == 0.5F, "the square root below is the power of q_f");
    return std::min(1.0F, std::sqrt(std::max(edge, point) / (y_range * std::numbers::sqrt2_v<float>)));
}

Lab filtered_lab(const FilteredRow& row, std::size_t x) {
    return to_hunt_adjusted_lab(clamped(to_linear({row.y[x], row.cx[x], row.cz[x]})));
}

}  // namespace

Image<float> flip_map(const Image<Rgb>& first, const Image<Rgb>& second, double pixels_per_degree) {
    assert(first.size == second.size);
    constexpr std::size_t strip_rows = 64;
    const Filters filters = make_filters(pixels_per_degree);
    const float c_max = largest_colour_difference();
    Image<float> map(first.size);
    parallel_for(static_cast<std::size_t>(first.size.height), strip_rows, [&](std::size_t begin, std::size_t end) {
        const FilteredStrip first_strip(first, filters, begin, end);
        const FilteredStrip second_strip(second, filters, begin, end);
        FilteredRow a;
        FilteredRow b;
        for (std::size_t row = begin; row < end; ++row) {
            first_strip.finish(row, a);
            second_strip.finish(row, b);
            for (std::size_t x = 0; x < a.y.size(); ++x) {
                const float colour = colour_difference(filtered_lab(a, x), filtered_lab(b, x), c_max);
                map.at(static_cast<int>(x), static_cast<int>(row)) = std::pow(colour, 1 - feature_difference(a, b, x));
            }
        }
    });
    return map;
}

}  // namespace reliefbench
