#include "measure/paired_rounds.hpp"

#include "core/attempt.hpp"
#include "core/error.hpp"
#include "core/random.hpp"
#include "core/statistics.hpp"
#include "measure/draw_subject.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <span>

namespace reliefbench {

namespace {

constexpr double undisturbed_quantile = 0.25;

/// What a visit's samples count for.
double undisturbed_ms(const std::vector<double>& samples) {
    const double milliseconds = quantile(samples, undisturbed_quantile);
    if (!(milliseconds > 0)) fail("the device's clock does not see the draw: it took {} ms", milliseconds);
    return milliseconds;
}

/// One execution of sample_pairs.
class PairSampler {
public:
    PairSampler(const std::vector<SubjectPair>& pairs, const PairSampling& sampling, const PairCallbacks& callbacks)
        : pairs_(pairs),
          sampling_(sampling),
          callbacks_(callbacks),
          random_(sampling.seed),
          log_ratios_(pairs.size()),
          base_first_(pairs.size()) {}

    std::vector<LogRatios> run(const Clock& clock) {
        const double end_s = clock.seconds() + sampling_.budget_s;
        std::vector<std::size_t> visited;
        for (std::size_t pair = 0; pair < pairs_.size(); ++pair) {
            const bool warm = attempt(pair, [&] {
                pairs_[pair].base->warm_up();
                pairs_[pair].changed->warm_up();
            });
            if (warm) visited.push_back(pair);
        }
        while (!visited.empty() && clock.seconds() < end_s) {
            random_.shuffle(std::span<std::size_t>(visited));
            std::erase_if(visited, [&](std::size_t pair) { return !attempt(pair, [&] { visit(pair); }); });
            std::erase_if(visited, [&](std::size_t pair) { return callbacks_.is_decided(pair, log_ratios_[pair]); });
            if (callbacks_.on_round) callbacks_.on_round(visited.size());
        }
        return std::move(log_ratios_);
    }

private:
    /// Whether it went without a failure.
    bool attempt(std::size_t pair, const std::function<void()>& action) {
        const std::string reason = failure_of(action);
        if (reason.empty()) return true;
        callbacks_.on_failure(pair, reason);
        return false;
    }

    void visit(std::size_t pair) {
        LogRatios& log_ratios = log_ratios_[pair];
        const bool odd_round = log_ratios.size() % 2 == 1;
        base_first_[pair] = odd_round ? !base_first_[pair] : random_.below(2) == 0;
        PairVisit visit{pair, log_ratios.size(), base_first_[pair], {}, {}};
        const auto sample = [&](Subject& subject) { return subject.visit(sampling_.samples_per_visit).at(draw_pass); };
        if (visit.base_first) visit.base_ms = sample(*pairs_[pair].base);
        visit.changed_ms = sample(*pairs_[pair].changed);
        if (!visit.base_first) visit.base_ms = sample(*pairs_[pair].base);
        log_ratios.push_back(std::log(undisturbed_ms(visit.changed_ms) / undisturbed_ms(visit.base_ms)));
        if (callbacks_.on_visit) callbacks_.on_visit(visit);
    }

    const std::vector<SubjectPair>& pairs_;
    const PairSampling& sampling_;
    const PairCallbacks& callbacks_;
    Random random_;
    std::vector<LogRatios> log_ratios_;
    /// In the last round.
    std::vector<bool> base_first_;
};

}  // namespace

std::vector<LogRatios> sample_pairs(const std::vector<SubjectPair>& pairs, const PairSampling& sampling,
                                    const PairCallbacks& callbacks, const Clock& clock) {
    return PairSampler(pairs, sampling, callbacks).run(clock);
}

}  // namespace reliefbench
