#include "verify/conformance.hpp"

#include "verify/general_checks.hpp"
#include "verify/promise_checks.hpp"

#include <fmt/format.h>

namespace reliefbench {

std::vector<Check> verify_technique(const gpu::Device& device, const Technique& technique,
                                    const std::function<void(const Check&)>& on_check,
                                    const PreparationSettings& preparation) {
    CheckList list(device, technique, on_check, preparation);
    if (!check_supported(list) || !check_compiles(list)) return list.take();
    check_pictures(list);
    check_polygon(list);
    check_work(list);
    for (const PromiseDeclaration& declaration : technique.manifest.promises)
        check_promise(list, declaration);
    return list.take();
}

std::vector<std::string> render_words(const Manifest& manifest, const Check::Drawn& drawn, const std::string& output) {
    const auto& [map, map_size, view] = drawn.where;
    std::vector<std::string> words{"render", "--technique", manifest.id};
    const auto add = [&words](const char* option, const std::string& word) {
        words.emplace_back(option);
        words.push_back(word);
    };
    const ParameterValues defaults = manifest.defaults();
    for (const auto& [name, value] : drawn.parameters) {
        if (defaults.at(name) != value) add("--set", fmt::format("{}={}", name, to_string(value)));
    }
    const bool is_ones = map == map_of_ones;
    add("-a", fmt::format("heightmap={}{}", map, is_ones ? ".pgm" : ""));
    if (!is_ones) add("-a", fmt::format("heightmap_size={}x{}", map_size.width, map_size.height));
    add("-a", fmt::format("projection={}", to_string(view.camera.projection)));
    add("-a", fmt::format("view_angle={}", view.camera.view_angle));
    add("-a", fmt::format("azimuth={}", view.camera.azimuth));
    add("-a", fmt::format("height_scale={}", view.relief.height_scale));
    add("-a", fmt::format("tiling={}", view.relief.tiling));
    add("-a", fmt::format("boundary={}", to_string(view.relief.boundary)));
    add("-a", fmt::format("resolution={}x{}", view.resolution.width, view.resolution.height));
    add("-o", output);
    return words;
}

std::string map_making_command(const Check::Drawn& drawn) {
    if (drawn.where.map != map_of_ones) return {};
    const Resolution size = drawn.where.map_size;
    return fmt::format("{{ printf 'P5 {} {} 255 '; head -c {} /dev/zero | tr '\\0' '\\377'; }} > {}.pgm", size.width,
                       size.height, size.pixels(), map_of_ones);
}

}  // namespace reliefbench
