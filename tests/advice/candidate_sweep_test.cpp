#include "advice/candidate_sweep.hpp"

#include "sweep/configuration.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace reliefbench {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

Parameter integer(const std::string& name, std::int64_t value, double minimum, double maximum) {
    return {.name = name,
            .type = ParameterType::integer,
            .default_value = value,
            .minimum = minimum,
            .maximum = maximum,
            .choices = {},
            .help = "a number",
            .published = {}};
}

/// One technique with a ladder, an adaptive minimum and a preset, and one that has none of them.
std::vector<Manifest> manifests() {
    Manifest march;
    march.id = "march";
    march.parameters = {integer("steps", 32, 1, 100), integer("fewest", 8, 1, 100)};
    march.sample_count = "steps";
    march.sample_count_minimum = "fewest";
    march.presets = {{.name = "engine",
                      .title = "An engine",
                      .source = "seen",
                      .parameters = {{"steps", std::int64_t{10}}},
                      .not_expressed = ""}};
    Manifest lone;
    lone.id = "lone";
    return {march, lone};
}

SweepQuestion question() {
    return {.map = "bricks", .albedo = "", .view_angles = {60, 75}, .resolution = "64x32", .height_scale = 0.08};
}

std::vector<Cell> cells_of(const std::vector<Manifest>& techniques) {
    const Json json = candidate_configuration(question(), techniques);
    return expand(parse_configuration(json, "advice.json", {}, techniques), techniques);
}

TEST(SampleLadder, HasTheDefaultAndHalfOctavesAroundItWithinTheRange) {
    EXPECT_THAT(sample_ladder(manifests().front()), ElementsAre(4, 6, 8, 11, 16, 23, 32, 45, 64, 91));
    Manifest few = manifests().front();
    few.parameters.front() = integer("steps", 4, 1, 6);
    EXPECT_THAT(sample_ladder(few), ElementsAre(1, 2, 3, 4, 6));
    EXPECT_THAT(sample_ladder(manifests().back()), IsEmpty());
}

TEST(CandidateConfiguration, HasEachTechniqueAlongItsLadderAndEachPresetInEachView) {
    const std::vector<Cell> cells = cells_of(manifests());
    std::set<std::string> settings;
    for (const Cell& cell : cells)
        settings.insert(cell.id.substr(0, cell.id.find(" | ")));
    EXPECT_EQ(settings.size(), 12U);
    EXPECT_TRUE(settings.contains("march steps=16 fewest=4"));
    EXPECT_TRUE(settings.contains("march"));
    EXPECT_TRUE(settings.contains("march preset=engine"));
    EXPECT_TRUE(settings.contains("lone"));
    EXPECT_EQ(cells.size(), 12U * 6U);
    EXPECT_EQ(cells.front().view.view.relief.height_scale, 0.08);
    for (const Cell& cell : cells) {
        const double azimuth = std::abs(cell.view.view.camera.azimuth);
        EXPECT_GT(std::fmod(azimuth, 45), 5) << azimuth;
        EXPECT_LT(std::fmod(azimuth, 45), 40) << azimuth;
    }
}

TEST(CandidateSweep, TiesSettingsThatDifferInTheSampleCountAloneAndLeavesPresetsApart) {
    const std::vector<Manifest> techniques = manifests();
    const std::vector<Cell> cells = cells_of(techniques);
    const CandidateSweep sweep = candidate_sweep(cells, techniques);
    ASSERT_EQ(sweep.settings.size(), 12U);
    std::set<std::size_t> ladders;
    std::size_t wanted = 0;
    for (const SweptSetting& setting : sweep.settings) {
        ladders.insert(setting.ladder);
        wanted += setting.is_wanted ? 1 : 0;
        ASSERT_EQ(setting.cells.size(), 6U);
        for (const std::optional<std::size_t>& cell : setting.cells)
            EXPECT_EQ(cells[cell.value()].technique, setting.technique);
    }
    EXPECT_EQ(ladders.size(), 3U);
    EXPECT_EQ(wanted, 1U);
    EXPECT_THAT(sweep.contests, ElementsAre(ElementsAre(0, 1, 2), ElementsAre(3, 4, 5), ElementsAre(0, 1, 2, 3, 4, 5)));
}

TEST(CandidateSweep, OneKindOfViewIsOneContest) {
    std::vector<Cell> cells = cells_of(manifests());
    std::erase_if(cells, [](const Cell& cell) { return cell.view.view.camera.view_angle != 60; });
    EXPECT_THAT(candidate_sweep(cells, manifests()).contests, ElementsAre(ElementsAre(0, 1, 2)));
}

}  // namespace
}  // namespace reliefbench
