#include "store/environment.hpp"

#include "support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

using namespace reliefbench;

namespace {

namespace fs = std::filesystem;

/// A repository of one commit, in a folder whose name needs quoting.
class GitFolder : public testing::Test {
protected:
    void SetUp() override {
        fs::create_directories(folder / "below");
        std::ofstream(folder / "file") << "one";
        const std::string git = "git -C \"" + parent.string() + "/it's \\$HOME\" ";
        ASSERT_EQ(std::system((git + "init -q && " + git + "add file && " + git +
                               "-c user.name=Test -c user.email=test@example.org commit -q -m first")
                                  .c_str()),
                  0);
    }

    const TemporaryFolder temporary;
    const fs::path parent = temporary.path();
    const fs::path folder = parent / "it's $HOME";
};

TEST_F(GitFolder, ACleanWorkTreeHasACommitAndIsNotDirty) {
    const auto revision = read_source_revision(folder);
    ASSERT_TRUE(revision);
    EXPECT_THAT(revision->commit, testing::MatchesRegex("[0-9a-f]+"));
    EXPECT_EQ(revision->commit.size(), 40U);
    EXPECT_EQ(revision->dirty, false);
}

TEST_F(GitFolder, AChangedFileAndANewFileAreDirty) {
    std::ofstream(folder / "file") << "two";
    EXPECT_EQ(read_source_revision(folder)->dirty, true);
    std::ofstream(folder / "file") << "one";
    EXPECT_EQ(read_source_revision(folder)->dirty, false);
    std::ofstream(folder / "new") << "";
    EXPECT_EQ(read_source_revision(folder)->dirty, true);
}

TEST_F(GitFolder, AFolderInsideAnotherRepositoryHasNoRevisionOfItsOwn) {
    EXPECT_FALSE(read_source_revision(folder / "below"));
    EXPECT_FALSE(read_source_revision(parent));
    EXPECT_FALSE(read_source_revision(parent / "missing"));
}

TEST(Environment, TellsWhatThisMachineIs) {
    const Json json = environment_to_json();
    EXPECT_THAT(json["tool_version"].get<std::string>(), testing::MatchesRegex("[0-9]+\\.[0-9]+\\.[0-9]+"));
    EXPECT_GE(json["cores"].get<int>(), 1);
    EXPECT_THAT(json["os"].get<std::string>(), testing::HasSubstr("Linux"));
    EXPECT_THAT(json["time"].get<std::string>(),
                testing::MatchesRegex("20[0-9][0-9]-[0-9][0-9]-[0-9][0-9]T[0-9][0-9]:[0-9][0-9]:[0-9][0-9]Z"));
    EXPECT_TRUE(json["cpu"].is_null() || !json["cpu"].get<std::string>().empty());
}

TEST(Environment, NamesNoHost) {
    char host[256] = {};
    gethostname(host, sizeof host - 1);
    // A host may be called like a word of the record ("linux"); a value that is the host's name is what must not be.
    const Json json = environment_to_json();
    for (const auto& [key, value] : json.items()) {
        EXPECT_NE(value, Json(host)) << key;
    }
}

TEST(Environment, WhatIsUnknownIsNull) {
    const Json json = to_json(Environment{});
    EXPECT_TRUE(json["git_revision"].is_null());
    EXPECT_TRUE(json["git_dirty"].is_null());
    EXPECT_TRUE(json["cpu"].is_null());
}

}  // namespace
