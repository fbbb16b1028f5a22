#include "measure/paired_rounds.hpp"

#include "core/attempt.hpp"
#include "core/error.hpp"
#include "measure/draw_subject.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace reliefbench {
namespace {

using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;

class FakeClock : public Clock {
public:
    double seconds() const override { return now_s; }

    double now_s = 100;
};

/// Tells a common log of each of its visits.
class FakeSubject : public Subject {
public:
    FakeSubject(std::string name, std::vector<std::string>& log, FakeClock& clock, std::vector<double> milliseconds)
        : name_(std::move(name)), log_(log), clock_(clock), milliseconds_(std::move(milliseconds)) {}

    void warm_up() override {
        clock_.now_s += 1;
        if (fails_to_warm_up) fail("cold");
    }

    std::map<std::string, std::vector<double>> visit(int count) override {
        clock_.now_s += 1;
        log_.push_back(name_);
        if (fails_at_visit > 0 && ++visits_ == fails_at_visit) fail("lost");
        if (exhausts_memory) throw std::bad_alloc();
        EXPECT_EQ(count, static_cast<int>(milliseconds_.size()));
        return {{draw_pass, milliseconds_}};
    }

    bool fails_to_warm_up = false;
    int fails_at_visit = 0;
    bool exhausts_memory = false;

private:
    std::string name_;
    std::vector<std::string>& log_;
    FakeClock& clock_;
    std::vector<double> milliseconds_;
    int visits_ = 0;
};

/// Pairs named by letters: "a" the base of the first, "A" its changed side.
class PairedRounds : public testing::Test {
protected:
    FakeSubject& add(std::vector<double> base_ms, std::vector<double> changed_ms) {
        const char letter = static_cast<char>('a' + pairs_.size());
        const char capital = static_cast<char>('A' + pairs_.size());
        subjects_.push_back(std::make_unique<FakeSubject>(std::string(1, letter), log_, clock_, std::move(base_ms)));
        Subject* const base = subjects_.back().get();
        subjects_.push_back(
            std::make_unique<FakeSubject>(std::string(1, capital), log_, clock_, std::move(changed_ms)));
        pairs_.push_back({base, subjects_.back().get()});
        return *subjects_.back();
    }

    std::vector<LogRatios> sample_rounds(std::size_t rounds, int samples = 1, std::uint64_t seed = 1) {
        return sample({samples, 1e9, seed},
                      [rounds](std::size_t, const LogRatios& values) { return values.size() >= rounds; });
    }

    std::vector<LogRatios> sample(const PairSampling& sampling, PairIsDecided is_decided) {
        return sample_pairs(pairs_, sampling,
                            {std::move(is_decided),
                             [this](std::size_t pair, const std::string& reason) { failures_[pair] = reason; },
                             {},
                             [this](const PairVisit& visit) { visits_.push_back(visit); }},
                            clock_);
    }

