#include "reference/packet_tracer.hpp"

#include <algorithm>

namespace reliefbench {

/// Without Highway every ray walks alone.
void find_crossings(const PacketScene& /*scene*/, std::span<const Ray> rays, PacketCrossings& crossings) {
    std::fill_n(crossings.begin(), rays.size(), not_decided);
}

}  // namespace reliefbench
