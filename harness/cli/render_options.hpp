#pragma once

#include "cli/shared_options.hpp"
#include "picture/pixel_map.hpp"
#include "scene/lighting.hpp"
#include "scene/scene_object.hpp"
#include "sweep/cell.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace reliefbench {

/// The command line of `reliefbench render`.
struct RenderOptions {
    std::vector<std::string> techniques;
    std::vector<std::string> parameters;
    std::vector<std::string> axes;
    /// Empty without.
    std::string show;
    /// An axis and its values; empty without.
    std::string animation;
    bool contact_sheet = false;
    /// Parts of a configuration as JSON; empty without.
    std::string lighting;
    std::string object;
    std::string output;
    TechniqueOptions library;
    DeviceChoice device;
    PreparationOptions preparation;
};

/// What --show asks for, in its order.
struct Shown {
    enum class Kind { picture, truth, map };
    Kind kind = Kind::picture;
    /// Of a map.
    PixelMap map = PixelMap::uv_error;
};

/// Of --lighting and --object; what is left out has the defaults of a configuration.
Lighting lighting_of(const RenderOptions& options);
std::optional<SceneObject> object_of(const RenderOptions& options);

/// Without --show: picture, truth and UV error; of a contact sheet truth, picture, UV error, FLIP and taps.
std::vector<Shown> shown_by(const RenderOptions& options);

/// Whether the file name asks for PNG pictures or EXR layers. An Error for any other, and where its folder is missing:
/// said before there is anything to lose.
enum class OutputKind { picture, layers };
OutputKind check_output(const std::string& path);

/// The cells to draw: one; one per frame, in the order of the values; or one per row of a contact sheet. What does not
/// fit together (--contact-sheet with --animate, several values where one cell is drawn, a parameter that no technique
/// has) is an Error.
std::vector<Cell> cells_to_render(const RenderOptions& options, const TechniqueLibrary& library);

/// "turn.png" → "turn_007.png", with as many digits as the last frame needs, but three at least.
std::filesystem::path frame_path(const std::filesystem::path& output, std::size_t frame, std::size_t frames);

}  // namespace reliefbench
