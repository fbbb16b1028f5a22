#include "measure/stopping_rule.hpp"

#include "core/random.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <numbers>
#include <optional>
#include <vector>

namespace reliefbench {
namespace {

/// Milliseconds of round n, from 1.
using Series = std::function<double(std::size_t n)>;

struct Outcome {
    StopReason reason = StopReason::budget;
    std::size_t rounds = 0;
};

/// One sample a round until the rule stops it.
Outcome sample(const StoppingRule& rule, const Series& series) {
    SampleRounds samples;
    double device_s = 0;
    for (std::size_t n = 1;; ++n) {
        const double milliseconds = series(n);
        samples["draw"].push_back({milliseconds});
        device_s += milliseconds / 1000;
        if (const std::optional<StopReason> reason = rule.stop(samples, device_s)) return {*reason, n};
    }
}

double normal(Random& random) {
    const double radius = std::sqrt(-2 * std::log(1 - random.uniform()));
    return radius * std::cos(2 * std::numbers::pi * random.uniform());
}

Series noise(Random& random, double spread) {
    return [&random, spread](std::size_t) { return std::exp(spread * normal(random)); };
}

TEST(FixedRule, NeedsEveryPassInEveryRound) {
    const auto rule = make_fixed_rule(2);
    EXPECT_FALSE(rule->stop({}, 0));
    EXPECT_FALSE(rule->stop({{"draw", {{1.0}}}}, 0));
    EXPECT_EQ(rule->stop({{"draw", {{1.0}, {1.0}}}}, 0), StopReason::rounds);
    EXPECT_FALSE(rule->stop({{"draw", {{1.0}, {1.0}}}, {"shadow", {{1.0}}}}, 0));
}

TEST(TimeRule, StopsWhenTheDeviceHasBeenAtItForSoLong) {
    const auto rule = make_time_rule(0.5);
    const SampleRounds one_round{{"draw", {{250.0}}}};
    EXPECT_FALSE(rule->stop(one_round, 0.25));
    EXPECT_EQ(rule->stop(one_round, 0.5), StopReason::time);
    EXPECT_FALSE(rule->stop({}, 1)) << "nothing that counts has been measured";
}

TEST(PrecisionRule, AConstantIsPreciseAfterTheLeastRounds) {
    const Outcome outcome = sample(*make_precision_rule(0.01, 8, 100), [](std::size_t) { return 5.0; });
    EXPECT_EQ(outcome.reason, StopReason::precise);
    EXPECT_EQ(outcome.rounds, 8U);
}

TEST(PrecisionRule, IsPreciseExactlyWhenTheIntervalIsWithinThePrecision) {
    // Seven rounds have the whole range as their interval; its median is 100.
    const SampleRounds just{{"draw", {{99}, {100}, {100}, {100}, {100}, {100}, {101}}}};
    const SampleRounds not_quite{{"draw", {{99}, {100}, {100}, {100}, {100}, {100}, {101.5}}}};
    const auto rule = make_precision_rule(0.01, 6, 100);
    EXPECT_EQ(rule->stop(just, 0), StopReason::precise);
    EXPECT_FALSE(rule->stop(not_quite, 0));
}

TEST(PrecisionRule, LooksSeldomAtLongSeries) {
    const auto rule = make_precision_rule(0.01, 6, 100);
    const auto constant = [](std::size_t rounds) {
        return SampleRounds{{"draw", std::vector<std::vector<double>>(rounds, {1.0})}};
    };
    EXPECT_EQ(rule->stop(constant(31), 0), StopReason::precise);
    EXPECT_FALSE(rule->stop(constant(35 + 64), 0));
    EXPECT_EQ(rule->stop(constant(36 + 64), 0), StopReason::precise);
    EXPECT_EQ(make_precision_rule(0.01, 99, 100)->stop(constant(99), 0), StopReason::precise) << "the least";
}

TEST(PrecisionRule, TakesTheMedianOfARoundAndEveryPass) {
    const std::vector<std::vector<double>> steady(6, {1, 1, 50});
    const std::vector<std::vector<double>> unsteady{{1}, {2}, {3}, {4}, {5}, {6}};
    const auto rule = make_precision_rule(0.01, 6, 100);
    EXPECT_EQ(rule->stop({{"draw", steady}}, 0), StopReason::precise);
    EXPECT_FALSE(rule->stop({{"draw", steady}, {"shadow", unsteady}}, 0));
}

TEST(PrecisionRule, TheBudgetEndsItButNotBeforeThereIsAnInterval) {
    Random random(1);
    const Outcome spent = sample(*make_precision_rule(0.001, 30, 0.02), noise(random, 0.3));
    EXPECT_EQ(spent.reason, StopReason::budget);
    EXPECT_GT(spent.rounds, 6U);
    EXPECT_LT(spent.rounds, 30U);
    EXPECT_EQ(sample(*make_precision_rule(0.001, 30, 0.001), noise(random, 0.3)).rounds, 6U);
}

/// How many of `series` ended by stalling.
std::size_t count_stalled(std::size_t series_count, const std::function<Series(Random&)>& make_series) {
    std::size_t stalled = 0;
    for (std::size_t seed = 1; seed <= series_count; ++seed) {
        Random random(seed);
        // 300 rounds of about 1 ms.
        const Outcome outcome = sample(*make_precision_rule(0.01, 6, 0.3), make_series(random));
        stalled += outcome.reason == StopReason::stalled ? 1 : 0;
    }
    return stalled;
}

TEST(PrecisionRule, IndependentNoiseSeldomStalls) {
    // By simulation about 8 in 100; the widths themselves are noisy.
    EXPECT_LE(count_stalled(100, [](Random& random) { return noise(random, 0.1); }), 10U);
}

TEST(PrecisionRule, ADriftStalls) {
    const auto drifting = [](Random& random) -> Series {
        return [&random](std::size_t n) { return 1 + 0.02 * static_cast<double>(n) + 0.02 * normal(random); };
    };
    EXPECT_GE(count_stalled(100, drifting), 90U);
}

TEST(PrecisionRule, TwoModesStall) {
    // Alternating at random between two clocks: the median has no one place to settle.
    const auto bimodal = [](Random& random) -> Series {
        return [&random](std::size_t) { return (random.uniform() < 0.5 ? 1.0 : 1.3) + 0.03 * normal(random); };
    };
    EXPECT_GE(count_stalled(100, bimodal), 80U);
}

TEST(StoppedNarrowing, IsJudgedAtDoublingsOnlyFromThirtyTwoOn) {
    std::vector<double> apart;
    for (std::size_t n = 1; n <= 70; ++n) {
        apart.push_back(n % 2 == 0 ? 1 : 2);
        EXPECT_EQ(has_stopped_narrowing(apart), n == 32 || n == 64) << n;
    }
}

TEST(StoppingRule, IsTheOneConfigured) {
    SamplingSettings settings;
    settings.rule = SamplingSettings::Rule::fixed;
    settings.rounds = 1;
    EXPECT_EQ(make_stopping_rule(settings)->stop({{"draw", {{1.0}}}}, 0), StopReason::rounds);
    settings.rule = SamplingSettings::Rule::time;
    settings.budget_s = 1;
    EXPECT_EQ(make_stopping_rule(settings)->stop({{"draw", {{1.0}}}}, 1), StopReason::time);
    settings.rule = SamplingSettings::Rule::precision;
    settings.rounds = 6;
    EXPECT_EQ(make_stopping_rule(settings)->stop({{"draw", {{1}, {1}, {1}, {1}, {1}, {1}}}}, 0), StopReason::precise);
}

}  // namespace
}  // namespace reliefbench
