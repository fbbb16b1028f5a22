#include "store/run_folder.hpp"

#include "core/file.hpp"
#include "support/error_message.hpp"
#include "support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <csignal>
#include <fstream>
#include <set>

using namespace reliefbench;

namespace {

namespace fs = std::filesystem;

CellResult result_of(const std::string& cell) {
    CellResult result;
    result.cell = cell;
    result.technique = "pom";
    result.time["draw"] = {0.5, 0.01, {0.4, 0.6}, 15, 1};
    return result;
}

class RunFolder : public testing::Test {
protected:
    const TemporaryFolder temporary;
    const fs::path parent = temporary.path();
    const fs::path folder = parent / "results" / "run";
    const Json record = {{"configuration", {{"name", "quick"}}}};
};

/// Files may grow to `bytes` and no further while it lives: what a full disk does, without one.
class FileSizeLimit {
public:
    explicit FileSizeLimit(rlim_t bytes) : previous_handler_(std::signal(SIGXFSZ, SIG_IGN)) {
        getrlimit(RLIMIT_FSIZE, &previous_);
        const rlimit limit{bytes, previous_.rlim_max};
        setrlimit(RLIMIT_FSIZE, &limit);
    }
    ~FileSizeLimit() {
        setrlimit(RLIMIT_FSIZE, &previous_);
        std::signal(SIGXFSZ, previous_handler_);
    }

private:
    rlimit previous_{};
    void (*previous_handler_)(int);
};

TEST_F(RunFolder, ReadsBackWhatWasWritten) {
    {
        RunWriter writer(folder, record);
        writer.append_cell(result_of("a"));
        writer.append_cell(result_of("b"));
    }
    const reliefbench::Run run = read_run(folder);  // testing::Test has a Run of its own
    EXPECT_EQ(run.run, record);
    ASSERT_EQ(run.cells.size(), 2U);
    EXPECT_EQ(run.cells[0].cell, "a");
    EXPECT_EQ(to_json(run.cells[1]), to_json(result_of("b")));
}

TEST_F(RunFolder, LinesAreThereAsSoonAsTheyAreAppended) {
    RunWriter writer(folder, record);
    writer.append_cell(result_of("a"));
    EXPECT_EQ(read_text_file(folder / "cells.jsonl"), to_json(result_of("a")).dump() + "\n");
    writer.append_samples({"a", "draw", 2, 5, 4, {0.5, 0.25}});
    EXPECT_EQ(read_text_file(folder / "samples.jsonl"),
              R"({"cell":"a","pass":"draw","round":2,"order":5,"repeats":4,"ms":[0.5,0.25]})"
              "\n");
    writer.append_round({.block = 1, .round = 2, .seconds = 0.5, .clock_mhz = 1980, .throttled = true});
    EXPECT_EQ(read_text_file(folder / "rounds.jsonl"),
              R"({"block":1,"round":2,"seconds":0.5,"clock_mhz":1980.0,"memory_clock_mhz":null,"temperature_c":null,)"
              R"("throttled":true})"
              "\n");
}

TEST_F(RunFolder, SamplesThatDoNotCountAreMarked) {
    RunWriter writer(folder, record);
    writer.append_samples({"a", "draw", 2, 5, 4, {0.5}, true});
    EXPECT_EQ(read_text_file(folder / "samples.jsonl"),
              R"({"cell":"a","pass":"draw","round":2,"order":5,"repeats":4,"ms":[0.5],"throttled":true})"
              "\n");
}

TEST_F(RunFolder, TheSummaryComesAtTheEnd) {
    RunWriter writer(folder, record);
    EXPECT_FALSE(fs::exists(folder / "summary.json"));
    writer.write_summary({{"total_s", 1.5}});
    EXPECT_EQ(read_json_file(folder / "summary.json"), Json({{"total_s", 1.5}}));
}

TEST_F(RunFolder, ARunIsNeverOverwritten) {
    { RunWriter(folder, record).append_cell(result_of("a")); }
    const std::string message = error_message([&] { RunWriter(folder, Json::object()); });
    EXPECT_THAT(message, testing::AllOf(testing::HasSubstr(folder.string()), testing::HasSubstr("already holds a run"),
                                        testing::HasSubstr("choose another folder")));
    EXPECT_EQ(read_run(folder).run, record);
    EXPECT_EQ(read_run(folder).cells.size(), 1U);
}

TEST_F(RunFolder, ResultsWithoutARecordAreNotOverwrittenEither) {
    fs::create_directories(folder);
    write_text_file(folder / "cells.jsonl", "precious\n");
    EXPECT_THAT(error_message([&] { RunWriter(folder, record); }),
                testing::HasSubstr("already holds a run (cells.jsonl)"));
    EXPECT_EQ(read_text_file(folder / "cells.jsonl"), "precious\n");
    EXPECT_FALSE(fs::exists(folder / "run.json"));
}

TEST_F(RunFolder, AFolderThatCannotBeMadeIsAnError) {
    write_text_file(parent / "file", "");
    EXPECT_THAT(error_message([&] { RunWriter(parent / "file" / "run", record); }),
                testing::AllOf(testing::HasSubstr((parent / "file" / "run").string()),
                               testing::HasSubstr("Not a directory"), testing::HasSubstr("choose another folder")));
    EXPECT_THAT(error_message([&] { RunWriter(parent / "file", record); }), testing::HasSubstr("Not a directory"));
}

TEST_F(RunFolder, AFolderThatCannotBeWrittenIsAnError) {
    // Not even root may make files in /proc.
    EXPECT_THAT(error_message([&] { RunWriter("/proc/self/run", record); }),
                testing::HasSubstr("cannot create the folder"));
    EXPECT_THAT(error_message([&] { RunWriter("/proc/self", record); }), testing::HasSubstr("cannot create"));
}

TEST_F(RunFolder, AFullDiskLeavesWholeLinesAndAnError) {
    RunWriter writer(folder, record);
    writer.append_cell(result_of("a"));
    writer.append_cell(result_of("b"));
    const auto before = fs::file_size(folder / "cells.jsonl");
    {
        const FileSizeLimit limit(before + 20);  // the third line starts but does not fit
        EXPECT_THAT(error_message([&] { writer.append_cell(result_of("c")); }),
                    testing::AllOf(testing::HasSubstr("cells.jsonl"), testing::HasSubstr("File too large"),
                                   testing::HasSubstr("make room")));
    }
    EXPECT_EQ(fs::file_size(folder / "cells.jsonl"), before);
    EXPECT_EQ(read_run(folder).cells.size(), 2U);
    writer.append_cell(result_of("d"));
    EXPECT_EQ(read_run(folder).cells.size(), 3U);
}

TEST_F(RunFolder, ARunThatCannotBeginLeavesNothing) {
    const FileSizeLimit limit(4);  // run.json does not fit
    EXPECT_THAT(error_message([&] { RunWriter(folder, record); }), testing::HasSubstr("run.json"));
    EXPECT_FALSE(fs::exists(folder));
}

TEST_F(RunFolder, GoesOnAfterTheLastWholeLine) {
    { RunWriter(folder, record).append_cell(result_of("a")); }
    std::ofstream(folder / "cells.jsonl", std::ios::app) << R"({"cell":"b","techni)";
    fs::remove(folder / "rounds.jsonl");
    const Json resumed = {{"configuration", {{"name", "quick"}}}, {"resumed", Json::array({1})}};
    {
        RunWriter writer(folder, resumed, RunWriter::Continue{});
        EXPECT_THAT(writer.repairs(),
                    testing::ElementsAre("cells.jsonl: the last line was cut short after 19 bytes and is taken out"));
        writer.append_cell(result_of("b"));
        writer.append_round({});
    }
    const reliefbench::Run run = read_run(folder);
    EXPECT_EQ(run.run, resumed);
    ASSERT_EQ(run.cells.size(), 2U);
    EXPECT_EQ(run.cells[1].cell, "b");
}

