#include "measure/rounds.hpp"

#include "core/error.hpp"
#include "core/random.hpp"

#include <cassert>
#include <optional>

namespace reliefbench {

namespace {

/// Runs `action` on one subject. Its Error goes to `on_failure`; what the caller's own callbacks throw does not.
template <typename Action>
auto attempt(std::size_t subject, const std::function<void(std::size_t, const std::string&)>& on_failure,
             Action&& action) -> std::optional<decltype(action())> {
    std::string message;
    try {
        return action();
    } catch (const Error& error) {
        message = error.what();
    }
    on_failure(subject, message);
    return std::nullopt;
}

}  // namespace

std::vector<SampleRounds> sample_in_rounds(const std::vector<Subject*>& subjects, const StoppingRule& rule,
                                           int samples_per_visit, std::uint64_t seed,
                                           const std::function<void(const Visit&)>& on_visit,
                                           const std::function<void(std::size_t, const std::string&)>& on_failure) {
    std::vector<SampleRounds> samples(subjects.size());
    std::vector<bool> visited(subjects.size(), false);
    for (std::size_t subject = 0; subject < subjects.size(); ++subject) {
        visited[subject] = attempt(subject, on_failure, [&] {
                               subjects[subject]->warm_up();
                               return true;
                           }).has_value();
    }
    Random random(seed);
    for (int round = 0;; ++round) {
        std::vector<std::size_t> order;
        for (std::size_t subject = 0; subject < subjects.size(); ++subject) {
            if (visited[subject] && !rule.is_settled(samples[subject])) {
                order.push_back(subject);
            }
        }
        if (order.empty()) {
            return samples;
        }
        random.shuffle(std::span<std::size_t>(order));
        for (std::size_t position = 0; position < order.size(); ++position) {
            const std::size_t subject = order[position];
            auto taken = attempt(subject, on_failure, [&] { return subjects[subject]->visit(samples_per_visit); });
            if (!taken) {
                visited[subject] = false;
                continue;
            }
            assert(!taken->empty() && "a subject that times nothing would never settle");
            for (const auto& [pass, milliseconds] : *taken) {
                samples[subject][pass].push_back(milliseconds);
            }
            on_visit({subject, round, static_cast<int>(position), std::move(*taken)});
        }
    }
}

}  // namespace reliefbench
