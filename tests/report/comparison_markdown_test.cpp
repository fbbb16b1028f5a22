#include "report/comparison_markdown.hpp"

#include "comparison_sample.hpp"
#include "report/markdown.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

using namespace reliefbench;

namespace {

using testing::HasSubstr;

TEST(Markdown, TextStandsAsItIs) {
    EXPECT_EQ(markdown_text("a_b*c | `d` <e>\n[f] 50 %"), "a\\_b\\*c \\| \\`d\\` \\<e\\> \\[f\\] 50 %");
}

TEST(Markdown, CodeMayHoldBarsAndBackticks) {
    EXPECT_EQ(markdown_code("pom max_steps=16 | heightmap=a"), "`pom max_steps=16 \\| heightmap=a`");
    EXPECT_EQ(markdown_code("a``b"), "``` a``b ```");
}

TEST(ComparisonMarkdown, ShowsWhatChangedAndFoldsTheRest) {
    EXPECT_EQ(
        format_comparison_markdown(sample_comparison()),
        R"(**reliefbench: 5 cells compared: 2 slower, 1 undecided, 1 faster, 1 same; quality: 1 worse, 1 mixed, 0 better, 3 same; 3 not compared, 1 of them failed now**

- the driver changed: Mesa 22.3.6, now Mesa 23.0.0

| time | cell | change | 95 % | visible |
| --- | --- | ---: | ---: | ---: |
| **slower** | `steep \| view_angle=0` | +150 % | +125 to +175 % | 3.1 % |
| **slower** | `steep \| view_angle=60` | +7.2 % | +5.1 to +9.4 % | 3.1 % |
| faster | `relief \| view_angle=60` | −20 % | −25 to −15 % | 3.1 % |

| quality | cell | base → new |
| --- | --- | --- |
| **worse** | `pom \| view_angle=60` | worse by 8.0 %: error.uv\_texels.p99 0.750 → 0.810 texels<br>better by 1.0 % of footprint: error.missed 2.00 → 1.00 % of footprint<br>and 1 more |
| **mixed** | `steep \| view_angle=60` | better by 90 %: error.uv\_texels.p99 0.800 → 0.0800 texels<br>worse by 0.30 % of footprint: error.missed+error.false\_hits 0.200 → 0.500 % of footprint |

| failed now | why |
| --- | --- |
| `mine \| view_angle=60` | ok in the base, failed now: trace.glsl:3: error |

Threshold 2.0 %. Change: of the time, new against base, with its 95 % interval. Visible: the smallest change that this evidence would have shown.

Quality is decided by changes beyond these: error.uv\_texels.p99, error.uv\_texels.mean: 0.05 texels and 5 %; error.missed+error.false\_hits: 0.1 % of footprint; image.footprint.flip: 0.002 and 2 %; error.shadow.mean: 0.005 visibility and 5 %; motion.texels.mean: 0.005 texels and 5 %; motion.flip.mean, motion.ghosting.mean, motion.history\_flip.mean: 0.005 and 5 %.

<details><summary>1 cell undecided</summary>

| cell | change | 95 % | visible | more runs |
| --- | ---: | ---: | ---: | ---: |
| `qdm \| view_angle=60`<br>measured in 4 of 5 base runs only | +3.0 % | −4.0 to +11 % | 3.1 % | 9 |

</details>
<details><summary>1 cell with other changes</summary>

| quality | cell | base → new |
| --- | --- | --- |
| same | `relief \| view_angle=60` | worse by 94 %: work.taps\_mean 17.5 → 34.0 |

</details>
<details><summary>2 cells not compared</summary>

| cell | why |
| --- | --- |
| `flat \| view_angle=60` | only in the base |
| `flat \| view_angle=0` | only in the base |

</details>
<details><summary>what was measured on</summary>

```json
{
  "noise": "default"
}
```

</details>
)");
}

TEST(ComparisonMarkdown, FitsIntoACommentHoweverManyCells) {
    constexpr std::size_t longest_comment = 65536;
    Comparison comparison;
    const std::string view =
        " | heightmap=bricks projection=parallel view_angle=60 height_scale=0.1 resolution=512x512";
    for (int cell = 0; cell < 4000; ++cell) {
        const auto verdict = static_cast<Verdict>(cell % 4);
        comparison.cells.push_back(
            compared("technique max_steps=" + std::to_string(cell) + view, verdict, 1.5, {1.25, 1.75}));
        const QualityChange change = quality_change("error.missed+error.false_hits", 0.01, 0.81, true);
        comparison.cells.back().quality = {QualityVerdict::worse, {change, change, change, change}};
        comparison.uncompared.push_back({"other max_steps=" + std::to_string(cell) + view,
                                         "ok in the base, failed now: out of device memory", cell % 2 == 0});
    }
    const std::string text = format_comparison_markdown(comparison);
    EXPECT_LT(text.size(), longest_comment);
    EXPECT_THAT(text, HasSubstr("\nand 1950 more\n"));  // of 2000 slower and faster ones
}

TEST(ComparisonMarkdown, NothingComparedIsSaid) {
    EXPECT_THAT(format_comparison_markdown({}), testing::StartsWith("**reliefbench: 0 cells compared**\n"));
}

}  // namespace
