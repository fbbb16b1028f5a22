#include "measure/rounds.hpp"

#include "core/error.hpp"
#include "core/random.hpp"
#include "measure/clock.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace reliefbench {
namespace {

using testing::ElementsAre;

class FakeClock : public Clock {
public:
    double seconds() const override { return now_s; }
    double now_s = 0;
};

/// Writes every call into a log that all subjects share; a sample is what the fake clock says a draw took.
class FakeSubject : public Subject {
public:
    FakeSubject(std::string name, double draw_s, FakeClock& clock, std::vector<std::string>& log)
        : name_(std::move(name)), draw_s_(draw_s), clock_(&clock), log_(&log) {}

    void warm_up() override {
        log_->push_back("warm " + name_);
        if (fails_in_warm_up) {
            fail("{} does not start", name_);
        }
    }

    std::map<std::string, std::vector<double>> visit(int count) override {
        log_->push_back("visit " + name_);
        if (++visits_ == failing_visit) {
            fail("{} broke", name_);
        }
        std::vector<double> samples;
        for (int sample = 0; sample < count; ++sample) {
            const double start_s = clock_->seconds();
            clock_->now_s += draw_s_;
            samples.push_back((clock_->seconds() - start_s) * 1000);
        }
        return {{"draw", samples}};
    }

    bool fails_in_warm_up = false;
    int failing_visit = -1;

private:
    std::string name_;
    double draw_s_;
    FakeClock* clock_;
    std::vector<std::string>* log_;
    int visits_ = 0;
};

/// Settles the subject whose samples are `fast_ms` after one round, others after three.
class UnevenRule : public StoppingRule {
public:
    explicit UnevenRule(double fast_ms) : fast_ms_(fast_ms) {}
    bool is_settled(const SampleRounds& samples) const override {
        if (samples.empty()) return false;
        const auto& rounds = samples.at("draw");
        return rounds.size() >= (rounds.front().front() == fast_ms_ ? 1U : 3U);
    }

private:
    double fast_ms_;
};

struct Fixture {
    FakeClock clock;
    std::vector<std::string> log;
    // Powers of two, so that differences of the fake clock are exact.
    FakeSubject a{"a", 0.25, clock, log};
    FakeSubject b{"b", 0.5, clock, log};
    FakeSubject c{"c", 2.0, clock, log};
    std::vector<Subject*> subjects{&a, &b, &c};
    std::vector<Visit> visits;
    std::vector<std::pair<std::size_t, std::string>> failures;

    std::vector<SampleRounds> sample(const StoppingRule& rule, std::uint64_t seed, int samples_per_visit = 2) {
        return sample_in_rounds(
            subjects, rule, samples_per_visit, seed, [this](const Visit& visit) { visits.push_back(visit); },
            [this](std::size_t subject, const std::string& message) { failures.emplace_back(subject, message); });
    }
};

/// The log that the contract asks for: all warm-ups, then rounds over `remaining(round)` shuffled by one seeded
/// sequence.
std::vector<std::string> expected_log(const std::vector<std::vector<std::string>>& rounds, std::uint64_t seed) {
    std::vector<std::string> log{"warm a", "warm b", "warm c"};
    Random random(seed);
    for (std::vector<std::string> round : rounds) {
        random.shuffle(std::span<std::string>(round));
        for (const std::string& name : round) {
            log.push_back("visit " + name);
        }
    }
    return log;
}

TEST(Rounds, WarmUpsComeFirstThenSeededRoundsOverAll) {
    Fixture fixture;
    fixture.sample(*make_fixed_rule(4), 7);
    EXPECT_EQ(fixture.log, expected_log({4, {"a", "b", "c"}}, 7));
}

TEST(Rounds, OrderChangesBetweenRoundsAndBetweenSeeds) {
    std::set<std::vector<std::string>> orders;
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        Fixture fixture;
        fixture.sample(*make_fixed_rule(5), seed);
        for (std::size_t round = 0; round < 5; ++round) {
            const auto first = fixture.log.begin() + 3 + static_cast<std::ptrdiff_t>(round) * 3;
            std::vector<std::string> order(first, first + 3);
            orders.insert(order);
            std::sort(order.begin(), order.end());
            EXPECT_THAT(order, ElementsAre("visit a", "visit b", "visit c"));
        }
    }
    EXPECT_GE(orders.size(), 4U) << "twenty rounds in next to no different orders";
}

