#pragma once

#include <filesystem>
#include <string>

namespace reliefbench {

/// Where a base surface comes from. Plain data: nothing is generated or loaded.
struct BaseSource {
    enum class Kind { plane, cylinder, sphere, saddle, file };
    /// How a file's mesh is placed: scaled evenly to the unit patch's size and centred on it, or left as it is.
    enum class Fit { unit, none };

    Kind kind = Kind::plane;
    /// Kind::file only: OBJ or glTF 2.0 (.obj, .gltf, .glb).
    std::filesystem::path file = {};
    Fit fit = Fit::unit;
    /// κ of the generated ones, in 1/patch side: positive bends away from the viewer.
    double curvature = 1;
    /// Along each side of the generated ones, each of two triangles.
    int segments = 128;

    bool is_flat() const { return kind == Kind::plane; }
    bool is_generated() const { return kind != Kind::plane && kind != Kind::file; }
    bool operator==(const BaseSource&) const = default;
};

}  // namespace reliefbench
