// What is generic names no technique: the harness with its shaders, the report's page, the scripts, the build.

#include "source_tree.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace reliefbench::test {
namespace {

namespace fs = std::filesystem;

/// Ids that are words of their own: those of English and of geometry. They name a technique only in quotes, in capitals
/// or as a folder.
const std::set<std::string> words = {"flat", "parallax", "relief", "secant", "steep", "tessellation"};

/// What has a technique's name because a published method has it, and is not the technique's: a piece for techniques,
/// and a way to refine a hit.
const std::set<std::pair<std::string, std::string>> methods = {{"relaxed_cone.glsl", "relaxed_cone"},
                                                               {"prepare_search_falling_edges.glsl", "relaxed_cone"},
                                                               {"march.json", "secant"}};

std::vector<fs::path> generic_files() {
    std::vector<fs::path> files = files_below(source_root / "harness");
    for (const char* folder : {"report_page/src", "scripts"}) {
        const std::vector<fs::path> more =
            files_below(source_root / folder, {"", ".ts", ".css", ".html", ".mjs", ".py", ".cmake", ".sbatch"});
        files.insert(files.end(), more.begin(), more.end());
    }
    for (const char* file : {"CMakeLists.txt", "CMakePresets.json", "tests/CMakeLists.txt",
                             "report_page/CMakeLists.txt", "report_page/build.mjs", "configs/schema.json"})
        files.push_back(source_root / file);
    return files;
}

/// Examples of what a user types or sees need names: those of commands, conditions on the technique and cells' ids. A
/// guard has its file's name.
std::string without_examples_and_guards(const std::string& text) {
    static const std::regex example(
        R"(Example: reliefbench[^\n]*|technique=[a-z_,]+|[a-z_]+[ +]max_steps=\d+|RELIEFBENCH_[A-Z_]+_GLSL)");
    return std::regex_replace(text, example, "");
}

bool is_letter_or_digit(char character) {
    return std::isalnum(static_cast<unsigned char>(character)) != 0;
}

/// By itself or between underscores, which hold the words of a name together.
bool has_word(const std::string& text, const std::string& word) {
    for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
        const std::size_t end = at + word.size();
        if ((at == 0 || !is_letter_or_digit(text[at - 1])) && (end == text.size() || !is_letter_or_digit(text[end])))
            return true;
    }
    return false;
}

std::string capitals(std::string text) {
    for (char& character : text)
        character = static_cast<char>(std::toupper(static_cast<unsigned char>(character)));
    return text;
}

/// How the text names the technique; empty where it does not.
std::string naming(const std::string& text, const std::string& id) {
    std::vector<std::string> forms = {"techniques/" + id, "\"" + id + "\"", "'" + id + "'"};
    for (const std::string& form : forms) {
        if (text.find(form) != std::string::npos) return form;
    }
    if (has_word(text, capitals(id))) return capitals(id);
    return !words.contains(id) && has_word(text, id) ? id : "";
}

}  // namespace

TEST(Architecture, WhatIsGenericNamesNoTechnique) {
    const std::vector<fs::path> files = generic_files();
    EXPECT_GT(files.size(), 400U) << "found next to nothing to check";
    for (const fs::path& file : files) {
        const std::string text = without_examples_and_guards(read(file));
        const std::string stem = file.stem().string();
        for (const fs::path& folder : technique_folders()) {
            const std::string id = folder.filename().string();
            if (methods.contains({file.filename().string(), id})) continue;
            EXPECT_EQ(naming(text, id), "") << file << " names the technique " << id;
            EXPECT_TRUE(words.contains(id) || !has_word(stem, id)) << file << " is called as the technique " << id;
        }
    }
}

TEST(Architecture, EachWordThatIsATechniquesNameIsOne) {
    std::set<std::string> ids;
    for (const fs::path& folder : technique_folders())
        ids.insert(folder.filename().string());
    for (const std::string& word : words)
        EXPECT_TRUE(ids.contains(word)) << word;
    for (const auto& [file, id] : methods) {
        EXPECT_TRUE(ids.contains(id)) << id;
        const std::vector<fs::path> files = generic_files();
        EXPECT_TRUE(
            std::any_of(files.begin(), files.end(), [&](const fs::path& each) { return each.filename() == file; }))
            << "there is no " << file;
    }
}

}  // namespace reliefbench::test