TEST(Rounds, SettledSubjectsLeave) {
    Fixture fixture;
    const std::vector<SampleRounds> samples = fixture.sample(UnevenRule(250), 3);
    EXPECT_EQ(fixture.log, expected_log({{"a", "b", "c"}, {"b", "c"}, {"b", "c"}}, 3));
    EXPECT_EQ(samples[0].at("draw").size(), 1U);
    EXPECT_EQ(samples[1].at("draw").size(), 3U);
}

TEST(Rounds, SamplesAreKeptByRoundExactlyAsTaken) {
    Fixture fixture;
    const std::vector<SampleRounds> samples = fixture.sample(*make_fixed_rule(2), 1, 3);
    EXPECT_THAT(samples[0].at("draw"), ElementsAre(ElementsAre(250, 250, 250), ElementsAre(250, 250, 250)));
    EXPECT_THAT(samples[2].at("draw"), ElementsAre(ElementsAre(2000, 2000, 2000), ElementsAre(2000, 2000, 2000)));
}

TEST(Rounds, EveryVisitIsToldAtOnceWithRoundAndOrder) {
    Fixture fixture;
    fixture.sample(*make_fixed_rule(2), 11);
    ASSERT_EQ(fixture.visits.size(), 6U);
    for (std::size_t i = 0; i < fixture.visits.size(); ++i) {
        const Visit& visit = fixture.visits[i];
        EXPECT_EQ(visit.round, static_cast<int>(i) / 3);
        EXPECT_EQ(visit.order, static_cast<int>(i) % 3);
        const std::string name(1, static_cast<char>('a' + visit.subject));
        EXPECT_EQ("visit " + name, fixture.log[3 + i]);
        EXPECT_EQ(visit.samples.at("draw").size(), 2U);
    }
}

TEST(Rounds, AFailingSubjectIsDroppedAndTheOthersGoOn) {
    Fixture fixture;
    fixture.b.failing_visit = 2;
    const std::vector<SampleRounds> samples = fixture.sample(*make_fixed_rule(4), 5);
    EXPECT_EQ(fixture.log, expected_log({{"a", "b", "c"}, {"a", "b", "c"}, {"a", "c"}, {"a", "c"}}, 5));
    EXPECT_THAT(fixture.failures, ElementsAre(std::pair<std::size_t, std::string>(1, "b broke")));
    EXPECT_EQ(samples[0].at("draw").size(), 4U);
    EXPECT_EQ(samples[1].at("draw").size(), 1U);
    EXPECT_EQ(samples[2].at("draw").size(), 4U);
}

TEST(Rounds, ASubjectThatFailsInWarmUpIsNeverVisited) {
    Fixture fixture;
    fixture.a.fails_in_warm_up = true;
    const std::vector<SampleRounds> samples = fixture.sample(*make_fixed_rule(2), 9);
    EXPECT_EQ(fixture.log, expected_log({{"b", "c"}, {"b", "c"}}, 9));
    EXPECT_THAT(fixture.failures, ElementsAre(std::pair<std::size_t, std::string>(0, "a does not start")));
    EXPECT_TRUE(samples[0].empty());
}

TEST(Rounds, AnErrorOfTheCallerEndsTheRun) {
    Fixture fixture;
    const auto full_disk = [](const Visit&) { fail("disk full"); };
    const auto on_failure = [](std::size_t, const std::string&) { FAIL() << "the subject did nothing wrong"; };
    EXPECT_THROW(sample_in_rounds(fixture.subjects, *make_fixed_rule(2), 1, 1, full_disk, on_failure), Error);
}

TEST(FixedRule, NeedsEveryPassInEveryRound) {
    const auto rule = make_fixed_rule(2);
    EXPECT_FALSE(rule->is_settled({}));
    EXPECT_FALSE(rule->is_settled({{"draw", {{1.0}}}}));
    EXPECT_TRUE(rule->is_settled({{"draw", {{1.0}, {1.0}}}}));
    EXPECT_FALSE(rule->is_settled({{"draw", {{1.0}, {1.0}}}, {"shadow", {{1.0}}}}));
}

}  // namespace
}  // namespace reliefbench
