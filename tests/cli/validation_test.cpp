#include "command_line.hpp"

#include <set>

namespace reliefbench {
namespace {

TEST_F(CommandLine, SmokeWithEveryTechniqueSatisfiesTheValidationLayerAndItsSynchronisationChecks) {
    const std::filesystem::path sources = RELIEFBENCH_SOURCE_DIR;
    std::string techniques;
    std::set<std::string> ids;
    for (const auto& entry : std::filesystem::directory_iterator(sources / "techniques")) {
        if (!std::filesystem::exists(entry.path() / "technique.json")) continue;
        ids.insert(entry.path().filename().string());
        techniques += (techniques.empty() ? "" : ",") + entry.path().filename().string();
    }
    const Outcome outcome = reliefbench({"run", (sources / "configs/smoke.json").string(), "-a",
                                         "technique=" + techniques, "--validate", "-o", path("run")});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    std::set<std::string> measured;
    for (const Json& cell : read_lines(path("run/cells.jsonl")))
        measured.insert(cell.at("technique").get<std::string>());
    EXPECT_EQ(measured, ids);
}

}  // namespace
}  // namespace reliefbench
