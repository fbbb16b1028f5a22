#include "core/cache_folder.hpp"

#include "core/error.hpp"
#include "core/file.hpp"
#include "support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <optional>

namespace reliefbench {
namespace {

namespace fs = std::filesystem;

std::optional<std::string> content_of(const CachedFiles& files, const std::string& key) {
    std::optional<std::string> content;
    files.read(key, [&content](std::string_view text) { content = text; });
    return content;
}

TEST(CacheFolder, GivesBackWhatWasWritten) {
    const TemporaryFolder folder;
    const CachedFiles files{.folder = folder / "cache", .extension = ".things", .content = "things"};
    const std::string bytes("line\n\0\xff", 7);
    EXPECT_EQ(content_of(files, "key"), std::nullopt);
    files.write("key", bytes);
    EXPECT_EQ(content_of(files, "key"), bytes);
    EXPECT_EQ(content_of(files, "another"), std::nullopt);
    EXPECT_TRUE(fs::exists(folder / "cache" / "key.things"));
}

TEST(CacheFolder, WhatIsDamagedOrNotTakenIsNotRead) {
    const TemporaryFolder folder;
    const CachedFiles files{.folder = folder.path(), .extension = ".things", .content = "things"};
    files.write("key", "content");
    const std::string whole = read_text_file(folder / "key.things");
    for (std::size_t size = 0; size < whole.size(); ++size) {
        write_text_file(folder / "key.things", whole.substr(0, size));
        EXPECT_EQ(content_of(files, "key"), std::nullopt) << "cut after " << size << " bytes";
    }
    write_text_file(folder / "key.things", whole);
    EXPECT_FALSE(files.read("key", [](std::string_view) { fail("of another version"); }));
    EXPECT_TRUE(files.read("key", [](std::string_view) {}));
}

TEST(CacheFolder, ThoseOfAKindUsedLongestAgoMakeRoom) {
    const TemporaryFolder folder;
    const CachedFiles others{.folder = folder.path(), .extension = ".others", .content = "others"};
    others.write("a", std::string(5000, 'x'));
    const CachedFiles files{
        .folder = folder.path(), .extension = ".things", .content = "things", .max_bytes = 3 * 1100};
    for (const char* name : {"a", "b", "c"}) {
        files.write(name, std::string(1000, 'x'));
        // File systems keep times coarsely.
        const fs::path file = folder / (std::string(name) + ".things");
        fs::last_write_time(file, fs::last_write_time(file) - std::chrono::hours(10 - name[0] + 'a'));
    }
    EXPECT_TRUE(content_of(files, "a")) << "now the one used last";
    files.write("d", std::string(1000, 'x'));
    EXPECT_TRUE(fs::exists(folder / "a.things"));
    EXPECT_FALSE(fs::exists(folder / "b.things"));
    EXPECT_TRUE(fs::exists(folder / "c.things"));
    EXPECT_TRUE(fs::exists(folder / "d.things"));
    EXPECT_TRUE(fs::exists(folder / "a.others"));
}

TEST(CacheFolder, AFolderThatCannotBeIsNoFailure) {
    const TemporaryFolder folder;
    write_text_file(folder / "file", "");
    const CachedFiles files{.folder = folder / "file", .extension = ".things", .content = "things"};
    EXPECT_NO_THROW(files.write("key", "content"));
    EXPECT_EQ(content_of(files, "key"), std::nullopt);
}

TEST(CacheFolder, WithoutAFolderNothingIsCached) {
    const CachedFiles files{.folder = {}, .extension = ".things", .content = "things"};
    EXPECT_NO_THROW(files.write("key", "content"));
    EXPECT_EQ(content_of(files, "key"), std::nullopt);
}

TEST(CacheFolder, TheFolderIsChosenByTheEnvironment) {
    ::setenv("HOME", "/home/someone", 1);
    ::unsetenv("XDG_CACHE_HOME");
    ::unsetenv("RELIEFBENCH_CACHE_DIR");
    EXPECT_EQ(cache_folder(), "/home/someone/.cache/reliefbench");
    ::setenv("XDG_CACHE_HOME", "/caches", 1);
    EXPECT_EQ(cache_folder(), "/caches/reliefbench");
    ::setenv("RELIEFBENCH_CACHE_DIR", "/maps", 1);
    EXPECT_EQ(cache_folder(), "/maps");
    for (const char* name : {"HOME", "XDG_CACHE_HOME", "RELIEFBENCH_CACHE_DIR"})
        ::unsetenv(name);
    EXPECT_EQ(cache_folder(), "");
}

}  // namespace
}  // namespace reliefbench
