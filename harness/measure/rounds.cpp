#include "measure/rounds.hpp"

#include "core/attempt.hpp"
#include "core/random.hpp"

#include <cassert>
#include <deque>
#include <functional>
#include <numeric>
#include <optional>
#include <utility>

namespace reliefbench {

namespace {

double device_seconds(const Subject::Samples& samples, int repeats) {
    double milliseconds = 0;
    for (const auto& [pass, values] : samples) {
        milliseconds = std::accumulate(values.begin(), values.end(), milliseconds);
    }
    return milliseconds * repeats / 1000.0;
}

/// One execution of sample_in_rounds.
class Rounds {
public:
    Rounds(const std::vector<Subject*>& subjects, const StoppingRule& rule, const RoundSampling& sampling,
           const RoundCallbacks& callbacks)
        : rule_(rule), sampling_(sampling), callbacks_(callbacks) {
        assert(sampling.in_flight > 0);
        assert(sampling.earlier.empty() || sampling.earlier.size() == subjects.size());
        for (Subject* subject : subjects) {
            states_.push_back({subject});
        }
        for (std::size_t subject = 0; subject < sampling.earlier.size(); ++subject) {
            states_[subject].result.samples = sampling.earlier[subject].samples;
            states_[subject].device_s = sampling.earlier[subject].device_s;
        }
    }

    std::vector<SampledSubject> run() {
        for (std::size_t subject = 0; subject < states_.size() && !interrupted(); ++subject) {
            attempt(subject, [&] { states_[subject].subject->warm_up(); });
        }
        if (callbacks_.on_warm) callbacks_.on_warm();
        Random random(sampling_.seed);
        for (int round = sampling_.first_round; !interrupted(); ++round) {
            std::vector<std::size_t> order = unsettled();
            if (order.empty()) break;
            random.shuffle(std::span<std::size_t>(order));
            visit_all(order, round);
            if (interrupted()) break;
            if (callbacks_.on_round) callbacks_.on_round(round);
        }
        std::vector<SampledSubject> results;
        for (State& state : states_) {
            results.push_back(std::move(state.result));
        }
        return results;
    }

private:
    struct State {
        Subject* subject;
        SampledSubject result = {};
        double device_s = 0;
        std::size_t throttled_repeats = 0;
        bool failed = false;
    };

    struct Submitted {
        std::size_t subject;
        int round;
        int order;
    };

    bool interrupted() const { return callbacks_.is_interrupted && callbacks_.is_interrupted(); }

    std::vector<std::size_t> unsettled() {
        std::vector<std::size_t> subjects;
        for (std::size_t subject = 0; subject < states_.size(); ++subject) {
            State& state = states_[subject];
            if (state.failed || state.result.stop) continue;
            state.result.stop = rule_.stop(state.result.samples, state.device_s);
            if (!state.result.stop) {
                subjects.push_back(subject);
            } else if (callbacks_.on_stop) {
                callbacks_.on_stop(subject, *state.result.stop);
            }
        }
        return subjects;
    }

    void visit_all(const std::vector<std::size_t>& order, int round) {
        for (std::size_t position = 0; position < order.size() && !interrupted(); ++position) {
            if (submitted_.size() == sampling_.in_flight) collect();
            if (interrupted()) break;
            const std::size_t subject = order[position];
            if (attempt(subject, [&] { states_[subject].subject->submit(sampling_.samples_per_visit); })) {
                submitted_.push_back({subject, round, static_cast<int>(position)});
            }
        }
        while (!submitted_.empty()) {
            collect();
        }
    }

    /// The visit that was submitted first.
    void collect() {
        const Submitted submitted = submitted_.front();
        submitted_.pop_front();
        State& state = states_[submitted.subject];
        Visit visit{submitted.subject, submitted.round, submitted.order, {}};
        if (!attempt(submitted.subject, [&] { visit.samples = state.subject->collect(); })) return;
        assert(!visit.samples.empty() && "a subject that times nothing would never settle");
        visit.throttled = callbacks_.is_throttled && callbacks_.is_throttled();
        visit.counted = !visit.throttled || state.throttled_repeats == max_throttled_repeats;
        state.device_s += device_seconds(visit.samples, state.subject->repeats());
        if (visit.counted) {
            state.result.throttled_rounds += visit.throttled ? 1 : 0;
            for (const auto& [pass, milliseconds] : visit.samples) {
                state.result.samples[pass].push_back(milliseconds);
            }
        } else {
            ++state.throttled_repeats;
        }
        callbacks_.on_visit(visit);
    }

    /// Runs `action` on one subject, whose failure it may be. What callbacks throw is not.
    bool attempt(std::size_t subject, const std::function<void()>& action) {
        if (callbacks_.on_turn) callbacks_.on_turn(subject);
        const std::string reason = failure_of(action);
        if (reason.empty()) return true;
        states_[subject].failed = true;
        callbacks_.on_failure(subject, reason);
        return false;
    }

    const StoppingRule& rule_;
    const RoundSampling& sampling_;
    const RoundCallbacks& callbacks_;
    std::vector<State> states_;
    std::deque<Submitted> submitted_;
};

}  // namespace

std::vector<SampledSubject> sample_in_rounds(const std::vector<Subject*>& subjects, const StoppingRule& rule,
                                             const RoundSampling& sampling, const RoundCallbacks& callbacks) {
    return Rounds(subjects, rule, sampling, callbacks).run();
}

}  // namespace reliefbench
