// What `run` skips or calls failed is so in every command that draws cells, with the same words.

#include "command_line.hpp"

#include "scene/hit.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <fstream>

namespace reliefbench {
namespace {

using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool has_own_allocator = true;
#else
constexpr bool has_own_allocator = false;
#endif

constexpr int verify_resolution = 96;

/// Shell words that put the layer of tests/faulty_layer in front of the driver.
const std::string with_faulty_layer = std::string("VK_ADD_LAYER_PATH=") + RELIEFBENCH_FAULTY_LAYER_FOLDER +
                                      " VK_INSTANCE_LAYERS=VK_LAYER_RELIEFBENCH_faulty ";

class OneLaboratory : public CommandLine {
protected:
    void write_technique(const std::string& trace, const std::string& more = "",
                         const std::string& parameters = "") const {
        std::filesystem::create_directories(path("techniques/mine"));
        write("techniques/mine/technique.json", R"({"title": "Mine", "kind": "march", "citation": "none",
            "shape": "quad", "promises": [], "parameters": [)" +
                                                    parameters + "]" + more + "}");
        write("techniques/mine/trace.glsl", trace);
    }

    /// A copy of a shipped technique, in which a parameter has another default.
    void copy_with_default(const std::string& shipped, const std::string& name, int value) const {
        const std::filesystem::path manifest = copy_technique(shipped, "mine") / "technique.json";
        Json json = Json::parse(read_file(manifest));
        for (Json& parameter : json.at("parameters")) {
            if (parameter.at("name") == name) parameter["default"] = value;
        }
        std::ofstream(manifest) << json.dump();
    }

    Json configuration() const {
        Json json = tiny_configuration();
        json["techniques"] = {"mine"};
        json["axes"] = {{"heightmap", "rock"},      {"heightmap_size", 32}, {"view_angle", 75},
                        {"projection", "parallel"}, {"boundary", "repeat"}, {"resolution", 32}};
        return json;
    }

    /// How one command ends the only cell.
    struct Ending {
        std::string command;
        int code = -1;
        /// "failed: ...", in what the command says.
        std::string text;
    };

    /// `before`: shell words.
    Ending run(const Json& json, const std::string& before) const {
        const Outcome outcome =
            command(filtered({"run", write_configuration("mine.json", json), "-o", path("run")}), before);
        const std::vector<Json> cells = read_lines(path("run/cells.jsonl"));
        if (cells.size() != 1) return {"run", outcome.code, outcome.err};
        return {"run", outcome.code,
                cells[0].at("status").get<std::string>() + ": " + cells[0].at("reason").get<std::string>()};
    }

    Ending ab(const std::string& before) const {
        const Outcome outcome = command(
            filtered({"ab", path("mine.json"), "--baseline", path("techniques"), "--budget", "1s", "--format", "json"}),
            before);
        const Json json = Json::parse(outcome.out, nullptr, false);
        if (json.is_discarded() || json.at("uncompared").size() != 1) return {"ab", outcome.code, outcome.err};
        return {"ab", outcome.code, json.at("uncompared")[0].at("reason")};
    }

    Ending bench(const std::string& before) const {
        const Outcome outcome =
            command(filtered({"bench", "--config", path("mine.json"), "--benchmark_format=json"}), before);
        const Json json = Json::parse(outcome.out, nullptr, false);
        if (json.is_discarded() || json.at("benchmarks").size() != 1) return {"bench", outcome.code, outcome.err};
        return {"bench", outcome.code, json.at("benchmarks")[0].value("error_message", outcome.err)};
    }

    /// Its picture, or the sheet, is mine.png.
    Ending render(const Json& json, bool as_sheet, const std::string& before) const {
        std::vector<std::string> arguments{"render", "--technique", "mine", "-o", path("mine.png")};
        for (const auto& [axis, value] : json.at("axes").items()) {
            const std::string text = value.is_string() ? value.get<std::string>() : value.dump();
            arguments.insert(arguments.end(), {"-a", axis + "=" + text});
        }
        if (json.contains("preparation"))
            arguments.insert(arguments.end(), {"--preparation-limit", json.at("preparation").at("limit_s").dump()});
        if (as_sheet) arguments.push_back("--contact-sheet");
        std::filesystem::remove(path("mine.png"));
        const Outcome outcome = command(arguments, before);
        std::string text = outcome.err;
        // "mine.png: 1 row" ends what is said of a sheet.
        if (as_sheet) text.erase(std::min(text.size(), text.rfind(path("mine.png"))));
        for (const std::string status : {"failed: ", "skipped: "}) {
            const std::size_t at = text.find(status + "mine");
            if (at == std::string::npos) continue;
            // "failed: <cell>: <reason>".
            const std::size_t reason = text.find(": ", at + status.size()) + 2;
            text = status + text.substr(reason, text.rfind('\n') - reason);
            break;
        }
        return {as_sheet ? "render --contact-sheet" : "render", outcome.code, text};
    }

