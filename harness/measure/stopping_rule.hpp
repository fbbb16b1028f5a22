#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace reliefbench {

/// The samples of one cell so far: by pass, by round.
using SampleRounds = std::map<std::string, std::vector<std::vector<double>>>;

/// Decides when a cell has been sampled enough; chosen in the configuration. Statistics stay out of the runner.
class StoppingRule {
public:
    virtual ~StoppingRule() = default;
    virtual bool is_settled(const SampleRounds& samples) const = 0;
};

/// Settled after a fixed number of rounds.
std::unique_ptr<StoppingRule> make_fixed_rule(int rounds);

}  // namespace reliefbench
