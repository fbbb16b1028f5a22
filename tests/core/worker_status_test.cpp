#include "core/worker_status.hpp"

#include "core/error.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <string>
#include <thread>

namespace reliefbench {
namespace {

void wait_beyond(double seconds) {
    std::this_thread::sleep_for(std::chrono::duration<double>(seconds + 0.02));
}

TEST(WorkerStatus, WhatTheWorkerTellsTheSupervisorKnowsAndTheOtherWayRound) {
    WorkerStatus supervisor(10);
    const auto worker = WorkerStatus::of_supervisor(dup(supervisor.descriptor()));
    worker->set_folder("results/mine");
    worker->begin_cell("pom | view_angle=60");
    worker->begin_maps("0123456789abcdef");
    worker->end(WorkerStatus::Ending::device_lost);
    EXPECT_EQ(supervisor.folder(), "results/mine");
    EXPECT_EQ(supervisor.cell(), "pom | view_angle=60");
    EXPECT_EQ(supervisor.maps(), "0123456789abcdef");
    EXPECT_EQ(supervisor.ending(), WorkerStatus::Ending::device_lost);
    EXPECT_FALSE(worker->is_interrupted());
    supervisor.interrupt();
    EXPECT_TRUE(worker->is_interrupted());
}

TEST(WorkerStatus, TheNextWorkerStartsAfreshInTheSameFolder) {
    WorkerStatus status(10);
    status.set_folder("results/mine");
    status.begin_cell("a");
    status.begin_maps("m");
    status.end(WorkerStatus::Ending::finished);
    status.clear();
    EXPECT_EQ(status.cell(), "");
    EXPECT_EQ(status.maps(), "");
    EXPECT_EQ(status.ending(), WorkerStatus::Ending::unsaid);
    EXPECT_EQ(status.folder(), "results/mine");
}

TEST(WorkerStatus, PassesAreOverdueWhenTheyTakeLongerThanTheyMayEach) {
    constexpr double pass_timeout_s = 0.2;
    WorkerStatus status(pass_timeout_s);
    EXPECT_FALSE(status.is_overdue());
    status.begin_passes(1);
    EXPECT_FALSE(status.is_overdue());
    wait_beyond(pass_timeout_s);
    EXPECT_TRUE(status.is_overdue());
    status.end_passes();
    EXPECT_FALSE(status.is_overdue());
    status.begin_passes(1000);
    wait_beyond(pass_timeout_s);
    EXPECT_FALSE(status.is_overdue());
}

TEST(WorkerStatus, ASecondSubmissionHasItsTimeFromTheEndOfTheFirst) {
    constexpr double pass_timeout_s = 0.2;
    WorkerStatus status(pass_timeout_s);
    status.begin_passes(1000);
    status.begin_passes(1);
    wait_beyond(pass_timeout_s);
    EXPECT_FALSE(status.is_overdue());
    status.end_passes();
    EXPECT_FALSE(status.is_overdue());
    wait_beyond(pass_timeout_s);
    EXPECT_TRUE(status.is_overdue());
}

TEST(WorkerStatus, AnIdTooLongIsCutAndAFolderTooLongRefused) {
    WorkerStatus status(10);
    status.begin_cell(std::string(100000, 'x'));
    EXPECT_EQ(status.cell(), std::string(16384, 'x'));
    EXPECT_THROW(status.set_folder(std::string(5000, 'x')), Error);
}

TEST(WorkerStatus, AnyOtherDescriptorIsRefused) {
    EXPECT_THROW(WorkerStatus::of_supervisor(STDIN_FILENO), Error);
}

}  // namespace
}  // namespace reliefbench
