// A mesh file, an OBJ unless its first bytes are those of a .glb or of JSON: what is accepted is a base that can be
// drawn.

#include "core/error.hpp"
#include "fuzz/fuzz_target.hpp"
#include "scene/camera.hpp"
#include "scene/surface/chart_grid.hpp"
#include "scene/surface/file_base.hpp"
#include "scene/surface/mesh_view.hpp"

#include <fmt/format.h>
#include <unistd.h>
#include <glm/geometric.hpp>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

namespace {

using namespace reliefbench;

bool all_finite(const MeshVertex& vertex) {
    for (int axis = 0; axis < 3; ++axis) {
        if (!std::isfinite(vertex.position[axis]) || !std::isfinite(vertex.normal[axis])) return false;
    }
    return std::isfinite(vertex.uv.x) && std::isfinite(vertex.uv.y);
}

void check(const BaseMesh& mesh) {
    fuzz_require(!mesh.triangles.empty() && mesh.charts.size() == mesh.triangles.size());
    for (const MeshVertex& vertex : mesh.vertices)
        fuzz_require(all_finite(vertex) && std::abs(glm::length(vertex.normal) - 1) < 1e-5f);
    const ChartGrid grid = make_chart_grid(mesh);
    for (std::size_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
        fuzz_require(mesh.charts[triangle] < mesh.chart_periods.size() && chart_area(mesh, triangle) != 0);
        glm::dvec2 middle(0);
        for (const std::uint32_t corner : mesh.triangles[triangle]) {
            fuzz_require(corner < mesh.vertices.size());
            middle += glm::dvec2(mesh.vertices[corner].uv) / 3.0;
        }
        fuzz_require(find_triangle(mesh, grid, mesh.charts[triangle], middle) != no_triangle);
    }
    count_folded_prisms(mesh, 0.05);
    const Camera camera{.projection = Projection::parallel, .view_angle = 60};
    fuzz_require(std::isfinite(parallel_window(mesh, camera, 0.05).depth));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    // A small file may claim a large mesh.
    static const int limited = setenv("RELIEFBENCH_MEMORY_MB", "256", 1);
    fuzz_require(limited == 0);
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    const char* const name = bytes.starts_with("glTF") ? "mesh.glb" : bytes.starts_with("{") ? "mesh.gltf" : "mesh.obj";
    static const std::filesystem::path folder =
        std::filesystem::temp_directory_path() / fmt::format("reliefbench_mesh_fuzz_{}", getpid());
    std::filesystem::create_directory(folder);
    // Not by write_text_file, which waits for the disk.
    std::ofstream(folder / name, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(size));
    for (const BaseSource::Fit fit : {BaseSource::Fit::unit, BaseSource::Fit::none}) {
        try {
            check(load_file_base({.kind = BaseSource::Kind::file, .file = folder / name, .fit = fit}));
        } catch (const Error&) {
            // Refused, as it may be.
        }
    }
    std::filesystem::remove_all(folder);
    return 0;
}
