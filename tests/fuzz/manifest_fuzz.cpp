// A technique.json.

#include "core/error.hpp"
#include "fuzz/fuzz_target.hpp"
#include "manifest/manifest.hpp"

#include <filesystem>
#include <string_view>

using namespace reliefbench;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const std::filesystem::path shared = std::filesystem::path(RELIEFBENCH_SOURCE_DIR) / "harness" / "shaders";
    try {
        const std::string_view text(reinterpret_cast<const char*>(data), size);
        const Manifest manifest = parse_manifest(parse_json(text, "technique.json"), "fuzz", "technique.json", shared);
        ParameterValues values = manifest.defaults();
        for (const Parameter& parameter : manifest.parameters)
            fuzz_require(check_parameter_value(parameter, values.at(parameter.name)).empty());
        if (manifest.sample_count) set_sample_count(manifest, values, 7, manifest.defaults());
        reset_idle(manifest, values, true);
        for (const MapDeclaration& map : manifest.maps)
            map.slices(values);
        manifest.shape.patch_corners(values);
    } catch (const Error&) {
        // Refused, as it may be.
    }
    return 0;
}
