#include "store/read_samples.hpp"

#include "core/error.hpp"
#include "core/statistics.hpp"
#include "store/parsed_lines.hpp"

#include <cerrno>
#include <cstring>
#include <fstream>

namespace reliefbench {

namespace {

/// Marks a line of a round that was measured while the device throttled.
constexpr const char* throttled_key = "throttled";

RawSamples parse_samples(const JsonView& view) {
    RawSamples samples;
    samples.throttled = view.has(throttled_key) && view.at(throttled_key).boolean();
    if (samples.throttled) return samples;
    samples.cell = view.at("cell").string();
    samples.pass = view.at("pass").string();
    samples.round = static_cast<int>(view.at("round").integer(0, std::numeric_limits<int>::max()));
    samples.order = static_cast<int>(view.at("order").integer(0, std::numeric_limits<int>::max()));
    samples.repeats = static_cast<int>(view.at("repeats").integer(1, std::numeric_limits<int>::max()));
    for (const JsonView& value : view.at("ms").items()) {
        if (!value.json().is_null()) samples.ms.push_back(value.number());
    }
    return samples;
}

}  // namespace

void read_samples(const std::filesystem::path& folder, const std::function<void(const RawSamples&)>& on_samples) {
    const std::filesystem::path path = folder / samples_file;
    std::ifstream file(path, std::ios::binary);
    if (!file) fail("cannot read {}: {}", path.string(), std::strerror(errno));
    const auto parse = [](std::string_view line, const std::string& where) {
        const Json json = parse_json(line, where);
        return parse_samples(JsonView(json, where));
    };
    for_each_parsed_line(file, path.string(), parse, [&](const RawSamples& samples, const std::string&) {
        if (!samples.throttled) on_samples(samples);
    });
}

RoundMedians read_round_medians(const std::filesystem::path& folder, const std::string& pass) {
    // Visits of one cell in one round stand in one line, but nothing forbids several.
    std::map<std::string, std::map<int, std::vector<double>>> rounds;
    read_samples(folder, [&](const RawSamples& samples) {
        if (samples.pass != pass) return;
        std::vector<double>& ms = rounds[samples.cell][samples.round];
        ms.insert(ms.end(), samples.ms.begin(), samples.ms.end());
    });
    RoundMedians medians;
    for (const auto& [cell, by_round] : rounds) {
        for (const auto& [round, ms] : by_round) {
            if (!ms.empty()) medians[cell].push_back(median(ms));
        }
    }
    return medians;
}

}  // namespace reliefbench
