#include "measure/base_records.hpp"

#include "core/attempt.hpp"
#include "core/counted.hpp"
#include "core/error.hpp"
#include "core/hash.hpp"
#include "core/log.hpp"
#include "scene/surface/file_base.hpp"

#include <algorithm>
#include <set>
#include <span>
#include <utility>

namespace reliefbench {

namespace {

/// A mesh file, and the height scales of the cells on it.
struct UsedBase {
    BaseSource source;
    std::set<double> height_scales;
};

std::vector<UsedBase> used_files(const std::vector<Cell>& cells) {
    std::vector<UsedBase> used;
    for (const Cell& cell : cells) {
        const BaseSource& source = cell.view.base;
        if (source.kind != BaseSource::Kind::file) continue;
        auto known = std::ranges::find(used, source, &UsedBase::source);
        if (known == used.end()) known = used.insert(known, {source, {}});
        known->height_scales.insert(cell.view.view.relief.height_scale);
    }
    return used;
}

void warn_of_base(const BaseMesh& mesh, const UsedBase& used) {
    const std::string name = used.source.file.string();
    for (const std::string& warning : mesh.warnings)
        log_warning("mesh '{}': {}", name, warning);
    for (const double height_scale : used.height_scales) {
        const std::size_t folded = count_folded_prisms(mesh, height_scale);
        if (folded == 0) continue;
        log_warning("mesh '{}': {} of {} turn inside out within the height scale {}, where the relief folds; lower it",
                    name, folded, counted(mesh.triangles.size(), "prism"), height_scale);
    }
}

}  // namespace

std::string hash_of_mesh(const BaseMesh& mesh) {
    return content_hash(content_hash(std::as_bytes(std::span(mesh.vertices))) +
                        content_hash(std::as_bytes(std::span(mesh.triangles))));
}

Json inspect_bases(const std::vector<Cell>& cells) {
    Json records = Json::array();
    for (const UsedBase& used : used_files(cells)) {
        BaseMesh mesh;
        if (!fits_in_memory([&] { mesh = load_file_base(used.source); })) {
            fail("mesh '{}' takes more memory to read than there is: simplify it", used.source.file.string());
        }
        warn_of_base(mesh, used);
        Json record;
        record["name"] = mesh.name;
        record["base_fit"] = used.source.fit == BaseSource::Fit::unit ? "unit" : "none";
        record["scale"] = mesh.scale;
        record["vertices"] = mesh.vertices.size();
        record["triangles"] = mesh.triangles.size();
        record["charts"] = mesh.chart_periods.size();
        record["hash"] = hash_of_mesh(mesh);
        records.push_back(std::move(record));
    }
    return records;
}

}  // namespace reliefbench
