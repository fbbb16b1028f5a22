#include "store/device_share.hpp"

#include "core/json_lookup.hpp"

#include <fmt/format.h>

#include <vector>

namespace reliefbench {

namespace {

/// What each execution of the run says of itself; null where it says nothing.
void collect(const Json& run, std::vector<Json>& said) {
    said.push_back(value_at(run, {"environment", "shared_device"}));
    for (const Json& resumed : value_at(run, {"resumed"}))
        said.push_back(value_at(resumed, {"environment", "shared_device"}));
}

}  // namespace

DeviceShare device_share(const Json& run) {
    std::vector<Json> said;
    const Json parts = value_at(run, {"merged"});
    // A merged run's own environment is that of its first part.
    if (!parts.is_array() || parts.empty()) collect(run, said);
    for (const Json& part : parts)
        collect(part, said);
    std::size_t shared = 0;
    std::size_t alone = 0;
    for (const Json& value : said) {
        shared += value == true ? 1 : 0;
        alone += value == false ? 1 : 0;
    }
    if (shared == said.size()) return DeviceShare::always;
    if (shared > 0) return DeviceShare::partly;
    return alone == said.size() ? DeviceShare::never : DeviceShare::unknown;
}

std::string describe(DeviceShare share, const std::string& whose) {
    if (share == DeviceShare::unknown || share == DeviceShare::never) return {};
    return fmt::format("{} were {}made with --share-device: another process may have measured on the device meanwhile",
                       whose, share == DeviceShare::partly ? "partly " : "");
}

}  // namespace reliefbench
