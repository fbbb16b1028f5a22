#include "store/crashes.hpp"

#include "core/error.hpp"
#include "store/line_file.hpp"
#include "support/error_message.hpp"
#include "support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

namespace reliefbench {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(Crashes, AreReadBackByCellInTheirOrder) {
    const TemporaryFolder folder;
    EXPECT_THAT(read_crashes(folder.path()), IsEmpty());
    append_crash(folder.path(), {"a", "first"});
    append_crash(folder.path(), {"b", "other"});
    append_crash(folder.path(), {"a", "second"});
    const auto crashes = read_crashes(folder.path());
    EXPECT_THAT(crashes.at("a"), ElementsAre("first", "second"));
    EXPECT_THAT(crashes.at("b"), ElementsAre("other"));
}

TEST(Crashes, AreReadBackByTheMapsThatWereBeingMade) {
    const TemporaryFolder folder;
    append_crash(folder.path(), {"a", "first", "maps of rock"});
    append_crash(folder.path(), {"b", "other"});
    append_crash(folder.path(), {"c", "second", "maps of rock"});
    const auto crashes = read_crashed_preparations(folder.path());
    EXPECT_EQ(crashes.size(), 1U);
    EXPECT_THAT(crashes.at("maps of rock"), ElementsAre("first", "second"));
    EXPECT_EQ(read_crash_lines(folder.path()).size(), 3U);
}

TEST(Crashes, ALineThatWasCutShortIsLeftOutAndABrokenOneIsTold) {
    const TemporaryFolder folder;
    append_crash(folder.path(), {"a", "first"});
    std::ofstream(folder / "crashes.jsonl", std::ios::app) << R"({"cell": "b", "rea)";
    EXPECT_EQ(read_crashes(folder.path()).size(), 1U);
    std::ofstream(folder / "crashes.jsonl") << "{\"cell\": 1}\n";
    EXPECT_THAT(error_message([&] { read_crashes(folder.path()); }), HasSubstr("crashes.jsonl (line 1): $.cell"));
}

TEST(LineFile, ThatWasRemovedMeanwhileIsAnError) {
    const TemporaryFolder folder;
    LineFile file(folder / "lines", LineFile::Start::created);
    file.append("one");
    std::filesystem::remove(folder / "lines");
    EXPECT_THAT(error_message([&] { file.append("two"); }), HasSubstr("was removed while it was being written"));
}

}  // namespace
}  // namespace reliefbench
