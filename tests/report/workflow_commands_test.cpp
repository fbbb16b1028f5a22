#include "report/workflow_commands.hpp"

#include "comparison_sample.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

using namespace reliefbench;

namespace {

using testing::HasSubstr;

TEST(WorkflowCommands, EscapeWhatEndsThem) {
    EXPECT_EQ(workflow_command(Annotation::error, "50 %, a: b", "50 %, a: b\r\nc"),
              "::error title=50 %25%2C a%3A b::50 %25, a: b%0D%0Ac\n");
    EXPECT_EQ(workflow_command(Annotation::warning, "t", "::set-output name=a::b"),
              "::warning title=t::::set-output name=a::b\n");
}

TEST(WorkflowCommands, OneForEachVerdictThatMattersAndASummary) {
    EXPECT_EQ(
        format_workflow_commands(sample_comparison()),
        R"(::error title=slower +150 %25::steep | view_angle=0%0Aslower by 150 %25 (95 %25: 125 to 175 %25), 5 runs a side
::error title=slower +7.2 %25::steep | view_angle=60%0Aslower by 7.2 %25 (95 %25: 5.1 to 9.4 %25), 5 runs a side
::error title=worse quality::pom | view_angle=60%0Aworse by 8.0 %25: error.uv_texels.p99 0.750 → 0.810 texels, better by 1.0 %25 of footprint: error.missed 2.00 → 1.00 %25 of footprint, and 1 more
::error title=mixed quality::steep | view_angle=60%0Abetter by 90 %25: error.uv_texels.p99 0.800 → 0.0800 texels, worse by 0.30 %25 of footprint: error.missed+error.false_hits 0.200 → 0.500 %25 of footprint
::error title=failed now::mine | view_angle=60%0Aok in the base, failed now: trace.glsl:3: error
::warning title=not compared::2 cells: only in the base
::warning title=undecided::qdm | view_angle=60%0Aundecided: +3.0 %25 (−4.0 to +11 %25), 5 runs a side; changes above 3.1 %25 would have been seen; about 9 more runs a side would decide; measured in 4 of 5 base runs only
::notice title=reliefbench::5 cells compared: 2 slower, 1 undecided, 1 faster, 1 same; quality: 1 worse, 1 mixed, 0 better, 3 same; 3 not compared, 1 of them failed now
::notice title=notes::the driver changed: Mesa 22.3.6, now Mesa 23.0.0
::notice title=faster −20 %25::relief | view_angle=60%0Afaster by 20 %25 (95 %25: 15 to 25 %25), 5 runs a side
)");
}

TEST(WorkflowCommands, NoMoreOfAKindThanGitHubShows) {
    Comparison comparison;
    for (int cell = 0; cell < 12; ++cell) {
        comparison.cells.push_back(
            compared("cell" + std::to_string(cell), Verdict::slower, 2 - cell * 0.01, {1.5, 2.5}));
    }
    const std::string text = format_workflow_commands(comparison);
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 11);  // ten errors and the summary
    EXPECT_THAT(text, HasSubstr("::error title=3 more::slower +91 %25: cell9%0Aslower +90 %25: cell10%0A"
                                "slower +89 %25: cell11\n"));
    comparison.cells.resize(10);
    EXPECT_THAT(format_workflow_commands(comparison), testing::Not(HasSubstr(" more::")));
}

TEST(WorkflowCommands, NothingComparedIsSaid) {
    EXPECT_EQ(format_workflow_commands({}), "::notice title=reliefbench::0 cells compared\n");
}

}  // namespace
