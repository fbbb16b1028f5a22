#include "metrics/flip_rows.hpp"

#include <algorithm>
#include <cmath>

namespace reliefbench::flip {

namespace {

std::size_t rounded_up(std::size_t count) {
    return (count + filter_columns - 1) / filter_columns * filter_columns;
}

void to_lab(const float* y, const float* cx, const std::array<const float*, 2>& cz, SeenRow& out) {
    const float *cz1 = cz[0], *cz2 = cz[1];
    float *l = out.l.data(), *a = out.a.data(), *b = out.b.data();
    for (std::size_t x = 0; x < out.l.size(); ++x) {
        const Lab lab = to_hunt_adjusted_lab(clamped(to_linear({y[x], cx[x], cz1[x] + cz2[x]})));
        l[x] = lab.l;
        a[x] = lab.a;
        b[x] = lab.b;
    }
}

void to_lengths(const float* along_x, const float* along_y, std::vector<float>& lengths) {
    float* const out = lengths.data();
    for (std::size_t x = 0; x < lengths.size(); ++x) {
        out[x] = std::sqrt(along_x[x] * along_x[x] + along_y[x] * along_y[x]);
    }
}

}  // namespace

FilteredRows::FilteredRows(const Image<Rgb>& image, const Filters& filters, std::size_t first)
    : image_(&image),
      filters_(&filters),
      row_(static_cast<std::ptrdiff_t>(first)),
      window_(2 * static_cast<std::ptrdiff_t>(filters.radius) + 1),
      width_(rounded_up(static_cast<std::size_t>(image.size.width))),
      stride_(rounded_up(width_ + 2 * filters.radius)) {
    offsets_.resize(static_cast<std::size_t>(window_));
    for (Plane* plane : {&y_, &cx_, &cz_}) {
        plane->resize(static_cast<std::size_t>(window_) * stride_);
    }
    for (Plane* row : {&half_.achromatic, &half_.smooth, &half_.point, &half_.edge, &half_.red_green,
                       &half_.blue_yellow[0], &half_.blue_yellow[1]}) {
        row->resize(stride_);
    }
    for (Plane* row : {&filtered_.y, &filtered_.cx, &filtered_.cz[0], &filtered_.cz[1], &filtered_.edge_x,
                       &filtered_.edge_y, &filtered_.point_x, &filtered_.point_y}) {
        row->resize(width_);
    }
    const std::ptrdiff_t reach = window_ / 2;
    for (std::ptrdiff_t row = row_ - reach; row < row_ + reach; ++row) {
        convert(row);
    }
}

std::size_t FilteredRows::offset_of(std::ptrdiff_t row) const {
    return static_cast<std::size_t>((row + window_) % window_) * stride_;
}

void FilteredRows::convert(std::ptrdiff_t row) {
    const auto pixels = static_cast<std::size_t>(image_->size.width);
    const std::size_t radius = filters_->radius;
    const auto source = std::clamp<std::ptrdiff_t>(row, 0, image_->size.height - 1);
    const Rgb* const colours = &image_->at(0, static_cast<int>(source));
    float* const y = &y_[offset_of(row)];
    float* const cx = &cx_[offset_of(row)];
    float* const cz = &cz_[offset_of(row)];
    for (std::size_t x = 0; x < pixels; ++x) {
        const YCxCz colour = to_ycxcz(clamped(colours[x]));
        y[radius + x] = colour.y;
        cx[radius + x] = colour.cx;
        cz[radius + x] = colour.cz;
    }
    for (float* const plane : {y, cx, cz}) {
        std::fill_n(plane, radius, plane[radius]);
        std::fill(plane + radius + pixels, plane + stride_, plane[radius + pixels - 1]);
    }
}

void FilteredRows::filter_along_y() {
    const std::ptrdiff_t reach = window_ / 2;
    for (std::ptrdiff_t tap = -reach; tap <= reach; ++tap) {
        offsets_[static_cast<std::size_t>(tap + reach)] = offset_of(row_ + tap);
    }
    const auto filter = [&](const auto& bank, const Plane& in, const auto& out) {
        apply(
            bank, [&, offsets = offsets_.data() + reach](std::ptrdiff_t tap) { return in.data() + offsets[tap]; },
            stride_, out);
    };
    filter(filters_->luminance, y_,
           std::array{half_.achromatic.data(), half_.smooth.data(), half_.point.data(), half_.edge.data()});
    filter(filters_->red_green, cx_, std::array{half_.red_green.data()});
    filter(filters_->blue_yellow, cz_, std::array{half_.blue_yellow[0].data(), half_.blue_yellow[1].data()});
}

void FilteredRows::filter_along_x() {
    const auto filter = [this](const auto& bank, const Plane& in, const auto& out) {
        const float* const origin = in.data() + filters_->radius;
        apply(
            bank, [=](std::ptrdiff_t tap) { return origin + tap; }, width_, out);
    };
    filter(filters_->achromatic, half_.achromatic, std::array{filtered_.y.data()});
    filter(filters_->red_green, half_.red_green, std::array{filtered_.cx.data()});
    filter(filters_->blue_yellow_shares[0], half_.blue_yellow[0], std::array{filtered_.cz[0].data()});
    filter(filters_->blue_yellow_shares[1], half_.blue_yellow[1], std::array{filtered_.cz[1].data()});
    // The detector works on Y as a fraction of its range; derivatives do not see the offset.
    filter(filters_->point_and_edge, half_.smooth, std::array{filtered_.point_x.data(), filtered_.edge_x.data()});
    filter(filters_->smooth, half_.point, std::array{filtered_.point_y.data()});
    filter(filters_->smooth, half_.edge, std::array{filtered_.edge_y.data()});
}

void FilteredRows::next(SeenRow& out) {
    for (std::vector<float>* values : {&out.l, &out.a, &out.b, &out.edge, &out.point}) {
        values->resize(width_);
    }
    convert(row_ + window_ / 2);
    filter_along_y();
    filter_along_x();
    to_lab(filtered_.y.data(), filtered_.cx.data(), {filtered_.cz[0].data(), filtered_.cz[1].data()}, out);
    to_lengths(filtered_.edge_x.data(), filtered_.edge_y.data(), out.edge);
    to_lengths(filtered_.point_x.data(), filtered_.point_y.data(), out.point);
    ++row_;
}

}  // namespace reliefbench::flip