TEST_F(RunFolder, AFileWithoutAnyWholeLineIsEmptied) {
    { RunWriter writer(folder, record); }
    write_text_file(folder / "samples.jsonl", std::string(200000, 'x'));
    RunWriter writer(folder, record, RunWriter::Continue{});
    EXPECT_EQ(fs::file_size(folder / "samples.jsonl"), 0U);
}

TEST_F(RunFolder, OnlyOneProcessWritesToARun) {
    const RunWriter writer(folder, record);
    EXPECT_THAT(error_message([&] { RunWriter(folder, record, RunWriter::Continue{}); }),
                testing::HasSubstr("is being written by another process"));
}

TEST_F(RunFolder, WhatNeverBeganIsRemoved) {
    fs::create_directories(folder);
    write_text_file(folder / "cells.jsonl", "");
    EXPECT_FALSE(holds_run(folder));
    remove_unstarted_run(folder);
    EXPECT_FALSE(fs::exists(folder / "cells.jsonl"));
    write_text_file(folder / "cells.jsonl", "precious\n");
    remove_unstarted_run(folder);
    EXPECT_TRUE(fs::exists(folder / "cells.jsonl"));
    write_text_file(folder / "samples.jsonl", "");
    write_text_file(folder / "run.json", "{}");
    EXPECT_TRUE(holds_run(folder));
    remove_unstarted_run(folder);
    EXPECT_TRUE(fs::exists(folder / "samples.jsonl"));
}

