#include "technique/baseline_sources.hpp"

#include "core/file.hpp"
#include "core/process.hpp"
#include "support/error_message.hpp"
#include "support/temporary_folder.hpp"
#include "technique/technique.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

namespace reliefbench {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;

constexpr const char* manifest =
    R"({ "title": "T", "kind": "march", "citation": "c", "parameters": [], "shape": "quad", "promises": [] })";

void write(const fs::path& path, const std::string& text) {
    fs::create_directories(path.parent_path());
    write_text_file(path, text);
}

/// A checkout with two techniques and a shared shader, in a repository of its own or in none.
class Baseline : public testing::Test {
protected:
    void SetUp() override { write_checkout(checkout_, "one"); }

    static void write_checkout(const fs::path& folder, const std::string& words) {
        for (const std::string id : {"first", "second"}) {
            write(folder / "techniques" / id / "technique.json", manifest);
            write(folder / "techniques" / id / "trace.glsl", "// " + words);
        }
        write(folder / "harness/shaders/relief.glsl", "// shared " + words);
    }

    void git(const std::vector<std::string>& arguments) const {
        std::vector<std::string> command{"git", "-C", checkout_.string(), "-c", "user.name=n", "-c", "user.email=e"};
        command.insert(command.end(), arguments.begin(), arguments.end());
        const FinishedProcess finished = run_process(command);
        ASSERT_EQ(finished.exit_code, 0) << finished.errors;
    }

    void commit(const std::string& tag) const {
        if (!fs::exists(checkout_ / ".git")) git({"init", "-q"});
        git({"add", "-A"});
        git({"commit", "-q", "-m", tag});
        git({"tag", tag});
    }

    TechniqueSources own() const {
        return {{checkout_ / "techniques"}, checkout_ / "harness/shaders", "the work tree"};
    }

    TechniqueSources find(const std::string& baseline) const {
        return find_baseline(baseline, own(), (folder_.path() / "scratch") / std::to_string(++finds_));
    }

    TemporaryFolder folder_;
    mutable int finds_ = 0;
    const fs::path checkout_ = folder_.path() / "check out";
};

TEST_F(Baseline, ARevisionIsReadWithoutTouchingTheWorkTree) {
    commit("old");
    write_checkout(checkout_, "two");
    write(checkout_ / "techniques/third/technique.json", manifest);
    const TechniqueSources old = find("old");
    ASSERT_EQ(old.roots.size(), 1U);
    EXPECT_EQ(read_text_file(old.roots[0] / "first/trace.glsl"), "// one");
    EXPECT_EQ(read_text_file(old.shaders / "relief.glsl"), "// shared one");
    EXPECT_FALSE(fs::exists(old.roots[0] / "third"));
    EXPECT_EQ(read_text_file(checkout_ / "techniques/first/trace.glsl"), "// two");
    EXPECT_THAT(old.description, AllOf(HasSubstr("old"), HasSubstr(checkout_.string())));
}

TEST_F(Baseline, ATechniqueDeletedSinceIsThereInTheRevision) {
    commit("old");
    fs::remove_all(checkout_ / "techniques/second");
    commit("new");
    EXPECT_TRUE(fs::exists(find("old").roots[0] / "second/technique.json"));
    EXPECT_FALSE(fs::exists(find("new").roots[0] / "second"));
}

TEST_F(Baseline, AllThatGitTakesForACommitWorks) {
    commit("old");
    write_checkout(checkout_, "two");
    commit("v-1.0_rc");
    EXPECT_EQ(read_text_file(find("HEAD~1").shaders / "relief.glsl"), "// shared one");
    EXPECT_EQ(read_text_file(find("v-1.0_rc").shaders / "relief.glsl"), "// shared two");
    EXPECT_EQ(read_text_file(find("HEAD^{/old}").shaders / "relief.glsl"), "// shared one");
    EXPECT_EQ(read_text_file(find("refs/tags/old").shaders / "relief.glsl"), "// shared one");
}

TEST_F(Baseline, WhatIsNoRevisionIsAnErrorThatSaysSo) {
    commit("old");
    EXPECT_THAT(error_message([&] { find(""); }), HasSubstr("the baseline is empty"));
    for (const std::string name : {"nonsense", "a b", "old; touch x", "--all", "-h", "HEAD:techniques", "--output=x"}) {
        EXPECT_THAT(error_message([&] { find(name); }), AllOf(HasSubstr("'" + name + "'"), HasSubstr("neither")))
            << name;
    }
    EXPECT_FALSE(fs::exists(checkout_ / "x"));
}

TEST_F(Baseline, WithoutARepositoryOnlyFoldersWork) {
    EXPECT_THAT(error_message([&] { find("HEAD"); }), HasSubstr("git repository"));
}

TEST_F(Baseline, ARevisionWithoutTechniquesIsAnError) {
    git({"init", "-q"});
    git({"commit", "-q", "--allow-empty", "-m", "empty"});
    EXPECT_THAT(error_message([&] { find("HEAD"); }), HasSubstr("no techniques"));
}

TEST_F(Baseline, ADirectoryNamedBesideIsTakenFromTheRevisionOfItsRepository) {
    const fs::path mine = folder_.path() / "mine";
    write(mine / "third/trace.glsl", "// one");
    commit("old");
    TechniqueSources with_mine = own();
    with_mine.roots.push_back(mine);
    // In no repository: the same on both sides.
    TechniqueSources found = find_baseline("old", with_mine, folder_.path() / "scratch1");
    ASSERT_EQ(found.roots.size(), 2U);
    EXPECT_EQ(found.roots[0], mine) << "before the revision's, whose techniques take the place of those with their ids";
    EXPECT_NE(found.roots[1], checkout_ / "techniques");

    const auto git_mine = [&](std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), {"git", "-C", mine.string(), "-c", "user.name=n", "-c", "user.email=e"});
        ASSERT_EQ(run_process(arguments).exit_code, 0);
    };
    git_mine({"init", "-q"});
    git_mine({"add", "-A"});
    git_mine({"commit", "-q", "-m", "mine"});
    write(mine / "third/trace.glsl", "// two");
    found = find_baseline("HEAD", with_mine, folder_.path() / "scratch2");
    ASSERT_EQ(found.roots.size(), 2U);
    EXPECT_EQ(found.roots[0], checkout_ / "techniques");
    EXPECT_EQ(read_text_file(found.roots[1] / "third/trace.glsl"), "// one");
    EXPECT_EQ(found.shaders, checkout_ / "harness/shaders");
}

