// What the command line says of itself: help, completion in real shells, the manual page.

#include "command_line.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>

namespace reliefbench {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::IsSupersetOf;
using testing::Not;
using testing::UnorderedElementsAre;

class Shell : public CommandLine {
protected:
    /// Standard output and errors of a shell command in this test's folder.
    Outcome shell(const std::string& command) const {
        const std::string line =
            fmt::format("cd {} && {{ {} ; }} >{} 2>{}", path("."), command, path("out"), path("err"));
        const int status = std::system(line.c_str());
        return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_file(path("out")), read_file(path("err"))};
    }

    bool has_program(const std::string& name) const { return shell("command -v " + name).code == 0; }

    static std::vector<std::string> words_of(const std::string& text) {
        std::istringstream stream(text);
        std::vector<std::string> words;
        for (std::string word; stream >> word;)
            words.push_back(word);
        return words;
    }

    /// Names of the commands that help lists below `command`.
    std::vector<std::string> commands_below(std::vector<std::string> command) const {
        command.push_back("--help");
        const std::string help = reliefbench(command).out;
        const std::size_t begin = help.find("Subcommands:\n");
        std::vector<std::string> names;
        if (begin == std::string::npos) return names;
        std::istringstream lines(help.substr(begin));
        std::string line;
        std::getline(lines, line);
        while (std::getline(lines, line) && line.starts_with("  ")) {
            if (line[2] != ' ') names.push_back(words_of(line).front());
        }
        return names;
    }

    /// What bash offers for the last of `words`, which follow the program's name.
    std::vector<std::string> bash_offers(const std::vector<std::string>& words) const {
        std::string line = "COMP_WORDS=(" RELIEFBENCH_BINARY;
        for (const std::string& word : words)
            line += fmt::format(" '{}'", word);
        const Outcome outcome =
            shell(fmt::format("bash --norc -c \"source <({} completion bash); {}); COMP_CWORD={}; _reliefbench; "
                              "printf '%s\\n' \\\"\\${{COMPREPLY[@]}}\\\"\"",
                              RELIEFBENCH_BINARY, line, words.size()));
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        EXPECT_EQ(outcome.err, "");
        return words_of(outcome.out);
    }
};

TEST_F(Shell, HelpOfEveryCommandShowsAnExample) {
    const std::vector<std::string> commands = commands_below({});
    EXPECT_THAT(commands, IsSupersetOf({"list", "run", "render", "verify", "compare", "export", "completion", "man"}));
    for (const std::string& command : commands) {
        EXPECT_THAT(reliefbench({command, "--help"}).out, HasSubstr("Example: "));
        for (const std::string& below : commands_below({command})) {
            EXPECT_THAT(reliefbench({command, below, "--help"}).out,
                        HasSubstr("Example: reliefbench " + command + " " + below));
        }
    }
}

TEST_F(Shell, FiguresAreListedOneALineWithUnitDirectionAndWhatTheyNeed) {
    const std::string table = reliefbench({"list", "figures"}).out;
    EXPECT_THAT(table, testing::ContainsRegex("\nerror.uv_texels.p99 +texels +lower +truth +UV error, p99\n"));
    EXPECT_THAT(table, testing::ContainsRegex("\nimage.psnr +dB +higher +truth lighting +PSNR, whole picture\n"));
    EXPECT_THAT(table, testing::ContainsRegex("\nimage.footprint.ssim +- +higher +truth lighting +SSIM, footprint\n"));
    EXPECT_THAT(table, testing::ContainsRegex("\nwork.taps_mean +- +lower +- +Taps per pixel\n"));
    const std::string json = reliefbench({"list", "figures", "--format", "json"}).out;
    EXPECT_EQ(json, read_file(RELIEFBENCH_SOURCE_DIR "/scripts/figures.json"));
    EXPECT_EQ(static_cast<std::size_t>(std::count(table.begin(), table.end(), '\n')), Json::parse(json).size());
    const std::string document = read_file(RELIEFBENCH_SOURCE_DIR "/docs/architecture.md");
    EXPECT_THAT(document,
                HasSubstr("<!-- reliefbench list figures --format markdown -->\n" +
                          reliefbench({"list", "figures", "--format", "markdown"}).out + "<!-- end of the list -->\n"))
        << "write it again: scripts/write_figures";
    const Outcome refused = reliefbench({"list", "figures", "--format", "jsn"});
    EXPECT_EQ(refused.code, 2);
    EXPECT_THAT(refused.err, HasSubstr("did you mean 'json'"));
}