TEST_F(RunFolder, ImagesAreNamedAfterTheirCells) {
    RunWriter writer(folder, record);
    EXPECT_FALSE(fs::exists(folder / "images"));
    EXPECT_EQ(writer.image_path("pom max_steps=16 | heightmap=bricks view_angle=60", ".png"),
              folder / "images" / "pom+max_steps=16@heightmap=bricks+view_angle=60.png");
    EXPECT_TRUE(fs::is_directory(folder / "images"));
}

TEST_F(RunFolder, ImagesOfDifferentCellsHaveDifferentNamesThatFilesCanHave) {
    RunWriter writer(folder, record);
    const std::string lengthy(400, 'x');
    std::set<fs::path> paths;
    const std::vector<std::string> cells = {"a | b=c/d", "a | b=c:d", "a | b=c_d", "a | b=c d",   "a b | c",
                                            "a+b | c",   "a@b | c",   "a b@c",     lengthy + "1", lengthy + "2"};
    for (const std::string& cell : cells) {
        const fs::path path = writer.image_path(cell, ".error.png");
        std::ofstream(path) << "picture";
        EXPECT_TRUE(fs::exists(path)) << path;
        EXPECT_EQ(path.parent_path(), folder / "images");
        paths.insert(path);
    }
    EXPECT_EQ(paths.size(), cells.size());
}

class ReadRun : public RunFolder {
protected:
    void write_cells(const std::string& text) const {
        fs::create_directories(folder);
        write_text_file(folder / "run.json", "{}");
        write_text_file(folder / "cells.jsonl", text);
    }
    std::string message_with_cells(const std::string& text) const {
        write_cells(text);
        return error_message([&] { read_run(folder); });
    }
    const std::string line = to_json(result_of("a")).dump() + "\n";
};

TEST_F(ReadRun, ALineThatIsCutShortIsAnError) {
    write_cells(line);
    EXPECT_NO_THROW(read_run(folder));
    EXPECT_THAT(message_with_cells(line + line.substr(0, 30)),
                testing::AllOf(testing::HasSubstr("cells.jsonl (line 2)"), testing::HasSubstr("cut short")));
}

TEST_F(ReadRun, ALineThatIsNoResultIsAnError) {
    EXPECT_THAT(message_with_cells(line + "{\"cell\": \"b\"}\n"),
                testing::AllOf(testing::HasSubstr("cells.jsonl (line 2)"), testing::HasSubstr("is missing")));
    EXPECT_THAT(message_with_cells("\n"), testing::HasSubstr("cells.jsonl (line 1)"));
}

TEST_F(ReadRun, ACellTwiceIsAnError) {
    EXPECT_THAT(message_with_cells(line + line),
                testing::AllOf(testing::HasSubstr("(line 2)"), testing::HasSubstr("'a' stands here for the second")));
}

TEST_F(ReadRun, AFolderWithoutARunIsAnError) {
    EXPECT_THAT(error_message([&] { read_run(parent); }), testing::HasSubstr("holds no run"));
    EXPECT_THAT(error_message([&] { read_run(parent / "missing"); }), testing::HasSubstr("holds no run"));
}

}  // namespace
