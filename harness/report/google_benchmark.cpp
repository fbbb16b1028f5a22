#include "report/google_benchmark.hpp"

#include "core/parallel.hpp"
#include "core/statistics.hpp"
#include "report/benchmark_counters.hpp"
#include "store/device_share.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

namespace reliefbench {

namespace {

/// compare.py prints times without decimals.
constexpr const char* time_unit = "ns";
constexpr double ns_per_ms = 1e6;

using Counters = std::vector<std::pair<std::string, double>>;

/// A member of the run's record, or null.
Json member(const Json& record, const char* object, const char* key) {
    const auto found = record.find(object);
    if (found == record.end() || !found->is_object()) return nullptr;
    return found->value(key, Json(nullptr));
}

Json context_of(const Json& record) {
    Json context;
    const auto add = [&](const char* key, const Json& value) {
        if (!value.is_null()) context[key] = value;
    };
    add("date", member(record, "environment", "time"));
    context["host_name"] = "";
    context["executable"] = "reliefbench";
    add("num_cpus", member(record, "environment", "cores"));
    context["caches"] = Json::array();
    context["load_avg"] = Json::array();
    context["library_build_type"] = "release";  // what is timed runs on the device, however the tool was built
    add("device", member(record, "device", "name"));
    add("driver", member(record, "device", "driver"));
    add("driver_version", member(record, "device", "driver_version"));
    add("tool_version", member(record, "environment", "tool_version"));
    if (const DeviceShare share = device_share(record); share == DeviceShare::always || share == DeviceShare::partly)
        context["shared_device"] = "true";
    add("git_revision", member(record, "environment", "git_revision"));
    add("configuration", member(record, "configuration", "name"));
    return context;
}

/// All entries of one cell begin alike.
Json entry_of(const std::string& id, std::size_t family, const std::string& suffix, const char* run_type,
              std::size_t repetitions) {
    Json entry;
    entry["name"] = id + suffix;
    entry["family_index"] = family;
    entry["per_family_instance_index"] = 0;
    entry["run_name"] = id;
    entry["run_type"] = run_type;
    entry["repetitions"] = repetitions;
    return entry;
}

void add_time(Json& entry, std::size_t iterations, double time) {
    entry["iterations"] = iterations;
    entry["real_time"] = time;
    entry["cpu_time"] = time;
    entry["time_unit"] = time_unit;
}

void add_repetitions(Json& benchmarks, const std::string& id, std::size_t family, const std::vector<double>& times,
                     std::size_t draws, const Counters& counters) {
    for (std::size_t index = 0; index < times.size(); ++index) {
        Json entry = entry_of(id, family, "", "iteration", times.size());
        entry["repetition_index"] = index;
        entry["threads"] = 1;
        add_time(entry, draws, times[index]);
        for (const auto& [name, value] : counters) {
            entry[name] = value;
        }
        benchmarks.push_back(std::move(entry));
    }
}

/// Counters are the same in every round: their mean and median are they, their spread is 0.
void add_aggregates(Json& benchmarks, const std::string& id, std::size_t family, const std::vector<double>& times,
                    const Counters& counters) {
    const double size = static_cast<double>(times.size());
    const double mean = std::accumulate(times.begin(), times.end(), 0.0) / size;
    double squares = 0;
    for (const double time : times) {
        squares += (time - mean) * (time - mean);
    }
    const double deviation = std::sqrt(squares / (size - 1));
    struct Aggregate {
        const char* name;
        const char* unit;
        double time;
        bool of_spread;
    };
    for (const Aggregate& aggregate :
         {Aggregate{"mean", "time", mean, false}, Aggregate{"median", "time", median(times), false},
          Aggregate{"stddev", "time", deviation, true},
          Aggregate{"cv", "percentage", mean > 0 ? deviation / mean : 0, true}}) {
        Json entry = entry_of(id, family, std::string("_") + aggregate.name, "aggregate", times.size());
        entry["threads"] = 1;
        entry["aggregate_name"] = aggregate.name;
        entry["aggregate_unit"] = aggregate.unit;
        add_time(entry, times.size(), aggregate.time);
        for (const auto& [name, value] : counters) {
            entry[name] = aggregate.of_spread ? 0.0 : value;
        }
        benchmarks.push_back(std::move(entry));
    }
}

/// The entries of one cell.
Json benchmarks_of(const CellResult& cell, std::size_t family, const RoundMedians& rounds) {
    const PassTiming& draw = cell.time.at(draw_pass);
    const auto measured = rounds.find(cell.cell);
    std::vector<double> times = measured != rounds.end() ? measured->second : std::vector<double>{draw.median_ms};
    for (double& time : times) {
        time *= ns_per_ms;
    }
    const std::size_t samples = std::max<std::size_t>(1, draw.n / times.size());
    const Counters counters = benchmark_counters(cell);
    Json benchmarks = Json::array();
    add_repetitions(benchmarks, cell.cell, family, times, samples * static_cast<std::size_t>(draw.repeats), counters);
    if (times.size() > 1) add_aggregates(benchmarks, cell.cell, family, times, counters);
    return benchmarks;
}

std::string dump_indented(const Json& json) {
    constexpr int indent = 2;
    return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

/// The elements of an array, as they stand in the document.
std::string element_lines(const Json& array) {
    const std::string text = dump_indented(Json{{"array", array}});
    const std::size_t begin = text.find('\n', text.find('[')) + 1;
    return text.substr(begin, text.rfind("\n  ]") - begin);
}

}  // namespace

std::string format_google_benchmark(const Run& run, const RoundMedians& rounds) {
    std::vector<const CellResult*> cells;
    for (const CellResult& cell : run.cells) {
        if (cell.status == CellStatus::ok && cell.time.contains(draw_pass)) cells.push_back(&cell);
    }
    // Text by text: as one tree, a hundred thousand cells would take gigabytes.
    std::vector<std::string> texts(cells.size());
    parallel_for(cells.size(), 1, [&](std::size_t family, std::size_t) {
        texts[family] = element_lines(benchmarks_of(*cells[family], family, rounds));
    });
    Json document;
    document["context"] = context_of(run.run);
    document["benchmarks"] = Json::array();
    std::string text = dump_indented(document);
    const std::size_t place = text.rfind(']');
    const std::string end = text.substr(place) + '\n';
    text.resize(place);
    for (std::string& entries : texts) {
        text += (&entries == &texts.front() ? "\n" : ",\n") + entries;
        entries = std::string();
    }
    text += (texts.empty() ? "" : "\n  ") + end;
    return text;
}

}  // namespace reliefbench
