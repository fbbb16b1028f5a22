#include "technique/map_cache.hpp"

#include "core/file.hpp"
#include "support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <filesystem>

namespace reliefbench {
namespace {

namespace fs = std::filesystem;

const std::string key = "0123456789abcdef";

KeptMaps sample() {
    KeptMaps maps{.pass_ms = {{"search", {1.5, 2.25}}, {"finish", {0.125}}}, .levels = {}};
    // A line's end and a byte of no text among them.
    maps.levels.push_back({std::byte{'\n'}, std::byte{0}, std::byte{0xff}, std::byte{7}});
    maps.levels.emplace_back();
    maps.levels.push_back({std::byte{42}});
    return maps;
}

std::vector<fs::path> files_of(const fs::path& folder) {
    std::vector<fs::path> files;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder))
        files.push_back(entry.path());
    return files;
}

TEST(MapCache, GivesBackWhatWasKept) {
    const TemporaryFolder folder;
    EXPECT_FALSE(read_kept_maps(folder / "maps", key));
    write_kept_maps(folder / "maps", key, sample());
    const std::optional<KeptMaps> kept = read_kept_maps(folder / "maps", key);
    ASSERT_TRUE(kept);
    EXPECT_EQ(kept->pass_ms, sample().pass_ms);
    EXPECT_EQ(kept->levels, sample().levels);
    EXPECT_FALSE(read_kept_maps(folder / "maps", "another"));
    EXPECT_EQ(files_of(folder / "maps").size(), 1U) << "nothing but the file is left behind";
}

TEST(MapCache, ADamagedFileIsNotUsed) {
    const TemporaryFolder folder;
    write_kept_maps(folder.path(), key, sample());
    const fs::path file = files_of(folder.path()).front();
    const std::string whole = read_text_file(file);
    for (std::size_t size = 0; size < whole.size(); ++size) {
        write_text_file(file, whole.substr(0, size));
        EXPECT_FALSE(read_kept_maps(folder.path(), key)) << "cut after " << size << " bytes";
    }
    for (const std::size_t place : {std::size_t{0}, whole.find("1.5"), whole.size() - 1}) {
        std::string damaged = whole;
        damaged[place] = static_cast<char>(damaged[place] ^ 4);
        write_text_file(file, damaged);
        EXPECT_FALSE(read_kept_maps(folder.path(), key)) << "byte " << place;
    }
    write_text_file(file, whole);
    EXPECT_TRUE(read_kept_maps(folder.path(), key));
}

TEST(MapCache, AFolderThatCannotBeIsNoFailure) {
    const TemporaryFolder folder;
    write_text_file(folder / "file", "");
    EXPECT_NO_THROW(write_kept_maps(folder / "file", key, sample()));
    EXPECT_FALSE(read_kept_maps(folder / "file", key));
}

}  // namespace
}  // namespace reliefbench
