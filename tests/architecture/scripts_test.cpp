// What scripts ask of CMake and of ctest is there: an option that names nothing is taken in silence.

#include "source_tree.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace reliefbench::test {
namespace {

namespace fs = std::filesystem;

const std::vector<std::string> testing_scripts = {"scripts/test", "scripts/test_sanitized", "scripts/quickstart",
                                                  "scripts/fuzz"};

const std::string& tests_listed() {
    static const std::string text = read(source_root / "tests/CMakeLists.txt");
    return text;
}

bool is_listed(const std::string& pattern) {
    return std::regex_search(tests_listed(), std::regex(pattern));
}

/// The arguments of CMake's list in shell syntax: "layers=(core scene)".
std::set<std::string> words_of(const std::string& text) {
    std::istringstream stream(text);
    std::set<std::string> words;
    for (std::string word; stream >> word;)
        words.insert(word);
    return words;
}

}  // namespace

TEST(Scripts, AskForPresetsThatThereAre) {
    const nlohmann::json presets = nlohmann::json::parse(read(source_root / "CMakePresets.json"));
    const auto names = [&](const char* kind) {
        std::set<std::string> found;
        for (const nlohmann::json& preset : presets.at(kind))
            found.insert(preset.at("name").get<std::string>());
        return found;
    };
    std::size_t checked = 0;
    for (const std::string& script : testing_scripts) {
        const std::string text = read(source_root / script);
        for (const auto& [command, kind] :
             {std::pair("cmake", "configurePresets"), {"cmake --build", "buildPresets"}, {"ctest", "testPresets"}}) {
            for (const std::string& name :
                 matches(text, std::regex(std::string("\\n *") + command + " --preset ([a-z_]+)"))) {
                EXPECT_TRUE(names(kind).contains(name)) << script << ": " << command << " --preset " << name;
                ++checked;
            }
        }
    }
    EXPECT_GE(checked, 9U) << "found next to nothing to check";
}

TEST(Scripts, SelectTestsByMarksThatThereAre) {
    std::size_t checked = 0;
    for (const std::string& script : testing_scripts) {
        const std::string text = read(source_root / script);
        for (const std::string& name : matches(text, std::regex("--build-config[ =]([A-Za-z_]+)"))) {
            EXPECT_TRUE(is_listed("CONFIGURATIONS [^\\n]*\\b" + name + "\\b")) << script << ": --build-config " << name;
            ++checked;
        }
        for (const std::string& name : matches(text, std::regex("(?:-L|-LE|--label-regex)[ =]'?([a-z_]+)")))
            EXPECT_TRUE(is_listed("LABELS [^\\n]*\\b" + name + "\\b")) << script << ": label " << name;
    }
    EXPECT_GE(checked, 1U) << "found nothing to check";
}

/// Nothing is marked to run alone: a script or a document that says so is wrong, or the mark is missing.
TEST(Scripts, SpeakOfNoMarkThatNoTestHas) {
    const bool any_alone = is_listed("RUN_SERIAL|RESOURCE_LOCK");
    for (const std::string& script : testing_scripts) {
        const std::string text = read(source_root / script);
        const bool says_so =
            std::regex_search(text, std::regex("\\bis marked\\b|\\bare marked\\b|RUN_SERIAL|RESOURCE_LOCK"));
        EXPECT_TRUE(any_alone || !says_so) << script;
    }
}

TEST(Scripts, SanitiseLayersThatHaveTests) {
    const std::string text = read(source_root / "scripts/test_sanitized");
    const std::vector<std::string> lists = matches(text, std::regex("layers=\\(([a-z ]+)\\)"));
    ASSERT_EQ(lists.size(), 1U);
    for (const std::string& layer : words_of(lists.front())) {
        const bool has_tests =
            is_listed("reliefbench_tests\\(" + layer + "[ )]") ||
            (is_listed("add_subdirectory\\(" + layer + "\\)") &&
             read(source_root / "tests" / layer / "CMakeLists.txt").find(layer + "_tests") != std::string::npos);
        EXPECT_TRUE(has_tests) << layer;
    }
}

}  // namespace reliefbench::test
