#pragma once

#include "metrics/flip_colour.hpp"
#include "metrics/flip_filters.hpp"
#include "scene/image.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace reliefbench::flip {

/// One row of one image as FLIP compares it: Hunt-adjusted L*a*b* after the eye's filter, and how much of an edge and
/// of a point each pixel is. A value per pixel, and some of padding.
struct SeenRow {
    std::vector<float> l, a, b;
    std::vector<float> edge, point;
};

/// Rows of an image one after the other. Only those that the filters of the current one reach are kept, so that they
/// stay in the cache. Beyond the image's border its outermost pixels are repeated.
class FilteredRows {
public:
    /// Linear RGB, from row `first` on. Image and filters must outlive it.
    FilteredRows(const Image<Rgb>& image, const Filters& filters, std::size_t first);

    /// The next row.
    void next(SeenRow& out);

private:
    using Plane = std::vector<float>;

    std::size_t offset_of(std::ptrdiff_t row) const;
    void convert(std::ptrdiff_t row);
    void filter_along_y();
    void filter_along_x();

    const Image<Rgb>* image_;
    const Filters* filters_;
    std::ptrdiff_t row_;
    /// Rows kept.
    std::ptrdiff_t window_;
    /// Pixels of a row, rounded up to what filters take at once; and with the columns beyond both ends.
    std::size_t width_;
    std::size_t stride_;
    /// Row r is the (r mod window)-th.
    Plane y_, cx_, cz_;
    /// Of the rows that the current one's filters reach, from top to bottom.
    std::vector<std::size_t> offsets_;

    /// One row, filtered along y: named as the filters are.
    struct HalfFiltered {
        Plane achromatic, smooth, point, edge, red_green;
        std::array<Plane, 2> blue_yellow;
    } half_;

    /// The same row, filtered along both: colours (Cz is the sum of two), the detector's first and second derivatives.
    struct Filtered {
        Plane y, cx, edge_x, edge_y, point_x, point_y;
        std::array<Plane, 2> cz;
    } filtered_;
};

}  // namespace reliefbench::flip
