#include "command_line.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cstdlib>
#include <fstream>

namespace reliefbench {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class HostileInput : public CommandLine {
protected:
    /// A copy of steep named "hostile" with one more line, run beside steep itself; what its cell failed of.
    std::string reason_of_shader(const std::string& line) const {
        std::ofstream(copy_technique("steep", "hostile") / "trace.glsl", std::ios::app) << line << '\n';
        Json json = tiny_configuration();
        json["techniques"] = {"hostile", "steep"};
        const Outcome outcome = reliefbench(
            {"run", write_configuration("tiny.json", json), "--techniques", path("techniques"), "-o", path("run")});
        EXPECT_EQ(outcome.code, 4) << outcome.err;
        std::string reason;
        for (const Json& cell : read_lines(path("run/cells.jsonl"))) {
            const bool is_hostile = cell.at("technique") == "hostile";
            EXPECT_EQ(cell.at("status"), is_hostile ? "failed" : "ok") << cell.at("reason");
            if (is_hostile) reason = cell.at("reason").get<std::string>();
        }
        EXPECT_THAT(reason, HasSubstr("technique 'hostile'"));
        return reason;
    }

    /// Runs two cells of an axis, of which the second is to be skipped; says why.
    std::string reason_to_skip(const std::vector<std::string>& axis) const {
        std::vector<std::string> arguments{"run", write_configuration("tiny.json", tiny_configuration()), "-o",
                                           path("run")};
        arguments.insert(arguments.end(), axis.begin(), axis.end());
        const Outcome outcome = reliefbench(arguments);
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        int ok = 0;
        std::string reason;
        for (const Json& cell : read_lines(path("run/cells.jsonl"))) {
            if (cell.at("status") == "ok") ++ok;
            if (cell.at("status") == "skipped") reason = cell.at("reason").get<std::string>();
        }
        EXPECT_EQ(ok, 1);
        return reason;
    }
};

TEST_F(HostileInput, IncludesThatLeaveTheFolderFailTheirTechniqueOnly) {
    EXPECT_THAT(reason_of_shader("#include \"../steep/trace.glsl\""),
                AllOf(HasSubstr("trace.glsl:"), HasSubstr("leaves the folders that shaders are taken from")));
}

TEST_F(HostileInput, HalfAMillionMacroExpansionsFailTheirTechniqueOnly) {
    std::string macros = "#define x0 y += 1.0;\n";
    for (int i = 1; i <= 18; ++i)
        macros += fmt::format("#define x{0} x{1} x{1}\n", i, i - 1);
    EXPECT_THAT(reason_of_shader(macros + "float large() { float y = 0.0; x18 return y; }\nfloat spoilt = large();"),
                AllOf(HasSubstr("quad.frag: the compiler did not come to an end: what it made is larger than 9 MB"),
                      HasSubstr("it had read ")));
}

TEST_F(HostileInput, ACellThatMemoryDoesNotHoldIsSkippedWithNumbers) {
    setenv("RELIEFBENCH_MEMORY_MB", "100", 1);
    EXPECT_THAT(reason_to_skip({"-a", "resolution=32,1024"}),
                HasSubstr("the cell takes about 231 MB of memory, and 100 MB is available"));
    unsetenv("RELIEFBENCH_MEMORY_MB");
}

TEST_F(HostileInput, AHeightMapThatMemoryDoesNotHoldSkipsItsCells) {
    setenv("RELIEFBENCH_MEMORY_MB", "100", 1);
    EXPECT_THAT(reason_to_skip({"-a", "heightmap_size=32,2048"}), HasSubstr("100 MB is available"));
    unsetenv("RELIEFBENCH_MEMORY_MB");
}

TEST_F(HostileInput, ATargetThatTheDeviceDoesNotHoldIsSkippedWithNumbers) {
    EXPECT_THAT(reason_to_skip({"-a", "resolution=32,16384"}), HasSubstr("16384x16384"));
}

TEST_F(HostileInput, PatchesWithoutEndAreSkipped) {
    EXPECT_THAT(reason_to_skip({"-a", "technique=tessellation", "-a", "tiling=1,1024", "-a", "heightmap_size=256"}),
                HasSubstr("patches, more than"));
}

TEST_F(HostileInput, ConfigurationsWithoutEndAreRefused) {
    expect_refused({write("deep.json", std::string(100000, '['))}, {"deep.json:1:65: nested more than 64 deep"});
    expect_refused({"/dev/zero"}, {"/dev/zero", "larger than"});
    expect_refused({write("text.json", std::string("\xff\xfe\0{", 4))}, {"text.json:1:1:"});
}

}  // namespace
}  // namespace reliefbench
