#include "technique/map_cache.hpp"

#include "core/cache_folder.hpp"
#include "core/error.hpp"
#include "core/json.hpp"

#include <span>
#include <string_view>

namespace reliefbench {

namespace {

constexpr int format_version = 1;

CachedFiles cached_maps(const std::filesystem::path& folder, std::uint64_t max_bytes = 0) {
    return {.folder = folder, .extension = ".maps", .content = "derived maps", .max_bytes = max_bytes};
}

KeptMaps parse(std::string_view text) {
    const Json json = parse_json(take_line(text), "derived maps");
    const JsonView header(json, "derived maps");
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
    return text;
}

}  // namespace

std::optional<KeptMaps> read_kept_maps(const std::filesystem::path& folder, const std::string& key) {
    std::optional<KeptMaps> maps;
    cached_maps(folder).read(key, [&maps](std::string_view text) { maps = parse(text); });
    return maps;
}

void write_kept_maps(const std::filesystem::path& folder, const std::string& key, const KeptMaps& maps,
                     std::uint64_t max_bytes) {
    cached_maps(folder, max_bytes).write(key, to_text(maps));
}

}  // namespace reliefbench
