#include "store/run_folder.hpp"

#include "core/counted.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "core/hash.hpp"
#include "store/crashes.hpp"
#include "store/parsed_lines.hpp"
#include "store/stored_format.hpp"

#include <cctype>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <string_view>
#include <unordered_set>

namespace reliefbench {

namespace {

constexpr const char* run_file = "run.json";
constexpr const char* cells_file = "cells.jsonl";
constexpr const char* rounds_file = "rounds.jsonl";
constexpr const char* summary_file = "summary.json";
constexpr const char* images_folder = "images";

/// File systems take names of 255 bytes: the rest is for the suffix.
constexpr std::size_t longest_image_name = 180;
constexpr std::size_t hash_digits_in_name = 8;

/// False, too, where the folder may not be looked into; making files in it tells then.
bool is_there(const std::filesystem::path& path) {
    std::error_code ignored;
    return std::filesystem::exists(path, ignored);
}

void make_folder(const std::filesystem::path& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) {
        fail("cannot create the folder {}: {}; choose another folder", folder.string(), error.message());
    }
}

/// One line, whatever bytes the strings hold.
std::string dump_line(const Json& json) {
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string dump_document(const Json& json) {
    constexpr int indent = 2;
    return json.dump(indent, ' ', false, Json::error_handler_t::replace) + '\n';
}

/// "pom+max_steps=16@heightmap=bricks+view_angle=60": spaces as +, the bar as @. An id that this would not keep apart
/// from others ends in its hash.
std::string image_name(const std::string& cell) {
    std::string name;
    bool distinct = cell.size() <= longest_image_name;
    for (std::size_t at = 0; at < cell.size(); ++at) {
        const char character = cell[at];
        if (cell.compare(at, 3, " | ") == 0) {
            name += '@';
            at += 2;
        } else if (character == ' ') {
            name += '+';
        } else if (std::isalnum(static_cast<unsigned char>(character)) != 0 ||
                   std::string_view("._-=,").find(character) != std::string_view::npos) {
            name += character;
        } else {
            name += '_';
            distinct = false;
        }
    }
    if (distinct) return name;
    return name.substr(0, longest_image_name) + "-" + content_hash(cell).substr(0, hash_digits_in_name);
}

/// More shards than a sweep may have cells cannot be.
constexpr std::int64_t max_shards = 1000000;

/// What readers of stored runs look up without asking for its type. Records of other versions lack some.
void check_run_record(const JsonView& record) {
    if (!record.json().is_object()) record.fail_expected("an object");
    format_of(record);
    if (record.has("environment") && record.at("environment").has("time")) {
        record.at("environment").at("time").string();
    }
    if (record.has("techniques")) {
        for (const auto& [id, hash] : record.at("techniques").members())
            hash.string();
    }
    for (const char* list : {"height_maps", "bases"}) {
        if (!record.has(list)) continue;
        for (const JsonView& input : record.at(list).items()) {
            for (const char* key : {"name", "format", "base_fit"}) {
                if (input.has(key)) input.at(key).string();
            }
        }
    }
    if (record.has("shard")) record.at("shard").at("count").integer(1, max_shards);
}

/// Pictures only: a link could lead anywhere, and a folder into itself.
void copy_images(const std::filesystem::path& from, const std::filesystem::path& to) {
    for (const std::filesystem::directory_entry& entry : std::filesystem::directory_iterator(from)) {
        if (entry.symlink_status().type() != std::filesystem::file_type::regular) continue;
        std::filesystem::copy_file(entry.path(), to / entry.path().filename(),
                                   std::filesystem::copy_options::skip_existing);
    }
}

/// Some megabytes at a time. A last line that was cut short is left out.
void append_whole_lines(const std::filesystem::path& from, LineFile& to) {
    constexpr std::size_t bytes_at_a_time = std::size_t{8} << 20;
    std::ifstream file(from, std::ios::binary);
    std::string text;
    do {
        const std::size_t rest = text.size();
        text.resize(rest + bytes_at_a_time);
        file.read(text.data() + rest, bytes_at_a_time);
        text.resize(rest + static_cast<std::size_t>(file.gcount()));
        const std::size_t whole = text.rfind('\n') + 1;  // npos + 1 == 0
        to.append_lines(std::string_view(text).substr(0, whole));
        text.erase(0, whole);
    } while (file);
}

[[noreturn]] void fail_without_run(const std::filesystem::path& folder) {
    if (!is_there(folder)) fail("{} holds no run: there is no such folder", folder.string());
    std::error_code ignored;
    if (std::filesystem::is_directory(folder, ignored)) {
        fail("{} holds no run: there is no {} in it", folder.string(), run_file);
    }
    const std::filesystem::path parent = folder.has_parent_path() ? folder.parent_path() : ".";
    if (holds_run(parent)) fail("{} is a file; a run is named by its folder, {}", folder.string(), parent.string());
    fail("{} is a file; a run is a folder with a {} in it", folder.string(), run_file);
}

}  // namespace

std::filesystem::path image_path(const std::filesystem::path& folder, const std::string& cell,
                                 const std::string& suffix) {
    return folder / images_folder / (image_name(cell) + suffix);
}

void refuse_second_run(const std::filesystem::path& folder) {
    for (const char* file : {run_file, cells_file, samples_file, rounds_file, summary_file}) {
        if (is_there(folder / file)) {
            fail("{} already holds a run ({}): choose another folder, or remove it first", folder.string(), file);
        }
    }
}

RunWriter::RunWriter(const std::filesystem::path& folder, const Json& run) : folder_(folder) {
    refuse_second_run(folder);
    const bool made_folder = !is_there(folder);
    make_folder(folder);
    try {
        cells_.emplace(folder / cells_file, LineFile::Start::created);
        samples_.emplace(folder / samples_file, LineFile::Start::created);
        rounds_.emplace(folder / rounds_file, LineFile::Start::created);
        write_text_file(folder / run_file, dump_document(run));
    } catch (const Error&) {
        std::error_code ignored;
        if (cells_) std::filesystem::remove(folder / cells_file, ignored);
        if (samples_) std::filesystem::remove(folder / samples_file, ignored);
        if (rounds_) std::filesystem::remove(folder / rounds_file, ignored);
        if (made_folder) std::filesystem::remove(folder, ignored);
        throw;
    }
}

RunWriter::RunWriter(const std::filesystem::path& folder, const Json& run, Continue /*tag*/) : folder_(folder) {
    for (const auto& [name, file] :
         {std::pair(cells_file, &cells_), std::pair(samples_file, &samples_), std::pair(rounds_file, &rounds_)}) {
        file->emplace(folder / name, LineFile::Start::continued);
        if (const std::size_t bytes = (*file)->repaired_bytes(); bytes > 0) {
            repairs_.push_back(
                fmt::format("{}: the last line was cut short after {} and is taken out", name, counted(bytes, "byte")));
        }
    }
    write_text_file(folder / run_file, dump_document(run));
}

void RunWriter::append_cell(const CellResult& result) {
    cells_->append(dump_line(to_json(result)));
}

std::vector<CellResult> RunWriter::take_out_cut_off_cells() {
    std::vector<CellResult> cut_off;
    std::string kept;
    for (CellResult& cell : read_run(folder_).cells) {
        if (cell.stop == StopReason::time) {
            cut_off.push_back(std::move(cell));
        } else {
            kept += dump_line(to_json(cell)) + "\n";
        }
    }
    if (cut_off.empty()) return cut_off;
    // samples.jsonl, which is open, keeps other processes out meanwhile.
    cells_.reset();
    write_text_file(folder_ / cells_file, kept);
    cells_.emplace(folder_ / cells_file, LineFile::Start::continued);
    return cut_off;
}

void RunWriter::append_samples(const RawSamples& samples) {
    Json json;
    json["cell"] = samples.cell;
    json["pass"] = samples.pass;
    json["round"] = samples.round;
    json["order"] = samples.order;
    json["repeats"] = samples.repeats;
    json["ms"] = samples.ms;  // the library writes numbers that are not finite as null
    if (samples.throttled) json["throttled"] = true;
    samples_->append(dump_line(json));
}

void RunWriter::append_round(const RoundRecord& round) {
    const auto or_null = [](const auto& value) { return value ? Json(*value) : Json(nullptr); };
    Json json;
    json["block"] = round.block;
    json["round"] = round.round;
    json["seconds"] = round.seconds;
    json["clock_mhz"] = or_null(round.clock_mhz);
    json["memory_clock_mhz"] = or_null(round.memory_clock_mhz);
    json["temperature_c"] = or_null(round.temperature_c);
    json["throttled"] = or_null(round.throttled);
    rounds_->append(dump_line(json));
}

void RunWriter::append_recorded(const std::filesystem::path& other_run) {
    for (const auto& [name, file] :
         {std::pair(cells_file, &cells_), std::pair(samples_file, &samples_), std::pair(rounds_file, &rounds_)}) {
        append_whole_lines(other_run / name, **file);
    }
    for (const Crash& crash : read_crash_lines(other_run))
        append_crash(folder_, crash);
    const std::filesystem::path images = other_run / images_folder;
    if (!is_there(images)) return;
    make_folder(folder_ / images_folder);
    try {
        copy_images(images, folder_ / images_folder);
    } catch (const std::filesystem::filesystem_error& error) {
        fail("cannot copy {} into {}: {}", images.string(), folder_.string(), error.code().message());
    }
}

void RunWriter::write_summary(const Json& summary) {
    write_text_file(folder_ / summary_file, dump_document(summary));
}

std::filesystem::path RunWriter::image_path(const std::string& cell, const std::string& suffix) {
    const std::filesystem::path path = reliefbench::image_path(folder_, cell, suffix);
    make_folder(path.parent_path());
    return path;
}

std::optional<Json> read_run_summary(const std::filesystem::path& folder) {
    if (!is_there(folder / summary_file)) return std::nullopt;
    return read_json_file(folder / summary_file);
}

bool holds_run(const std::filesystem::path& folder) {
    return is_there(folder / run_file);
}

void remove_unstarted_run(const std::filesystem::path& folder) {
    if (holds_run(folder)) return;
    for (const char* file : {cells_file, samples_file, rounds_file}) {
        std::error_code error;
        if (std::filesystem::file_size(folder / file, error) == 0 && !error) {
            std::filesystem::remove(folder / file, error);
        }
    }
}

Json read_run_record(const std::filesystem::path& folder) {
    if (!holds_run(folder)) fail_without_run(folder);
    Json record = read_json_file(folder / run_file);
    check_run_record(JsonView(record, (folder / run_file).string()));
    return record;
}

std::vector<CellResult> parse_cells(std::istream& lines, const std::string& file,
                                    const std::shared_ptr<const FigureList>& figures) {
    std::vector<CellResult> cells;
    std::unordered_set<std::string> ids;
    const auto parse = [&](std::string_view line, const std::string& where) {
        return parse_cell_result(parse_json(line, where), where, figures);
    };
    for_each_parsed_line(lines, file, parse, [&](CellResult&& cell, const std::string& where) {
        if (!ids.insert(cell.cell).second) {
            fail("{}: the cell '{}' stands here for the second time; remove one", where, cell.cell);
        }
        cells.push_back(std::move(cell));
    });
    return cells;
}

Run read_run(const std::filesystem::path& folder) {
    Run run;
    run.run = read_run_record(folder);
    run.figures = figures_of_record(run.run, (folder / run_file).string());
    const std::filesystem::path path = folder / cells_file;
    std::ifstream file(path, std::ios::binary);
    if (!file) fail("cannot read {}: {}", path.string(), std::strerror(errno));
    run.cells = parse_cells(file, path.string(), run.figures);
    return run;
}

std::vector<CellResult> read_first_cells(const std::filesystem::path& folder) {
    std::vector<CellResult> cells;
    try {
        const Json record = read_run_record(folder);
        const auto figures = figures_of_record(record, (folder / run_file).string());
        std::ifstream file(folder / cells_file, std::ios::binary);
        for (std::string line; std::getline(file, line);)
            cells.push_back(parse_cell_result(parse_json(line, cells_file), cells_file, figures));
    } catch (const Error&) {
        // What was read before it counts.
    }
    return cells;
}

}  // namespace reliefbench
