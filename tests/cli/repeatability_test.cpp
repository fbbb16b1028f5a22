#include "command_line.hpp"

#include <gmock/gmock.h>

#include <filesystem>

namespace reliefbench {
namespace {

/// Marches, maps made by compute passes and by a sliced one, tessellation, shadows, motion, pictures.
Json varied_configuration() {
    return Json::parse(R"({
        "name": "varied",
        "techniques": ["pom", "qdm", "max_mip", "distance_map", "tessellation"],
        "axes": { "heightmap": "rock", "heightmap_size": 32, "view_angle": 65, "resolution": 48,
                  "self_shadow": ["off", "soft"] },
        "seed": 11,
        "images": true,
        "motion": { "frames": 2, "degrees": 0.5 },
        "sampling": { "rule": "fixed", "rounds": 2, "samples_per_visit": 1, "warm_up": 0, "minimum_pass_ms": 0 }
    })");
}

std::map<std::string, std::string> pictures(const std::filesystem::path& run) {
    std::map<std::string, std::string> bytes;
    for (const auto& entry : std::filesystem::directory_iterator(run / "images"))
        bytes[entry.path().filename().string()] = read_file(entry.path());
    return bytes;
}

/// What is no time, by cell.
std::map<std::string, Json> figures(const std::filesystem::path& run) {
    std::map<std::string, Json> by_cell;
    for (const Json& cell : read_lines(run / "cells.jsonl")) {
        Json& kept = by_cell[cell.at("cell").get<std::string>()];
        for (const char* key : {"status", "reason", "work", "pipeline", "error", "image", "motion"})
            kept[key] = cell.at(key);
        kept["prepare_bytes"] = cell.at("prepare").at("bytes");
    }
    return by_cell;
}

class Repeatability : public CommandLine {};

TEST_F(Repeatability, ErrorsTapsAndPicturesAreTheSameFromRunToRun) {
    const std::string configuration = write_configuration("varied.json", varied_configuration());
    for (const char* run : {"first", "second"}) {
        const Outcome outcome = reliefbench({"run", configuration, "-o", path(run)});
        ASSERT_EQ(outcome.code, 0) << outcome.err;
    }
    const std::map<std::string, Json> cells = figures(path("first"));
    ASSERT_EQ(cells.size(), 10u);
    EXPECT_EQ(cells, figures(path("second")));
    const std::map<std::string, std::string> images = pictures(path("first"));
    EXPECT_GT(images.size(), 40u);
    EXPECT_TRUE(images == pictures(path("second"))) << "a picture differs";
}

}  // namespace
}  // namespace reliefbench
