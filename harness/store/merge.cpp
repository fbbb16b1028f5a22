#include "store/merge.hpp"

#include "core/counted.hpp"
#include "core/error.hpp"
#include "core/json_lookup.hpp"
#include "core/suggest.hpp"
#include "store/resume.hpp"

#include <algorithm>
#include <cassert>
#include <map>
#include <unordered_map>
#include <utility>

namespace reliefbench {

namespace {

struct ShardNumber {
    std::int64_t index = 0;
    std::int64_t count = 0;
};

ShardNumber shard_of(const NamedRun& run) {
    const JsonView record(run.run.run, run.name);
    if (!record.has("shard")) fail("{} is no shard: its run.json has no 'shard'; there is nothing to merge", run.name);
    const JsonView shard = record.at("shard");
    const ShardNumber number{shard.at("index").integer(1), shard.at("count").integer(1)};
    if (number.index > number.count) fail("{}: shard {} of {} cannot be", run.name, number.index, number.count);
    return number;
}

/// Shards inspect the height maps and bases of their own cells only: those that several have must agree, and all are
/// kept. `list`, in run.json, of what people call `what`; those that are the same in all `identity` are one.
void add_inputs(Json& all, const NamedRun& run, const char* list, const char* what,
                const std::vector<const char*>& identity) {
    const auto inputs = run.run.run.find(list);
    if (inputs == run.run.run.end() || !inputs->is_array()) return;
    for (const Json& input : *inputs) {
        const auto is_same = [&](const Json& other) {
            return std::ranges::all_of(
                identity, [&](const char* key) { return value_at(other, {key}) == value_at(input, {key}); });
        };
        const auto known = std::find_if(all.begin(), all.end(), is_same);
        if (known == all.end()) {
            all.push_back(input);
        } else if (*known != input) {
            fail("{} has another {} '{}' than the shards before it; measure one of them again", run.name, what,
                 scalar_text(value_at(input, {"name"})));
        }
    }
}

/// What resume_differences compares, without what only some shards have.
Json comparable(Json record) {
    record.erase("height_maps");
    record.erase("bases");
    record.erase("techniques");
    record.erase("shard");
    return record;
}

void add_techniques(Json& all, const NamedRun& run) {
    const auto techniques = run.run.run.find("techniques");
    if (techniques == run.run.run.end() || !techniques->is_object()) return;
    for (const auto& [id, hash] : techniques->items()) {
        if (all.contains(id) && all.at(id) != hash) {
            fail(
                "{} was drawn with other sources of the technique '{}' than the shards before it; measure one of them "
                "again",
                run.name, id);
        }
        all[id] = hash;
    }
}

/// As each shard records the defaults of its own techniques.
void add_defaults(Json& all, const NamedRun& run) {
    const Json parameters = value_at(run.run.run, {"defaults", "parameters"});
    if (!parameters.is_object()) return;
    for (const auto& [technique, values] : parameters.items())
        all["defaults"]["parameters"][technique] = values;
}

/// As each shard records those of its own cells.
void add_presets(Json& all, const NamedRun& run) {
    const Json techniques = value_at(run.run.run, {"presets"});
    if (!techniques.is_object()) return;
    for (const auto& [technique, presets] : techniques.items())
        all["presets"][technique].update(presets);
}

void require_same_run(const NamedRun& first, const NamedRun& other) {
    const std::vector<std::string> differences =
        resume_differences(comparable(first.run.run), comparable(other.run.run));
    if (differences.empty()) return;
    fail("{} and {} are no shards of one run: {}; their times would not be of one thing", first.name, other.name,
         join(differences, "; "));
}

Json part_record(const NamedRun& run) {
    Json part;
    part["name"] = run.name;
    for (const char* key : {"shard", "environment", "device"})
        part[key] = run.run.run.contains(key) ? run.run.run.at(key) : Json(nullptr);
    if (run.run.run.contains("resumed")) part["resumed"] = run.run.run.at("resumed");
    part["cells"] = Json::array();
    for (const CellResult& cell : run.run.cells)
        part["cells"].push_back(cell.cell);
    return part;
}

/// No shard and no cell stands in two of the runs.
class SeenOnce {
public:
    void add_shard(const ShardNumber& shard, const std::string& run) {
        if (const auto [place, is_new] = run_of_shard_.emplace(shard.index, run); !is_new) {
            fail("{} and {} are both shard {}/{}; leave one of them out", place->second, run, shard.index, shard.count);
        }
    }

    void add_cell(const std::string& cell, const std::string& run) {
        if (const auto [place, is_new] = run_of_cell_.emplace(cell, &run); !is_new) {
            fail("the cell '{}' stands in {} and in {}; leave one of them out", cell, *place->second, run);
        }
    }

    /// In words: shards first.
    std::vector<std::string> missing(std::int64_t shards, std::span<const PlannedCell> planned) const {
        std::vector<std::string> missing;
        for (std::int64_t index = 1; index <= shards; ++index) {
            if (!run_of_shard_.contains(index)) missing.push_back(fmt::format("shard {}/{}", index, shards));
        }
        std::map<std::int64_t, std::vector<std::string>> cells_of_shard;
        for (const PlannedCell& cell : planned) {
            const auto shard = static_cast<std::int64_t>(cell.shard);
            if (run_of_shard_.contains(shard) && !run_of_cell_.contains(cell.cell))
                cells_of_shard[shard].push_back(cell.cell);
        }
        for (const auto& [shard, cells] : cells_of_shard) {
            missing.push_back(fmt::format(
                "{} of shard {}/{} ({}): '{}'{}", cells.size() == 1 ? "a cell" : fmt::format("{} cells", cells.size()),
                shard, shards, run_of_shard_.at(shard), cells.front(), cells.size() == 1 ? "" : " and others"));
        }
        return missing;
    }

private:
    std::map<std::int64_t, std::string> run_of_shard_;
    std::unordered_map<std::string, const std::string*> run_of_cell_;
};

}  // namespace

MergedRun merge_runs(std::vector<NamedRun> shards, std::span<const PlannedCell> planned) {
    assert(!shards.empty());
    const NamedRun& first = shards.front();
    const std::int64_t count = shard_of(first).count;
    SeenOnce seen;
    Json height_maps = Json::array();
    Json bases = Json::array();
    Json techniques = Json::object();
    MergedRun merged;
    merged.run.run = first.run.run;
    merged.run.run.erase("shard");
    merged.run.run.erase("resumed");
    merged.run.run["merged"] = Json::array();
    for (NamedRun& run : shards) {
        const ShardNumber shard = shard_of(run);
        if (shard.count != count) {
            fail("{} is one of {}, {} one of {}: they are parts of different runs", first.name, counted(count, "shard"),
                 run.name, shard.count);
        }
        require_same_run(first, run);
        seen.add_shard(shard, run.name);
        add_inputs(height_maps, run, "height_maps", "height map", {"name", "format", "size"});
        add_inputs(bases, run, "bases", "base", {"name", "base_fit"});
        add_techniques(techniques, run);
        add_defaults(merged.run.run, run);
        add_presets(merged.run.run, run);
        merged.run.run["merged"].push_back(part_record(run));
        for (CellResult& cell : run.run.cells) {
            seen.add_cell(cell.cell, run.name);
            merged.run.cells.push_back(std::move(cell));
        }
        run.run.cells.clear();
    }
    merged.run.run["height_maps"] = std::move(height_maps);
    if (!bases.empty()) merged.run.run["bases"] = std::move(bases);
    merged.run.run["techniques"] = std::move(techniques);
    merged.missing = seen.missing(count, planned);
    return merged;
}

}  // namespace reliefbench
