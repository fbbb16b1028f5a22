#include "measure/stopping_rule.hpp"

#include <algorithm>
#include <cstddef>

namespace reliefbench {

namespace {

class FixedRule : public StoppingRule {
public:
    explicit FixedRule(std::size_t rounds) : rounds_(rounds) {}

    bool is_settled(const SampleRounds& samples) const override {
        if (samples.empty()) {
            return rounds_ == 0;
        }
        return std::all_of(samples.begin(), samples.end(),
                           [this](const auto& pass) { return pass.second.size() >= rounds_; });
    }

private:
    std::size_t rounds_;
};

}  // namespace

std::unique_ptr<StoppingRule> make_fixed_rule(int rounds) {
    return std::make_unique<FixedRule>(static_cast<std::size_t>(std::max(rounds, 0)));
}

}  // namespace reliefbench
