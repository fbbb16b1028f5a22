#include "measure/rounds.hpp"

#include "core/attempt.hpp"
#include "core/error.hpp"
#include "core/random.hpp"
#include "measure/clock.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
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
        if (exhausts_memory) throw std::bad_alloc();
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
    bool exhausts_memory = false;

private:
    std::string name_;
    double draw_s_;
    FakeClock* clock_;
    std::vector<std::string>* log_;
    int visits_ = 0;
};

/// Stops the subject whose samples are `fast_ms` after one round, others after three.
class UnevenRule : public StoppingRule {
public:
    explicit UnevenRule(double fast_ms) : fast_ms_(fast_ms) {}
    std::optional<StopReason> stop(const SampleRounds& samples, double /*device_s*/) const override {
        if (samples.empty()) return std::nullopt;
        const auto& rounds = samples.at("draw");
        if (rounds.size() < (rounds.front().front() == fast_ms_ ? 1U : 3U)) return std::nullopt;
        return StopReason::precise;
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

    std::vector<std::pair<std::size_t, StopReason>> stops;
    std::vector<int> rounds_told;
    /// By call.
    std::vector<bool> throttled;
    std::size_t throttle_calls = 0;
    /// So many visits.
    std::optional<std::size_t> interrupted_after;

    std::vector<SampledSubject> sample(const StoppingRule& rule, std::uint64_t seed, int samples_per_visit = 2,
                                       std::size_t in_flight = 1) {
        RoundCallbacks callbacks;
        callbacks.on_visit = [this](const Visit& visit) { visits.push_back(visit); };
        callbacks.on_failure = [this](std::size_t subject, const std::string& message) {
            failures.emplace_back(subject, message);
        };
        callbacks.on_stop = [this](std::size_t subject, StopReason reason) { stops.emplace_back(subject, reason); };
        callbacks.on_round = [this](int round) { rounds_told.push_back(round); };
        callbacks.is_throttled = [this] {
            const std::size_t call = throttle_calls++;
            return call < throttled.size() && throttled[call];
        };
        if (interrupted_after) callbacks.is_interrupted = [this] { return visits.size() >= *interrupted_after; };
        return sample_in_rounds(subjects, rule, {samples_per_visit, seed, in_flight}, callbacks);
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
    const std::vector<SampledSubject> samples = fixture.sample(UnevenRule(250), 3);
    EXPECT_EQ(fixture.log, expected_log({{"a", "b", "c"}, {"b", "c"}, {"b", "c"}}, 3));
    EXPECT_EQ(samples[0].samples.at("draw").size(), 1U);
    EXPECT_EQ(samples[1].samples.at("draw").size(), 3U);
}

TEST(Rounds, SamplesAreKeptByRoundExactlyAsTaken) {
    Fixture fixture;
    const std::vector<SampledSubject> samples = fixture.sample(*make_fixed_rule(2), 1, 3);
    EXPECT_THAT(samples[0].samples.at("draw"), ElementsAre(ElementsAre(250, 250, 250), ElementsAre(250, 250, 250)));
    EXPECT_THAT(samples[2].samples.at("draw"),
                ElementsAre(ElementsAre(2000, 2000, 2000), ElementsAre(2000, 2000, 2000)));
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
    const std::vector<SampledSubject> samples = fixture.sample(*make_fixed_rule(4), 5);
    EXPECT_EQ(fixture.log, expected_log({{"a", "b", "c"}, {"a", "b", "c"}, {"a", "c"}, {"a", "c"}}, 5));
    EXPECT_THAT(fixture.failures, ElementsAre(std::pair<std::size_t, std::string>(1, "b broke")));
    EXPECT_EQ(samples[0].samples.at("draw").size(), 4U);
    EXPECT_EQ(samples[1].samples.at("draw").size(), 1U);
    EXPECT_EQ(samples[2].samples.at("draw").size(), 4U);
}

TEST(Rounds, ASubjectThatFailsInWarmUpIsNeverVisited) {
    Fixture fixture;
    fixture.a.fails_in_warm_up = true;
    const std::vector<SampledSubject> samples = fixture.sample(*make_fixed_rule(2), 9);
    EXPECT_EQ(fixture.log, expected_log({{"b", "c"}, {"b", "c"}}, 9));
    EXPECT_THAT(fixture.failures, ElementsAre(std::pair<std::size_t, std::string>(0, "a does not start")));
    EXPECT_TRUE(samples[0].samples.empty());
}

TEST(Rounds, AnAllocationThatFailsIsTheSubjectsFailure) {
    Fixture fixture;
    fixture.b.exhausts_memory = true;
    const std::vector<SampledSubject> samples = fixture.sample(*make_fixed_rule(2), 5);
    EXPECT_THAT(fixture.failures, ElementsAre(std::pair<std::size_t, std::string>(1, memory_used_up)));
    EXPECT_EQ(samples[2].samples.at("draw").size(), 2U) << "the others go on";
}

TEST(Rounds, AnErrorOfTheCallerEndsTheRun) {
    Fixture fixture;
    RoundCallbacks callbacks;
    callbacks.on_visit = [](const Visit&) { fail("disk full"); };
    callbacks.on_failure = [](std::size_t, const std::string&) { FAIL() << "the subject did nothing wrong"; };
    EXPECT_THROW(sample_in_rounds(fixture.subjects, *make_fixed_rule(2), {}, callbacks), Error);
}

TEST(Rounds, TellWhySubjectsStopAndWhenARoundIsOver) {
    Fixture fixture;
    const std::vector<SampledSubject> samples = fixture.sample(UnevenRule(250), 3);
    EXPECT_THAT(fixture.stops, ElementsAre(std::pair(0U, StopReason::precise), std::pair(1U, StopReason::precise),
                                           std::pair(2U, StopReason::precise)));
    EXPECT_THAT(fixture.rounds_told, ElementsAre(0, 1, 2));
    EXPECT_EQ(samples[2].stop, StopReason::precise);
}

TEST(Rounds, AFailedSubjectHasNoReasonToStop) {
    Fixture fixture;
    fixture.a.failing_visit = 1;
    EXPECT_FALSE(fixture.sample(*make_fixed_rule(2), 9)[0].stop);
}

TEST(Rounds, AThrottledVisitIsToldAndReplaced) {
    Fixture fixture;
    fixture.subjects = {&fixture.a};
    fixture.throttled = {false, true, true};
    const std::vector<SampledSubject> samples = fixture.sample(*make_fixed_rule(3), 1);
    ASSERT_EQ(fixture.visits.size(), 5U);
    for (std::size_t visit = 0; visit < 5; ++visit) {
        const bool throttled = visit == 1 || visit == 2;
        EXPECT_EQ(fixture.visits[visit].throttled, throttled) << visit;
        EXPECT_EQ(fixture.visits[visit].counted, !throttled) << visit;
    }
    EXPECT_EQ(samples[0].samples.at("draw").size(), 3U);
    EXPECT_EQ(samples[0].throttled_rounds, 0U);
}

TEST(Rounds, WhenThrottlingDoesNotEndItCountsAndIsSaid) {
    Fixture fixture;
    fixture.subjects = {&fixture.a};
    fixture.throttled.assign(1000, true);
    const std::vector<SampledSubject> samples = fixture.sample(*make_fixed_rule(3), 1);
    EXPECT_EQ(fixture.visits.size(), max_throttled_repeats + 3);
    EXPECT_EQ(samples[0].samples.at("draw").size(), 3U);
    EXPECT_EQ(samples[0].throttled_rounds, 3U);
}

/// Tells when its visits are submitted and collected.
class SplitSubject : public Subject {
public:
    SplitSubject(std::string name, std::vector<std::string>& log) : name_(std::move(name)), log_(&log) {}
    void warm_up() override {}
    Samples visit(int count) override {
        submit(count);
        return collect();
    }
    void submit(int) override { log_->push_back("submit " + name_); }
    Samples collect() override {
        log_->push_back("collect " + name_);
        if (fails) fail("{} broke", name_);
        return {{"draw", {1.0}}};
    }
    int repeats() const override { return 500; }
    bool fails = false;

private:
    std::string name_;
    std::vector<std::string>* log_;
};

std::vector<std::string> log_of_split_round(std::size_t in_flight, bool a_fails = false) {
    std::vector<std::string> log;
    SplitSubject a("x", log);
    SplitSubject b("x", log);
    SplitSubject c("x", log);
    a.fails = a_fails;
    RoundCallbacks callbacks;
    callbacks.on_visit = [&log](const Visit&) { log.push_back("keep x"); };
    callbacks.on_failure = [&log](std::size_t, const std::string&) { log.push_back("lose x"); };
    sample_in_rounds({&a, &b, &c}, *make_fixed_rule(1), {1, 1, in_flight}, callbacks);
    return log;
}

TEST(Rounds, OneInFlightKeepsAVisitBeforeTheNextIsSubmitted) {
    EXPECT_THAT(log_of_split_round(1), ElementsAre("submit x", "collect x", "keep x", "submit x", "collect x", "keep x",
                                                   "submit x", "collect x", "keep x"));
}

TEST(Rounds, TwoInFlightKeepTheDeviceBusyWhileAVisitIsKept) {
    EXPECT_THAT(log_of_split_round(2), ElementsAre("submit x", "submit x", "collect x", "keep x", "submit x",
                                                   "collect x", "keep x", "collect x", "keep x"));
}

TEST(Rounds, AFailureInFlightLeavesTheOthersAlone) {
    const std::vector<std::string> log = log_of_split_round(2, true);
    EXPECT_EQ(std::count(log.begin(), log.end(), "keep x"), 2);
    EXPECT_EQ(std::count(log.begin(), log.end(), "lose x"), 1);
}

TEST(Rounds, GoOnFromEarlierRounds) {
    std::vector<std::string> log;
    SplitSubject started("started", log);
    SplitSubject done("done", log);
    std::vector<int> rounds;
    RoundCallbacks callbacks;
    callbacks.on_visit = [&rounds](const Visit& visit) { rounds.push_back(visit.round); };
    callbacks.on_failure = [](std::size_t, const std::string& reason) { FAIL() << reason; };
    RoundSampling sampling{.first_round = 3};
    sampling.earlier = {{{{"draw", {{7}, {8}}}}, 0}, {{{"draw", {{1}, {2}, {3}}}}, 0}};
    const auto sampled = sample_in_rounds({&started, &done}, *make_fixed_rule(3), sampling, callbacks);
    EXPECT_THAT(rounds, ElementsAre(3)) << "one of three rounds was missing";
    EXPECT_THAT(log, ElementsAre("submit started", "collect started"));
    EXPECT_EQ(sampled[0].samples.at("draw"), (std::vector<std::vector<double>>{{7}, {8}, {1}}));
    EXPECT_EQ(sampled[1].samples.at("draw").size(), 3U);
    EXPECT_EQ(sampled[1].stop, StopReason::rounds);
}

TEST(Rounds, EarlierDeviceTimeIsSpent) {
    std::vector<std::string> log;
    SplitSubject subject("x", log);
    RoundCallbacks callbacks;
    std::size_t visits = 0;
    callbacks.on_visit = [&visits](const Visit&) { ++visits; };
    callbacks.on_failure = [](std::size_t, const std::string& reason) { FAIL() << reason; };
    RoundSampling sampling;
    sampling.earlier = {{{{"draw", {{1}, {1}}}}, 1.0}};
    sample_in_rounds({&subject}, *make_time_rule(1.5), sampling, callbacks);
    EXPECT_EQ(visits, 1U);
}

TEST(Rounds, TheDeviceTimeOfASampleCountsItsRepeats) {
    std::vector<std::string> log;
    SplitSubject subject("x", log);
    RoundCallbacks callbacks;
    std::size_t visits = 0;
    callbacks.on_visit = [&visits](const Visit&) { ++visits; };
    callbacks.on_failure = [](std::size_t, const std::string& reason) { FAIL() << reason; };
    // One sample of 1 ms, 500 draws: half a second.
    const auto sampled = sample_in_rounds({&subject}, *make_time_rule(1.5), {}, callbacks);
    EXPECT_EQ(visits, 3U);
    EXPECT_EQ(sampled[0].stop, StopReason::time);
}

TEST(Rounds, AnInterruptionFinishesWhatTheDeviceHasAndKeepsIt) {
    for (const std::size_t in_flight : {1U, 2U}) {
        Fixture fixture;
        fixture.interrupted_after = 4;
        const auto sampled = fixture.sample(*make_fixed_rule(3), 7, 2, in_flight);
        EXPECT_EQ(fixture.visits.size(), 3 + in_flight);
        EXPECT_THAT(fixture.rounds_told, ElementsAre(0)) << "the second round was not whole";
        std::size_t rounds = 0;
        for (const SampledSubject& subject : sampled) {
            EXPECT_FALSE(subject.stop);
            rounds += subject.samples.at("draw").size();
        }
        EXPECT_EQ(rounds, fixture.visits.size());
        EXPECT_TRUE(fixture.failures.empty());
    }
}

TEST(Rounds, WhatWasDoneBeforeAnInterruptionIsDone) {
    Fixture fixture;
    fixture.interrupted_after = 4;
    const auto sampled = fixture.sample(UnevenRule(250), 7);
    EXPECT_EQ(sampled[0].stop, StopReason::precise);
    EXPECT_FALSE(sampled[1].stop);
    EXPECT_FALSE(sampled[2].stop);
}

}  // namespace
}  // namespace reliefbench
