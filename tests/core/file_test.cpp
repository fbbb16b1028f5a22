#include "core/file.hpp"

#include "core/error.hpp"
#include "core/hash.hpp"
#include "support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

using namespace reliefbench;

namespace {

class FileTest : public testing::Test {
protected:
    const TemporaryFolder folder;
};

TEST_F(FileTest, WhatIsWrittenIsRead) {
    const std::string text("line\r\n\0binary\xff", 14);
    write_text_file(folder / "a", text);
    EXPECT_EQ(read_text_file(folder / "a"), text);
    write_text_file(folder / "a", "");
    EXPECT_EQ(read_text_file(folder / "a"), "");
}

TEST_F(FileTest, WritingLeavesNothingBeside) {
    write_text_file(folder / "a", "text");
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
}

TEST_F(FileTest, ErrorsNameTheFileAndTheReason) {
    EXPECT_THAT([&] { read_text_file(folder / "missing"); },
                testing::ThrowsMessage<Error>(
                    testing::AllOf(testing::HasSubstr("missing"), testing::HasSubstr("No such file or directory"))));
    EXPECT_THAT([&] { read_text_file(folder.path()); },
                testing::ThrowsMessage<Error>(testing::HasSubstr("Is a directory")));
    EXPECT_THAT([&] { write_text_file(folder / "none" / "a", "text"); },
                testing::ThrowsMessage<Error>(testing::HasSubstr("No such file or directory")));
}

TEST_F(FileTest, AFailedWriteKeepsTheOldFileAndLeavesNothingBeside) {
    // A folder cannot be replaced by a file: the rename fails after the text was written.
    std::filesystem::create_directories(folder / "occupied" / "inside");
    EXPECT_THROW(write_text_file(folder / "occupied", "text"), Error);
    EXPECT_TRUE(std::filesystem::is_directory(folder / "occupied" / "inside"));
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
}

TEST(ContentHash, IsXxh3Of128Bits) {
    // xxhsum -H2 of the empty file, as published with the algorithm.
    EXPECT_EQ(content_hash(""), "99aa06d3014798d86001c324468d497f");
    EXPECT_EQ(content_hash("a").size(), 32u);
    EXPECT_NE(content_hash("a"), content_hash("b"));
}

}  // namespace
