// A configuration, with what -a says after it: what is accepted means the same when run.json repeats it.

#include "core/error.hpp"
#include "fuzz/fuzz_target.hpp"
#include "sweep/configuration.hpp"
#include "sweep/plan.hpp"

#include <filesystem>
#include <string_view>

namespace {

using namespace reliefbench;

/// Between the file and each override.
constexpr std::string_view override_start = "\n-a ";
/// More cells take long and show nothing new.
constexpr double max_cells = 500;

std::vector<Manifest> shipped_techniques() {
    const std::filesystem::path root = RELIEFBENCH_SOURCE_DIR;
    std::vector<Manifest> techniques;
    for (const char* id : {"flat", "pom", "qdm", "quad_split", "tessellation"}) {
        if (!std::filesystem::exists(root / "techniques" / id)) continue;
        techniques.push_back(load_manifest(root / "techniques" / id, root / "harness" / "shaders"));
    }
    return techniques;
}

double count_cells(const Plan& plan) {
    double count = static_cast<double>(plan.techniques.size());
    for (const AxisGroup& group : plan.groups)
        count *= static_cast<double>(group.length);
    for (const PlannedTechnique& technique : plan.techniques) {
        for (const auto& [name, values] : technique.selection->parameters)
            count *= static_cast<double>(values.size());
    }
    return count;
}

void read(std::string_view text) {
    static const std::vector<Manifest> techniques = shipped_techniques();
    std::vector<std::string> overrides;
    for (std::size_t at = text.rfind(override_start); at != std::string_view::npos; at = text.rfind(override_start)) {
        overrides.emplace_back(text.substr(at + override_start.size()));
        text = text.substr(0, at);
    }
    const Configuration configuration =
        parse_configuration(parse_json(text, "fuzz.json"), "fuzz.json", overrides, techniques);
    const Json again = parse_json(configuration.expanded.dump(), "run.json");
    fuzz_require(parse_configuration(again, "run.json", {}, techniques).expanded == configuration.expanded);
    if (count_cells(plan_sweep(configuration, techniques)) <= max_cells) expand(configuration, techniques);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        read({reinterpret_cast<const char*>(data), size});
    } catch (const Error&) {
        // Refused, as it may be.
    }
    return 0;
}
