#include "technique/map_cache.hpp"

#include "core/error.hpp"
#include "core/file.hpp"
#include "core/hash.hpp"
#include "core/json.hpp"
#include "core/log.hpp"

#include <algorithm>
#include <cstdlib>
#include <span>
#include <string_view>
#include <system_error>

namespace reliefbench {

namespace {

namespace fs = std::filesystem;

constexpr int format_version = 1;
constexpr const char* extension = ".maps";

fs::path file_of(const fs::path& folder, const std::string& key) {
    return folder / (key + extension);
}

/// Splits off what stands before the first line's end.
std::string_view take_line(std::string_view& text) {
    const std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    return line;
}

KeptMaps parse(std::string_view text, const std::string& file) {
    const std::string_view hash = take_line(text);
    if (hash != content_hash(text)) fail("{}: its content is not what was written", file);
    const Json json = parse_json(take_line(text), file);
    const JsonView header(json, file);
    header.require_only({"format", "pass_ms", "level_bytes"});
    header.at("format").integer(format_version, format_version);
    KeptMaps maps;
    for (const auto& [pass, samples] : header.at("pass_ms").members()) {
        for (const JsonView& sample : samples.items())
            maps.pass_ms[pass].push_back(sample.number(0));
    }
    for (const JsonView& item : header.at("level_bytes").items()) {
        const auto size = static_cast<std::size_t>(item.integer(0, static_cast<std::int64_t>(text.size())));
        const auto bytes = std::as_bytes(std::span(text.substr(0, size)));
        maps.levels.emplace_back(bytes.begin(), bytes.end());
        text.remove_prefix(size);
    }
    return maps;
}

std::string to_text(const KeptMaps& maps) {
    Json header;
    header["format"] = format_version;
    header["pass_ms"] = maps.pass_ms;
    header["level_bytes"] = Json::array();
    for (const std::vector<std::byte>& level : maps.levels)
        header["level_bytes"].push_back(level.size());
    std::string text = header.dump() + '\n';
    for (const std::vector<std::byte>& level : maps.levels)
        text.append(reinterpret_cast<const char*>(level.data()), level.size());
    return content_hash(text) + '\n' + text;
}

/// Removes files, those used longest ago first, until the rest hold at most `max_bytes`.
void make_room(const fs::path& folder, std::uint64_t max_bytes) {
    struct Kept {
        fs::file_time_type used;
        std::uint64_t bytes;
        fs::path path;
    };
    std::vector<Kept> files;
    std::uint64_t total = 0;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
        if (entry.path().extension() != extension) continue;
        files.push_back({entry.last_write_time(), entry.file_size(), entry.path()});
        total += files.back().bytes;
    }
    std::ranges::sort(files, {}, &Kept::used);
    for (auto file = files.begin(); file != files.end() && total > max_bytes; ++file) {
        fs::remove(file->path);
        total -= file->bytes;
    }
}

}  // namespace

fs::path map_cache_folder() {
    const auto variable = [](const char* name) -> fs::path {
        const char* value = std::getenv(name);
        return value == nullptr ? "" : value;
    };
    if (const fs::path own = variable("RELIEFBENCH_CACHE_DIR"); !own.empty()) return own;
    if (const fs::path caches = variable("XDG_CACHE_HOME"); !caches.empty()) return caches / "reliefbench";
    const fs::path home = variable("HOME");
    return home.empty() ? fs::path() : home / ".cache" / "reliefbench";
}

std::optional<KeptMaps> read_kept_maps(const fs::path& folder, const std::string& key) {
    const fs::path file = file_of(folder, key);
    std::error_code ignored;
    if (!fs::exists(file, ignored)) return std::nullopt;
    try {
        KeptMaps maps = parse(read_text_file(file), file.string());
        fs::last_write_time(file, fs::file_time_type::clock::now(), ignored);
        return maps;
    } catch (const Error& error) {
        log_warning("kept maps cannot be used and are made anew: {}", error.what());
        return std::nullopt;
    }
}

void write_kept_maps(const fs::path& folder, const std::string& key, const KeptMaps& maps, std::uint64_t max_bytes) {
    try {
        fs::create_directories(folder);
        write_text_file(file_of(folder, key), to_text(maps));
        make_room(folder, max_bytes);
    } catch (const std::exception& error) {
        log_warning("maps cannot be kept in {}: {}; name another folder with RELIEFBENCH_CACHE_DIR", folder.string(),
                    error.what());
    }
}

}  // namespace reliefbench