    Outcome verify(const Json& json, const std::string& before) const {
        std::vector<std::string> arguments{"verify", "--technique", "mine"};
        if (json.contains("preparation"))
            arguments.insert(arguments.end(), {"--preparation-limit", json.at("preparation").at("limit_s").dump()});
        return command(arguments, before);
    }

    /// Five commands that draw the same cell, and then verify, whose cells are its own.
    void expect_same_ending(const std::string& what, const Json& json, const std::string& status,
                            const std::string& words, bool is_drawn, const std::string& before = {}) const;

    /// Of run, ab and bench.
    std::vector<std::string> filter_;

private:
    std::vector<std::string> filtered(std::vector<std::string> arguments) const {
        arguments.insert(arguments.end(), filter_.begin(), filter_.end());
        return arguments;
    }

    Outcome command(std::vector<std::string> arguments, const std::string& before) const {
        arguments.insert(arguments.end(), {"--techniques", path("techniques")});
        return reliefbench(arguments, before);
    }
};

/// But for figures of times, which never repeat.
std::string without_times(const std::string& reason) {
    const std::size_t begin = reason.find("would take");
    const std::size_t end = reason.find("more than the limit");
    return begin == std::string::npos || end == std::string::npos ? reason
                                                                  : reason.substr(0, begin) + reason.substr(end);
}

void OneLaboratory::expect_same_ending(const std::string& what, const Json& json, const std::string& status,
                                       const std::string& words, bool is_drawn, const std::string& before) const {
    const bool failed = status == "failed";
    const Ending of_run = run(json, before);
    EXPECT_EQ(of_run.code, failed ? 4 : 0) << what << ": " << of_run.text;
    EXPECT_TRUE(of_run.text.starts_with(status + ": ")) << what << ": " << of_run.text;
    EXPECT_THAT(of_run.text, HasSubstr(words)) << what;
    const std::string expected = without_times(of_run.text);

    const auto expect = [&](const Ending& ending, int code) {
        EXPECT_EQ(ending.code, code) << what << ", " << ending.command << ": " << ending.text;
        EXPECT_THAT(without_times(ending.text), EndsWith(expected)) << what << ", " << ending.command;
    };
    expect(ab(before), 3);  // nothing is compared
    expect(bench(before), failed ? 4 : 0);
    expect(render(json, false, before), failed ? 4 : 2);
    EXPECT_EQ(std::filesystem::exists(path("mine.png")), is_drawn) << what;
    expect(render(json, true, before), failed ? 4 : 0);
    EXPECT_TRUE(std::filesystem::exists(path("mine.png"))) << what;
    std::filesystem::remove_all(path("run"));
}

/// A technique whose cells end before they are timed.
struct BadTechnique {
    std::string what;
    std::string trace;
    std::string words;
    /// In spite of it there is a picture.
    bool is_drawn = false;
};

TEST_F(OneLaboratory, ABadTechniqueEndsItsCellsInTheSameWayEverywhere) {
    const std::vector<BadTechnique> cases = {
        {"out of range", "Trace trace(ReliefRay ray) { return hit_on_ray(-0.5 - tap_height(ray.uv), 1); }",
         "answered out of range, the worst s = -", true},
        {"capped", "Trace trace(ReliefRay ray) { return unconverged(hit_on_ray(1.0 - tap_height(ray.uv), 1)); }",
         "left their loop at the iteration cap, unconverged", true},
        {"no GLSL", "Trace trace(ReliefRay ray) { return nothing; }", "does not compile"},
    };
    for (const BadTechnique& bad : cases) {
        write_technique(bad.trace);
        expect_same_ending(bad.what, configuration(), "failed", bad.words, bad.is_drawn);
        const Outcome verified = verify(configuration(), {});
        EXPECT_EQ(verified.code, 4) << bad.what << ": " << verified.out;
        EXPECT_THAT(verified.out, AllOf(HasSubstr(bad.words), Not(HasSubstr("ok    mine: timed and probed agree"))))
            << bad.what;
    }
}

TEST_F(OneLaboratory, LoopsThatTheDeviceEndedFailTheCellEverywhere) {
    write_technique(
        "Trace trace(ReliefRay ray) { int n = 0; while (ray.uv.x < 0.04 && tap_height(ray.uv) > -1.0) n += 1; "
        "return hit_on_ray(1.0 - tap_height(ray.uv), n); }");
    const Json json = configuration();
    if (run(json, {}).text.find("the device ended the loops") == std::string::npos)
        GTEST_SKIP() << "the device ends no loops";
    std::filesystem::remove_all(path("run"));
    expect_same_ending("endless", json, "failed", "the device ended the loops of", true);
    const Outcome verified = verify(json, {});
    EXPECT_EQ(verified.code, 4);
    EXPECT_THAT(verified.out, HasSubstr("FAIL  mine: timed and probed agree"));
    EXPECT_THAT(verified.out, HasSubstr("the device ended the loops of"));
}

TEST_F(OneLaboratory, AbAndTheOthersRefuseTheQuadtreeThatIsCappedAtOneStep) {
    copy_with_default("qdm", "max_steps", 1);
    expect_same_ending("qdm", configuration(), "failed", "raise max_steps (now 1, at most 65536)", true);
    const Outcome verified = verify(configuration(), {});
    EXPECT_EQ(verified.code, 4);
    EXPECT_THAT(verified.out, HasSubstr("raise max_steps (now 1, at most 65536)"));
}

TEST_F(OneLaboratory, AFeatureThatTheDeviceLacksSkipsTheCellEverywhere) {
    write_technique("Trace trace(ReliefRay ray) { return hit_on_ray(1.0 - tap_height(ray.uv), 1); }",
                    R"(, "features": ["tessellationShader"])");
    const std::string before = with_faulty_layer + "RELIEFBENCH_WITHOUT_TESSELLATION=1";
    expect_same_ending("feature", configuration(), "skipped", "lacks the feature tessellationShader", false, before);
    const Outcome verified = verify(configuration(), before);
    EXPECT_EQ(verified.code, 0);
    EXPECT_THAT(verified.out,
                AllOf(HasSubstr("skip  mine: runs on this device"), HasSubstr("lacks the feature tessellationShader")));
}

TEST_F(OneLaboratory, AnisotropyThatTheDeviceLacksSkipsTheCellEverywhere) {
    write_technique("Trace trace(ReliefRay ray) { return hit_on_ray(1.0 - tap_height(ray.uv), 1); }");
    Json json = configuration();
    json["axes"]["material_filter"] = "anisotropic";
    expect_same_ending("anisotropy", json, "skipped", "lacks the feature samplerAnisotropy", false,
                       with_faulty_layer + "RELIEFBENCH_WITHOUT_ANISOTROPY=1");
}

TEST_F(OneLaboratory, APreparationBeyondItsLimitSkipsTheCellEverywhere) {
    write_technique("Trace trace(ReliefRay ray) { return hit_on_ray(1.0 - tap_height(ray.uv), 1); }",
                    R"(, "maps": [{"name": "made", "format": "r32f"}],
        "passes": [{"name": "search", "shader": "search.glsl", "writes": "made", "sliced": {"iterations": 32768}}])");
    write("techniques/mine/search.glsl", "void prepare(ivec2 texel) { write_map(folded_map() + 1.0); }\n");
    Json json = configuration();
    json["preparation"] = {{"limit_s", 0}};
    // Maps that an earlier test kept would take no time.
    const std::string before = "RELIEFBENCH_CACHE_DIR=" + path("cache");
    expect_same_ending("slow", json, "skipped", "more than the limit of 0 s", false, before);
    const Outcome verified = verify(json, before);
    EXPECT_EQ(verified.code, 0);
    EXPECT_THAT(verified.out, AllOf(HasSubstr("skip  mine: compiles"), HasSubstr("more than the limit of 0 s"),
                                    HasSubstr("0 of 0 checks passed"), HasSubstr("1 skipped")));
}

TEST_F(OneLaboratory, AValueThatTheTechniqueDoesNotTakeSkipsTheCellEverywhere) {
    write_technique("Trace trace(ReliefRay ray) { return hit_on_ray(1.0 - tap_height(ray.uv), steps); }",
                    R"(, "sample_count": "steps")",
                    R"({"name": "steps", "type": "integer", "default": 8, "range": [1, 64], "help": "h"})");
    Json json = configuration();
    // Where no technique took it, it would be an error of the configuration.
    json["techniques"] = {"mine", "steep"};
    json["axes"]["sample_count"] = 128;
    filter_ = {"--filter", "technique=mine"};
    const std::string ending = "skipped: steps cannot be 128: it is an integer from 1 to 64";
    for (const Ending& found : {run(json, {}), ab({}), bench({})}) {
        EXPECT_EQ(found.text, ending) << found.command;
        EXPECT_EQ(found.code, found.command == "ab" ? 3 : 0) << found.command;
    }
    const Outcome sheet =
        reliefbench({"render", "--contact-sheet", "--technique", "mine,steep", "--techniques", path("techniques"), "-a",
                     "sample_count=128", "-a", "resolution=16", "-o", path("sheet.png")});
    EXPECT_EQ(sheet.code, 0) << sheet.err;
    EXPECT_THAT(sheet.err, AllOf(HasSubstr("skipped: mine"), HasSubstr(ending.substr(ending.find("steps")))));
}

TEST_F(OneLaboratory, WhatDoesNotFitIntoMemoryIsSkippedEverywhere) {
    write_technique("Trace trace(ReliefRay ray) { return hit_on_ray(1.0 - tap_height(ray.uv), 1); }");
    Json json = configuration();
    json["axes"]["resolution"] = verify_resolution;
    expect_same_ending("large", json, "skipped", "of memory, and 1 MB is available", false, "RELIEFBENCH_MEMORY_MB=1");
}

TEST_F(OneLaboratory, AnAllocationThatFailsOnTheDeviceFailsTheCellEverywhere) {
    copy_with_default("steep", "max_steps", 13);
    const std::string before = with_faulty_layer + "RELIEFBENCH_REFUSE_MEMORY_AT=13";
    expect_same_ending("device memory", configuration(), "failed", "out of device memory", false, before);
    const Outcome verified = verify(configuration(), before);
    EXPECT_EQ(verified.code, 4);
    EXPECT_THAT(verified.out, AllOf(HasSubstr("FAIL  mine: compiles"), HasSubstr("out of device memory")));
}

TEST_F(OneLaboratory, AnAllocationThatFailsOnTheHostFailsTheCellEverywhere) {
    if (has_own_allocator) GTEST_SKIP() << "a sanitizer's allocator takes the place of any other";
    write_technique("Trace trace(ReliefRay ray) { return hit_on_ray(1.0 - tap_height(ray.uv), 1); }");
    Json json = configuration();
    json["axes"]["resolution"] = verify_resolution;
    const std::string before =
        std::string("LD_PRELOAD=") + RELIEFBENCH_FAILING_ALLOCATION +
        " RELIEFBENCH_REFUSE_ALLOCATIONS_OF=" + std::to_string(verify_resolution * verify_resolution * sizeof(Hit));
    expect_same_ending("host memory", json, "failed", "the host's memory is used up", false, before);
    const Outcome verified = verify(json, before);
    EXPECT_EQ(verified.code, 4);
    EXPECT_THAT(verified.out, AllOf(HasSubstr("FAIL  mine: compiles"), HasSubstr("the host's memory is used up")));
}

TEST_F(OneLaboratory, AHeightMapThatTakesAllMemoryFailsItsCellAndNotTheProgram) {
    if (has_own_allocator) GTEST_SKIP() << "a sanitizer's allocator takes the place of any other";
    write_technique("Trace trace(ReliefRay ray) { return hit_on_ray(1.0 - tap_height(ray.uv), 1); }");
    Json json = configuration();
    json["axes"]["heightmap_size"] = "76x52";
    const std::string before = std::string("LD_PRELOAD=") + RELIEFBENCH_FAILING_ALLOCATION +
                               " RELIEFBENCH_REFUSE_ALLOCATIONS_OF=" + std::to_string(76 * 52 * sizeof(float));
    expect_same_ending("height map", json, "failed", "the host's memory is used up", false, before);
}

}  // namespace
}  // namespace reliefbench