TEST_F(Baseline, AHooksRepositoryIsNotMistakenForOurs) {
    commit("old");
    ASSERT_EQ(setenv("GIT_DIR", "/nowhere", 1), 0);
    EXPECT_EQ(find("old").roots.size(), 1U);
    ASSERT_EQ(unsetenv("GIT_DIR"), 0);
}

TEST_F(Baseline, ACheckoutBringsItsSharedShaders) {
    const fs::path other = folder_.path() / "other";
    write_checkout(other, "other");
    const TechniqueSources found = find(other.string());
    EXPECT_THAT(found.roots, testing::ElementsAre(other / "techniques"));
    EXPECT_EQ(found.shaders, other / "harness/shaders");
}

TEST_F(Baseline, AFolderOfTechniqueFoldersSharesOurs) {
    const TechniqueSources found = find((checkout_ / "techniques").string());
    EXPECT_THAT(found.roots, testing::ElementsAre(checkout_ / "techniques"));
    EXPECT_EQ(found.shaders, own().shaders);
}

TEST_F(Baseline, AFolderWithoutTechniquesIsAnError) {
    fs::create_directory(folder_.path() / "empty");
    EXPECT_THAT(error_message([&] { find((folder_.path() / "empty").string()); }),
                HasSubstr("holds no technique folder"));
    EXPECT_THAT(error_message([&] { find((checkout_ / "techniques/first").string()); }),
                HasSubstr("one technique's folder"));
}

TEST_F(Baseline, SharedShadersOfAnotherInterfaceAreNotUsed) {
    const std::string block = "layout(set = 0, binding = 0) uniform Scene {\n    float a;  // one\n    float b;\n};\n";
    write(checkout_ / "harness/shaders/scene.glsl", block);
    const fs::path other = folder_.path() / "other";
    write_checkout(other, "other");
    write(other / "harness/shaders/scene.glsl", "// the scene\n" + block + "float twice() { return 2.0 * a; }\n");
    EXPECT_EQ(find(other.string()).shaders, other / "harness/shaders") << "the same interface in other words";
    write(other / "harness/shaders/scene.glsl",
          "layout(set = 0, binding = 0) uniform Scene {\n    float b;\n    float a;\n};\n");
    const TechniqueSources found = find(other.string());
    EXPECT_EQ(found.shaders, own().shaders);
    ASSERT_EQ(found.notices.size(), 1U);
    EXPECT_THAT(found.notices[0], HasSubstr("another version of the harness"));
}

/// Revisions before harness/shaders had folders have its files in it.
TEST_F(Baseline, SharedShadersOfARevisionWithoutFoldersAreUsedWhereTheirInterfaceIsTheSame) {
    const std::string block = "layout(set = 0, binding = 0) uniform Scene {\n    float a;\n};\n";
    write(checkout_ / "harness/shaders/scene.glsl", block);
    write(checkout_ / "harness/shaders/steps.json", R"({"parameters": []})");
    write(checkout_ / "techniques/first/technique.json",
          R"({ "title": "T", "kind": "march", "citation": "c", "include": ["steps.json"], "parameters": [],
               "shape": "quad", "promises": [] })");
    commit("flat");
    fs::remove_all(checkout_ / "harness/shaders");
    write(checkout_ / "harness/shaders/contract/scene.glsl", block);
    const TechniqueSources found = find("flat");
    EXPECT_THAT(found.notices, testing::IsEmpty());
    EXPECT_EQ(read_text_file(found.shaders / "relief.glsl"), "// shared one");
    const TechniqueLibrary library = find_techniques(found.roots, found.shaders);
    EXPECT_EQ(library.techniques.size(), 2U) << (library.broken.empty() ? "" : library.broken[0].second);
}

TEST(ShaderInterface, HasAllThatTheHarnessBinds) {
    const std::vector<std::string> interface = shader_interface(shader_root());
    const auto has = [&](const std::string& words) {
        return std::any_of(interface.begin(), interface.end(), [&](const std::string& declaration) {
            return declaration.find(words) != std::string::npos;
        });
    };
    for (const std::string words :
         {"clip_from_world", "patch_count", "srgb_target", "relief_repeats", "height_map", "height_texels",
          "height_derivatives", "albedo_map", "previous_map", "pixels[]", "push_constant"}) {
        EXPECT_TRUE(has(words)) << words;
    }
}

TEST_F(Baseline, ALibraryKnowsItsSharedShaders) {
    const fs::path other = folder_.path() / "other";
    write_checkout(other, "other");
    const TechniqueLibrary library = find_techniques({other / "techniques"}, other / "harness/shaders");
    ASSERT_EQ(library.techniques.size(), 2U) << (library.broken.empty() ? "" : library.broken[0].second);
    EXPECT_EQ(library.techniques[0].shaders, other / "harness/shaders");
}

}  // namespace
}  // namespace reliefbench
