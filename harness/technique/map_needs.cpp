#include "technique/map_needs.hpp"

#include <fmt/format.h>

#include <bit>

namespace reliefbench {

namespace {

bool is_power_of_two(int side) {
    return std::has_single_bit(static_cast<unsigned>(side));
}

std::string unmet_by_map(MapNeed need, Resolution height_map, const Relief& relief) {
    const std::string size = fmt::format("{}x{}", height_map.width, height_map.height);
    switch (need) {
        case MapNeed::square:
            if (height_map.width == height_map.height) return {};
            return fmt::format("the technique needs a square height map; this one is {}", size);
        case MapNeed::power_of_two:
            if (is_power_of_two(height_map.width) && is_power_of_two(height_map.height)) return {};
            return fmt::format("the technique needs a height map whose sides are powers of two; this one is {}", size);
        case MapNeed::untiled:
            if (relief.tiling == 1 && relief.boundary == Boundary::clip) return {};
            return fmt::format("the technique needs the height map once on the patch (tiling 1, boundary clip); {}",
                               relief.tiling == 1 ? "here the boundary is " + to_string(relief.boundary)
                                                  : fmt::format("here the tiling is {}", relief.tiling));
    }
    return {};
}

}  // namespace

std::string unmet_map_need(const Manifest& manifest, Resolution height_map, const Relief& relief) {
    for (const MapNeed need : manifest.map_needs) {
        std::string reason = unmet_by_map(need, height_map, relief);
        if (!reason.empty()) return reason;
    }
    return {};
}

}  // namespace reliefbench