    FakeClock clock_;
    std::vector<std::string> log_;
    std::vector<std::unique_ptr<FakeSubject>> subjects_;
    std::vector<SubjectPair> pairs_;
    std::map<std::size_t, std::string> failures_;
    std::vector<PairVisit> visits_;
};

std::string lower(std::string text) {
    for (char& c : text) {
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    }
    return text;
}

TEST_F(PairedRounds, TheRatioIsChangedToBaseWhicheverCameFirst) {
    add({2}, {3});
    const auto log_ratios = sample_rounds(20);
    ASSERT_EQ(log_ratios.at(0).size(), 20U);
    EXPECT_THAT(log_ratios[0], Each(testing::DoubleEq(std::log(1.5))));
    EXPECT_NE(log_.at(0), log_.at(1));
}

TEST_F(PairedRounds, TheLowerQuartileOfAVisitCounts) {
    add({9, 1, 2, 50, 70}, {70, 4, 1, 9, 50});
    EXPECT_THAT(sample_rounds(1, 5).at(0), ElementsAre(testing::DoubleEq(std::log(4.0 / 2))));
}

TEST_F(PairedRounds, EachVisitIsToldWithAllItsSamples) {
    add({2, 3}, {5, 7});
    sample_rounds(3, 2);
    ASSERT_EQ(visits_.size(), 3U);
    for (std::size_t round = 0; round < 3; ++round) {
        EXPECT_EQ(visits_[round].round, round);
        EXPECT_EQ(visits_[round].base_first, log_[2 * round] == "a");
        EXPECT_THAT(visits_[round].base_ms, ElementsAre(2, 3));
        EXPECT_THAT(visits_[round].changed_ms, ElementsAre(5, 7));
    }
}

TEST_F(PairedRounds, BothSidesAreVisitedOneDirectlyAfterTheOther) {
    for (int pair = 0; pair < 5; ++pair) {
        add({1}, {1});
    }
    sample_rounds(10);
    ASSERT_EQ(log_.size(), 100U);
    for (std::size_t visit = 0; visit < log_.size(); visit += 2) {
        EXPECT_NE(log_[visit], log_[visit + 1]);
        EXPECT_EQ(lower(log_[visit]), lower(log_[visit + 1]));
    }
}

TEST_F(PairedRounds, EachSideComesFirstInOneOfTwoRounds) {
    add({1}, {1});
    sample_rounds(40);
    std::size_t base_first_in_even_rounds = 0;
    for (std::size_t round = 0; round < 40; round += 2) {
        EXPECT_NE(log_[2 * round], log_[2 * (round + 1)]) << "round " << round;
        base_first_in_even_rounds += log_[2 * round] == "a" ? 1 : 0;
    }
    // A fixed alternation would have 0 or 20.
    EXPECT_GT(base_first_in_even_rounds, 3U);
    EXPECT_LT(base_first_in_even_rounds, 17U);
}

TEST_F(PairedRounds, PairsAreVisitedInANewOrderEachRoundAndTheSeedGivesIt) {
    for (int pair = 0; pair < 6; ++pair) {
        add({1}, {1});
    }
    sample_rounds(4, 1, 7);
    const std::vector<std::string> first = log_;
    std::vector<std::string> rounds(4);
    for (std::size_t visit = 0; visit < first.size(); visit += 2) {
        rounds[visit / 12] += lower(first[visit]);
    }
    EXPECT_NE(rounds[0], rounds[1]);
    EXPECT_NE(rounds[1], rounds[2]);
    log_.clear();
    sample_rounds(4, 1, 7);
    EXPECT_EQ(log_, first);
    log_.clear();
    sample_rounds(4, 1, 8);
    EXPECT_NE(log_, first);
}

TEST_F(PairedRounds, DecidedPairsLeave) {
    add({1}, {1});
    add({1}, {1});
    const auto log_ratios = sample(
        {1, 1e9, 1}, [](std::size_t pair, const LogRatios& values) { return values.size() >= (pair == 0 ? 2U : 5U); });
    EXPECT_EQ(log_ratios.at(0).size(), 2U);
    EXPECT_EQ(log_ratios.at(1).size(), 5U);
}

TEST_F(PairedRounds, TheBudgetEndsIt) {
    add({1}, {1});
    add({1}, {1});
    // A second for each of 4 warm-ups and 4 visits a round; a round that has begun is finished.
    const auto log_ratios = sample({1, 13, 1}, [](std::size_t, const LogRatios&) { return false; });
    EXPECT_EQ(log_ratios.at(0).size(), 3U);
    EXPECT_EQ(log_ratios.at(1).size(), 3U);
}

TEST_F(PairedRounds, ABudgetSpentByWarmingUpLeavesNoRounds) {
    add({1}, {1});
    EXPECT_TRUE(sample({1, 2, 1}, [](std::size_t, const LogRatios&) { return false; }).at(0).empty());
}

TEST_F(PairedRounds, ASideThatFailsDropsItsPairAndNoOther) {
    add({1}, {1}).fails_at_visit = 3;
    add({1}, {1});
    add({1}, {1}).fails_to_warm_up = true;
    const auto log_ratios = sample_rounds(6);
    EXPECT_EQ(log_ratios.at(0).size(), 2U);
    EXPECT_EQ(log_ratios.at(1).size(), 6U);
    EXPECT_TRUE(log_ratios.at(2).empty());
    EXPECT_EQ(failures_.size(), 2U);
    EXPECT_THAT(failures_[0], HasSubstr("lost"));
    EXPECT_THAT(failures_[2], HasSubstr("cold"));
    EXPECT_EQ(std::count(log_.begin(), log_.end(), "c"), 0);
}

TEST_F(PairedRounds, AnAllocationThatFailsDropsItsPairAndNoOther) {
    add({1}, {1}).exhausts_memory = true;
    add({1}, {1});
    const auto log_ratios = sample_rounds(3);
    EXPECT_EQ(failures_[0], memory_used_up);
    EXPECT_EQ(log_ratios.at(1).size(), 3U);
}

TEST_F(PairedRounds, ADrawThatTheClockDoesNotSeeFailsItsPair) {
    add({0}, {1});
    EXPECT_TRUE(sample_rounds(3).at(0).empty());
    EXPECT_THAT(failures_[0], HasSubstr("clock"));
}

TEST_F(PairedRounds, NoPairsEndAtOnce) {
    EXPECT_TRUE(sample_rounds(3).empty());
}

}  // namespace
}  // namespace reliefbench