TEST_F(Shell, BashCompletesCommandsOptionsAndValues) {
    EXPECT_THAT(bash_offers({""}), IsSupersetOf(commands_below({})));
    EXPECT_THAT(bash_offers({"ren"}), UnorderedElementsAre("render"));
    EXPECT_THAT(bash_offers({"list", ""}),
                UnorderedElementsAre("techniques", "devices", "heightmaps", "axes", "bases", "presets", "figures"));
    EXPECT_THAT(bash_offers({"run", "--f"}), UnorderedElementsAre("--filter", "--format"));
    EXPECT_THAT(bash_offers({"run", "--format", ""}), UnorderedElementsAre("table", "markdown", "csv", "json"));
    // bash splits --color=al at the '='.
    EXPECT_THAT(bash_offers({"run", "--color", "=", "al"}), UnorderedElementsAre("always"));
    EXPECT_THAT(bash_offers({"list", "techniques", "--te"}), UnorderedElementsAre("--techniques"));
    EXPECT_THAT(bash_offers({"completion", ""}), UnorderedElementsAre("bash", "zsh"));
    EXPECT_THAT(bash_offers({"run", "--no-such-option"}), testing::IsEmpty());
}

TEST_F(Shell, BashCompletesTechniquesHeightMapsAxesAndFiles) {
    EXPECT_THAT(bash_offers({"render", "--technique", ""}), IsSupersetOf({"pom", "qdm", "steep"}));
    EXPECT_THAT(bash_offers({"run", "--filter", "technique", "=", "po"}), UnorderedElementsAre("pom"));
    EXPECT_THAT(bash_offers({"run", "-a", "heightmap", "=", "ro"}), Contains("rock"));
    EXPECT_THAT(bash_offers({"run", "-a", "view"}), UnorderedElementsAre("view_angle="));
    EXPECT_THAT(bash_offers({"run", "-a", "pre"}), UnorderedElementsAre("preset="));
    EXPECT_THAT(bash_offers({"run", "-a", "preset", "=", ""}),
                AllOf(Contains("unity_hdrp"), Contains("godot_4"), Not(Contains("in"))));
    write("my configuration.json", "{}");
    std::filesystem::create_directory(path("runs"));
    EXPECT_THAT(bash_offers({"run", "my"}), UnorderedElementsAre("my", "configuration.json"));
    EXPECT_THAT(bash_offers({"export", "r"}), UnorderedElementsAre("runs"));
}

TEST_F(Shell, ZshCompletesTheSame) {
    if (!has_program("zsh")) GTEST_SKIP() << "there is no zsh";
    write("_reliefbench", reliefbench({"completion", "zsh"}).out);
    const std::string binary_folder = std::filesystem::path(RELIEFBENCH_BINARY).parent_path();
    const auto offers = [&](const std::string& line) {
        const Outcome outcome = shell(fmt::format("PATH={}:$PATH zsh -f {}/tests/cli/zsh_offers {} '{}'", binary_folder,
                                                  RELIEFBENCH_SOURCE_DIR, path("."), line));
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        return words_of(outcome.out);
    };
    EXPECT_THAT(offers("reliefbench "), IsSupersetOf(commands_below({})));
    EXPECT_THAT(offers("reliefbench run --for"), Contains("--format"));
    EXPECT_THAT(offers("reliefbench run --format "), UnorderedElementsAre("table", "markdown", "csv", "json"));
    EXPECT_THAT(offers("reliefbench list "),
                UnorderedElementsAre("techniques", "devices", "heightmaps", "axes", "bases", "presets", "figures"));
    EXPECT_THAT(offers("reliefbench render --technique "), IsSupersetOf({"pom", "qdm", "steep"}));
    EXPECT_THAT(offers("reliefbench run --filter technique=po"), UnorderedElementsAre("pom"));
    EXPECT_THAT(offers("reliefbench run --filter preset=god"), UnorderedElementsAre("godot_4"));
}

TEST_F(Shell, TheManualHasEveryCommandAndOptionAndNoWarnings) {
    write("reliefbench.1", reliefbench({"man"}).out);
    if (!has_program("groff")) GTEST_SKIP() << "there is no groff";
    const Outcome page = shell("groff -man -ww -Tascii -P-cbou -rLL=100n reliefbench.1");
    EXPECT_EQ(page.code, 0);
    EXPECT_EQ(page.err, "");
    for (const std::string& command : commands_below({})) {
        EXPECT_THAT(page.out, HasSubstr("reliefbench " + command));
    }
    EXPECT_THAT(page.out, AllOf(HasSubstr("NAME"), HasSubstr("-o, --output DIR"), HasSubstr("EXIT CODES"),
                                HasSubstr("ENVIRONMENT"), HasSubstr("--format table|markdown|csv|json"),
                                HasSubstr("reliefbench list techniques --techniques my_techniques")));
    EXPECT_THAT(page.out, Not(HasSubstr("Example: ")));
}

}  // namespace
}  // namespace reliefbench
