#include "cli/exit_code.hpp"
#include "cli/progress_printer.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace reliefbench {
namespace {

TEST(ExitCode, TheGraverOfTwoIsReported) {
    // docs/architecture.md: where several apply, 5, 2, 4, 1, 3, 0.
    const std::vector<int> worst_first{5, 2, 4, 1, 3, 0};
    for (std::size_t first = 0; first < worst_first.size(); ++first) {
        for (std::size_t second = 0; second < worst_first.size(); ++second) {
            const ExitCode code =
                worse_of(static_cast<ExitCode>(worst_first[first]), static_cast<ExitCode>(worst_first[second]));
            EXPECT_EQ(static_cast<int>(code), worst_first[std::min(first, second)]);
        }
    }
}

TEST(Progress, DurationsReadAsAClockDoes) {
    EXPECT_EQ(format_duration(7.4), "0:07");
    EXPECT_EQ(format_duration(59.6), "1:00");
    EXPECT_EQ(format_duration(750), "12:30");
    EXPECT_EQ(format_duration(7205), "2:00:05");
}

TEST(Progress, ALineTellsCellsShareAndTimeLeft) {
    Progress progress;
    progress.cells_done = 12;
    progress.cells_total = 160;
    progress.current = "some cell";
    EXPECT_EQ(format_progress(progress), "[ 12/160] 0:00 elapsed: some cell");
    progress.elapsed_s = 10;
    progress.remaining_s = 30;
    progress.share = 0.25;
    EXPECT_EQ(format_progress(progress), "[ 12/160]  25 %, 0:10 elapsed, 0:30 left: some cell");
    progress.stage = "preparing 3 of 64";
    EXPECT_EQ(format_progress(progress), "[ 12/160]  25 %, 0:10 elapsed, 0:30 left: preparing 3 of 64: some cell");
}

}  // namespace
}  // namespace reliefbench
