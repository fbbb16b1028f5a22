#include "store/read_samples.hpp"

#include "core/file.hpp"
#include "support/error_message.hpp"
#include "support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

using namespace reliefbench;

namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Pair;

class ReadSamples : public testing::Test {
protected:
    void write(const std::string& lines) const { write_text_file(folder / "samples.jsonl", lines); }

    const TemporaryFolder folder;
    const std::string line = R"({"cell":"a","pass":"draw","round":2,"order":5,"repeats":4,"ms":[0.5,null,0.25]})"
                             "\n";
};

TEST_F(ReadSamples, ReadsBackWhatARunWrites) {
    {
        RunWriter writer(folder / "run", Json::object());
        writer.append_samples({"a", "draw", 2, 5, 4, {0.5, 0.25}});
        writer.append_samples({"b", "quadtree", 0, 0, 1, {}});
    }
    std::vector<RawSamples> read;
    read_samples(folder / "run", [&](const RawSamples& samples) { read.push_back(samples); });
    ASSERT_EQ(read.size(), 2U);
    EXPECT_EQ(read[0].cell, "a");
    EXPECT_EQ(read[0].pass, "draw");
    EXPECT_EQ(read[0].round, 2);
    EXPECT_EQ(read[0].order, 5);
    EXPECT_EQ(read[0].repeats, 4);
    EXPECT_THAT(read[0].ms, ElementsAre(0.5, 0.25));
    EXPECT_EQ(read[1].pass, "quadtree");
    EXPECT_TRUE(read[1].ms.empty());
}

TEST_F(ReadSamples, WhatWasNotFiniteIsLeftOut) {
    write(line);
    read_samples(folder.path(), [](const RawSamples& samples) { EXPECT_THAT(samples.ms, ElementsAre(0.5, 0.25)); });
}

TEST_F(ReadSamples, MediansAreOfRoundsInOrder) {
    write(R"({"cell":"a","pass":"draw","round":1,"order":0,"repeats":1,"ms":[7,9,8]})"
          "\n"
          R"({"cell":"b","pass":"draw","round":0,"order":1,"repeats":1,"ms":[1]})"
          "\n"
          R"({"cell":"a","pass":"draw","round":0,"order":0,"repeats":1,"ms":[1,2]})"
          "\n"
          R"({"cell":"a","pass":"draw","round":2,"order":0,"repeats":1,"ms":[null]})"
          "\n"
          R"({"cell":"a","pass":"map","round":0,"order":0,"repeats":1,"ms":[100]})"
          "\n");
    EXPECT_THAT(read_round_medians(folder.path(), "draw"),
                ElementsAre(Pair("a", ElementsAre(1.5, 8)), Pair("b", ElementsAre(1))));
}

TEST_F(ReadSamples, ThrottledRoundsAreLeftOut) {
    write(R"({"cell":"a","pass":"draw","round":0,"order":0,"repeats":1,"ms":[9],"throttled":true})"
          "\n"
          R"({"cell":"a","pass":"draw","round":1,"order":0,"repeats":1,"ms":[5],"throttled":false})"
          "\n");
    EXPECT_THAT(read_round_medians(folder.path(), "draw"), ElementsAre(Pair("a", ElementsAre(5))));
}

TEST_F(ReadSamples, ReadingIsStrict) {
    const auto message = [&](const std::string& lines) {
        write(lines);
        return error_message([&] { read_samples(folder.path(), [](const RawSamples&) {}); });
    };
    EXPECT_THAT(message(line + line.substr(0, line.size() - 1)), HasSubstr("(line 2): the line is cut short"));
    EXPECT_THAT(message(line + "{}\n"), HasSubstr("(line 2): $: key \"cell\" is missing"));
    EXPECT_THAT(message("words\n"), HasSubstr("samples.jsonl (line 1)"));
    EXPECT_THAT(error_message([&] { read_samples(folder / "missing", [](const RawSamples&) {}); }),
                HasSubstr("samples.jsonl: No such file"));
}

TEST_F(ReadSamples, ARunWithoutSamplesHasNone) {
    write("");
    EXPECT_TRUE(read_round_medians(folder.path(), "draw").empty());
}

}  // namespace
