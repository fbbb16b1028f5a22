#include "store/noise_record.hpp"

#include "core/error.hpp"
#include "core/file.hpp"
#include "core/hash.hpp"

#include <cstdlib>
#include <limits>

namespace reliefbench {

namespace {

constexpr int format_version = 1;

Json to_json(const MachineKey& machine) {
    Json json;
    json["device"] = machine.device;
    json["driver"] = machine.driver;
    json["driver_version"] = machine.driver_version;
    json["cpu"] = machine.cpu;
    return json;
}

MachineKey read_machine(const JsonView& view) {
    view.require_only({"device", "driver", "driver_version", "cpu"});
    return {view.at("device").string(), view.at("driver").string(), view.at("driver_version").string(),
            view.at("cpu").string()};
}

Json to_json(const NoiseRecord& record) {
    Json json;
    json["format"] = format_version;
    json["machine"] = to_json(record.machine);
    json["time"] = record.time;
    json["configuration"] = record.configuration;
    json["between_runs"]["log_sd"] = record.between_runs.log_sd;
    json["between_runs"]["degrees_of_freedom"] = record.between_runs.degrees_of_freedom;
    json["between_runs"]["source"] = record.between_runs.source;
    json["cells"] = Json::array();
    for (const NoiseRecord::Cell& cell : record.cells) {
        Json entry;
        entry["cell"] = cell.cell;
        entry["log_median_ms"] = cell.log_median_ms;
        entry["visible_paired"] = cell.visible_paired;
        entry["rounds"] = cell.rounds;
        json["cells"].push_back(std::move(entry));
    }
    return json;
}

/// What was not finite was written as null: nothing could be seen.
double visible_of(const JsonView& view) {
    return view.json().is_null() ? std::numeric_limits<double>::infinity() : view.number(0);
}

NoiseRecord parse_noise_record(const Json& json, const std::string& file) {
    const JsonView view(json, file);
    view.require_only({"format", "machine", "time", "configuration", "between_runs", "cells"});
    view.at("format").integer(format_version, format_version);
    NoiseRecord record;
    record.machine = read_machine(view.at("machine"));
    record.time = view.at("time").string();
    record.configuration = view.at("configuration").string();
    const JsonView noise = view.at("between_runs");
    noise.require_only({"log_sd", "degrees_of_freedom", "source"});
    record.between_runs.log_sd = noise.at("log_sd").number(0);
    record.between_runs.degrees_of_freedom = noise.at("degrees_of_freedom").number(1);
    record.between_runs.source = noise.at("source").string();
    for (const JsonView& entry : view.at("cells").items()) {
        entry.require_only({"cell", "log_median_ms", "visible_paired", "rounds"});
        NoiseRecord::Cell cell;
        cell.cell = entry.at("cell").string();
        for (const JsonView& value : entry.at("log_median_ms").items()) {
            cell.log_median_ms.push_back(value.number());
        }
        cell.visible_paired = visible_of(entry.at("visible_paired"));
        cell.rounds = static_cast<std::size_t>(entry.at("rounds").integer(0));
        record.cells.push_back(std::move(cell));
    }
    return record;
}

std::filesystem::path file_of(const std::filesystem::path& state_folder, const MachineKey& machine) {
    return state_folder / ("noise-" + content_hash(to_json(machine).dump()) + ".json");
}

/// Empty when the variable is not set or says nothing.
std::string environment_variable(const char* name) {
    const char* value = std::getenv(name);
    return value == nullptr ? "" : value;
}

}  // namespace

MachineKey machine_of(const Json& run) {
    const JsonView view(run, "run.json");
    const JsonView device = view.at("device");
    MachineKey machine;
    machine.device = device.at("name").string();
    machine.driver = device.at("driver").string();
    machine.driver_version = device.at("driver_version").string();
    const JsonView cpu = view.at("environment").at("cpu");
    if (!cpu.json().is_null()) machine.cpu = cpu.string();
    return machine;
}

std::filesystem::path state_folder() {
    if (const std::string own = environment_variable("RELIEFBENCH_STATE_DIR"); !own.empty()) return own;
    if (const std::string state = environment_variable("XDG_STATE_HOME"); !state.empty()) {
        return std::filesystem::path(state) / "reliefbench";
    }
    const std::string home = environment_variable("HOME");
    if (home.empty()) {
        fail("there is no folder to keep the machine's noise in: set HOME, XDG_STATE_HOME or RELIEFBENCH_STATE_DIR");
    }
    return std::filesystem::path(home) / ".local" / "state" / "reliefbench";
}

std::optional<NoiseRecord> read_noise_record(const std::filesystem::path& state_folder, const MachineKey& machine) {
    const std::filesystem::path file = file_of(state_folder, machine);
    std::error_code error;
    if (!std::filesystem::exists(file, error)) return std::nullopt;
    NoiseRecord record;
    try {
        record = parse_noise_record(read_json_file(file), file.string());
    } catch (const Error& failure) {
        fail("{}; remove the file, or replace it by running `reliefbench selfcheck`", failure.what());
    }
    if (!(record.machine == machine)) {
        fail("{} is of another machine ({}); remove it", file.string(), record.machine.device);
    }
    return record;
}

void write_noise_record(const std::filesystem::path& state_folder, const NoiseRecord& record) {
    std::error_code error;
    std::filesystem::create_directories(state_folder, error);
    if (error) {
        fail("cannot create the folder {}: {}; name another with RELIEFBENCH_STATE_DIR", state_folder.string(),
             error.message());
    }
    constexpr int indent = 2;
    write_text_file(file_of(state_folder, record.machine),
                    to_json(record).dump(indent, ' ', false, Json::error_handler_t::replace) + '\n');
}

}  // namespace reliefbench
