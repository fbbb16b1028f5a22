#include "measure/stopping_rule.hpp"

#include "core/statistics.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <limits>

namespace reliefbench {

namespace {

/// Rounds that every pass has.
std::size_t rounds_of(const SampleRounds& samples) {
    std::size_t fewest = samples.empty() ? 0 : std::numeric_limits<std::size_t>::max();
    for (const auto& [pass, rounds] : samples) {
        fewest = std::min(fewest, rounds.size());
    }
    return fewest;
}

double width(const Interval& interval) {
    return interval.high - interval.low;
}

/// Every round up to 32, then 16 of every doubling: an interval takes time to find, and each look is a chance to be
/// lucky.
bool is_look(std::size_t rounds) {
    constexpr std::size_t looks_of_doubling = 16;
    return rounds % std::max<std::size_t>(1, std::bit_floor(rounds) / looks_of_doubling) == 0;
}

bool is_precise(std::span<const double> medians, double precision) {
    const double centre = median(medians);
    const Interval interval = median_interval(medians);
    return std::max(interval.high - centre, centre - interval.low) <= precision * centre;
}

class FixedRule : public StoppingRule {
public:
    explicit FixedRule(std::size_t rounds) : rounds_(rounds) {}

    std::optional<StopReason> stop(const SampleRounds& samples, double /*device_s*/) const override {
        if (rounds_of(samples) < rounds_) return std::nullopt;
        return StopReason::rounds;
    }

private:
    std::size_t rounds_;
};

class TimeRule : public StoppingRule {
public:
    explicit TimeRule(double budget_s) : budget_s_(budget_s) {}

    std::optional<StopReason> stop(const SampleRounds& samples, double device_s) const override {
        if (rounds_of(samples) == 0 || device_s < budget_s_) return std::nullopt;
        return StopReason::time;
    }

private:
    double budget_s_;
};

class PrecisionRule : public StoppingRule {
public:
    PrecisionRule(double precision, std::size_t min_rounds, double budget_s)
        : precision_(precision), min_rounds_(min_rounds), budget_s_(budget_s) {}

    std::optional<StopReason> stop(const SampleRounds& samples, double device_s) const override {
        const std::size_t rounds = rounds_of(samples);
        if (rounds < SamplingSettings::rounds_for_interval) return std::nullopt;
        if (rounds >= min_rounds_ && (rounds == min_rounds_ || is_look(rounds))) {
            bool precise = true;
            bool stalled = false;
            for (const auto& [pass, pass_rounds] : samples) {
                const std::vector<double> medians = round_medians(pass_rounds);
                if (is_precise(medians, precision_)) continue;
                precise = false;
                stalled = stalled || has_stopped_narrowing(medians);
            }
            if (precise) return StopReason::precise;
            if (stalled) return StopReason::stalled;
        }
        if (device_s >= budget_s_) return StopReason::budget;
        return std::nullopt;
    }

private:
    double precision_;
    std::size_t min_rounds_;
    double budget_s_;
};

}  // namespace

std::vector<double> round_medians(const std::vector<std::vector<double>>& rounds) {
    std::vector<double> medians;
    medians.reserve(rounds.size());
    for (const std::vector<double>& round : rounds) {
        medians.push_back(median(round));
    }
    return medians;
}

bool has_stopped_narrowing(std::span<const double> medians) {
    constexpr std::size_t least = 32;
    constexpr double min_share = 0.9;
    const std::size_t rounds = medians.size();
    if (rounds < least || !std::has_single_bit(rounds)) return false;
    const double quarter = width(median_interval(medians.first(rounds / 4)));
    const double half = width(median_interval(medians.first(rounds / 2)));
    const double whole = width(median_interval(medians));
    return half >= min_share * quarter && whole >= min_share * half;
}

std::unique_ptr<StoppingRule> make_fixed_rule(int rounds) {
    return std::make_unique<FixedRule>(static_cast<std::size_t>(std::max(rounds, 0)));
}

std::unique_ptr<StoppingRule> make_time_rule(double budget_s) {
    return std::make_unique<TimeRule>(budget_s);
}

std::unique_ptr<StoppingRule> make_precision_rule(double precision, int min_rounds, double budget_s) {
    return std::make_unique<PrecisionRule>(precision, static_cast<std::size_t>(std::max(min_rounds, 0)), budget_s);
}

std::unique_ptr<StoppingRule> make_stopping_rule(const SamplingSettings& settings) {
    switch (settings.rule) {
        case SamplingSettings::Rule::fixed:
            return make_fixed_rule(settings.rounds);
        case SamplingSettings::Rule::time:
            return make_time_rule(settings.budget_s);
        case SamplingSettings::Rule::precision:
            break;
    }
    return make_precision_rule(settings.precision, settings.rounds, settings.budget_s);
}

}  // namespace reliefbench
