#include "store/noise_record.hpp"

#include "core/file.hpp"
#include "support/error_message.hpp"
#include "support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>

using namespace reliefbench;

namespace {

namespace fs = std::filesystem;

NoiseRecord record() {
    NoiseRecord record;
    record.machine = {"a device", "a driver", "1.2", "a CPU"};
    record.time = "2026-01-02T03:04:05Z";
    record.configuration = "quick";
    record.cells = {{"a | b", {0.1, 0.2, -1.5}, 0.01, 128}, {"c", {}, std::numeric_limits<double>::infinity(), 0}};
    record.between_runs = {0.055, 5, "measured"};
    return record;
}

/// Sets an environment variable, or unsets it, and puts it back.
class Variable {
public:
    Variable(const char* name, const char* value) : name_(name) {
        const char* before = std::getenv(name);
        was_set_ = before != nullptr;
        if (was_set_) before_ = before;
        value == nullptr ? unsetenv(name) : setenv(name, value, 1);
    }
    ~Variable() { was_set_ ? setenv(name_, before_.c_str(), 1) : unsetenv(name_); }
    Variable(const Variable&) = delete;
    Variable& operator=(const Variable&) = delete;

private:
    const char* name_;
    bool was_set_ = false;
    std::string before_;
};

TEST(NoiseRecord, ReadsBackWhatWasWritten) {
    const TemporaryFolder temporary;
    const fs::path folder = temporary / "new" / "folder";
    write_noise_record(folder, record());
    const auto read = read_noise_record(folder, record().machine);
    ASSERT_TRUE(read.has_value());
    EXPECT_EQ(read->machine, record().machine);
    EXPECT_EQ(read->time, record().time);
    EXPECT_EQ(read->configuration, "quick");
    ASSERT_EQ(read->cells.size(), 2U);
    EXPECT_EQ(read->cells[0].cell, "a | b");
    EXPECT_EQ(read->cells[0].log_median_ms, (std::vector<double>{0.1, 0.2, -1.5}));
    EXPECT_EQ(read->cells[0].visible_paired, 0.01);
    EXPECT_EQ(read->cells[0].rounds, 128U);
    EXPECT_TRUE(std::isinf(read->cells[1].visible_paired));
    EXPECT_EQ(read->between_runs.log_sd, 0.055);
    EXPECT_EQ(read->between_runs.degrees_of_freedom, 5);
    EXPECT_EQ(read->between_runs.source, "measured");
}

TEST(NoiseRecord, EachMachineHasItsOwn) {
    const TemporaryFolder temporary;
    write_noise_record(temporary.path(), record());
    NoiseRecord other = record();
    other.machine.driver_version = "1.3";
    EXPECT_FALSE(read_noise_record(temporary.path(), other.machine).has_value());
    other.between_runs.log_sd = 0.2;
    write_noise_record(temporary.path(), other);
    EXPECT_EQ(read_noise_record(temporary.path(), record().machine)->between_runs.log_sd, 0.055);
    EXPECT_EQ(read_noise_record(temporary.path(), other.machine)->between_runs.log_sd, 0.2);
    EXPECT_FALSE(read_noise_record(temporary / "missing", other.machine).has_value());
}

TEST(NoiseRecord, ANewerOneReplacesIt) {
    const TemporaryFolder temporary;
    write_noise_record(temporary.path(), record());
    NoiseRecord newer = record();
    newer.between_runs.log_sd = 0.3;
    write_noise_record(temporary.path(), newer);
    EXPECT_EQ(read_noise_record(temporary.path(), record().machine)->between_runs.log_sd, 0.3);
    EXPECT_EQ(std::distance(fs::directory_iterator(temporary.path()), fs::directory_iterator()), 1);
}

TEST(NoiseRecord, OneThatCannotBeReadIsAnErrorThatSaysWhatToDo) {
    const TemporaryFolder temporary;
    write_noise_record(temporary.path(), record());
    const fs::path file = fs::directory_iterator(temporary.path())->path();
    const std::string text = read_text_file(file);
    const auto message_with = [&](const std::string& from, const std::string& to) {
        std::string changed = text;
        changed.replace(changed.find(from), from.size(), to);
        write_text_file(file, changed);
        return error_message([&] { read_noise_record(temporary.path(), record().machine); });
    };
    EXPECT_THAT(message_with("0.055", "-1"),
                testing::AllOf(testing::HasSubstr(file.string()), testing::HasSubstr("$.between_runs.log_sd"),
                               testing::HasSubstr("reliefbench selfcheck")));
    EXPECT_THAT(message_with("\"rounds\"", "\"round\""), testing::HasSubstr("unknown key \"round\""));
    EXPECT_THAT(message_with("a CPU", "another CPU"), testing::HasSubstr("of another machine"));
    EXPECT_THAT(message_with("{", ""), testing::HasSubstr("remove the file"));
}

TEST(NoiseRecord, AFolderThatCannotBeMadeIsAnError) {
    EXPECT_THAT(error_message([] { write_noise_record("/proc/self/state", record()); }),
                testing::AllOf(testing::HasSubstr("/proc/self/state"), testing::HasSubstr("RELIEFBENCH_STATE_DIR")));
}

TEST(MachineOf, IsReadFromARunsRecord) {
    Json run;
    run["device"] = {{"name", "a device"}, {"type", "CPU"}, {"driver", "a driver"}, {"driver_version", "1.2"}};
    run["environment"] = {{"cpu", "a CPU"}};
    EXPECT_EQ(machine_of(run), record().machine);
    run["environment"]["cpu"] = nullptr;
    EXPECT_EQ(machine_of(run).cpu, "");
    run.erase("device");
    EXPECT_THAT(error_message([&] { machine_of(run); }), testing::HasSubstr("key \"device\" is missing"));
}

TEST(StateFolder, FollowsTheEnvironment) {
    const Variable home("HOME", "/home/someone");
    const Variable xdg("XDG_STATE_HOME", nullptr);
    const Variable own("RELIEFBENCH_STATE_DIR", nullptr);
    EXPECT_EQ(state_folder(), "/home/someone/.local/state/reliefbench");
    const Variable xdg_set("XDG_STATE_HOME", "/state");
    EXPECT_EQ(state_folder(), "/state/reliefbench");
    const Variable own_set("RELIEFBENCH_STATE_DIR", "/own");
    EXPECT_EQ(state_folder(), "/own");
    const Variable nowhere("HOME", nullptr);
    const Variable no_xdg("XDG_STATE_HOME", nullptr);
    const Variable empty("RELIEFBENCH_STATE_DIR", "");
    EXPECT_THAT(error_message([] { state_folder(); }), testing::HasSubstr("RELIEFBENCH_STATE_DIR"));
}

}  // namespace
