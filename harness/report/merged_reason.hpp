#pragma once

#include <string>
#include <vector>

namespace reliefbench {

/// Reasons of cells that differ by nothing but figures (a percentage, seconds) are one reason.
class MergedReason {
public:
    explicit MergedReason(const std::string& reason);

    /// Joins `reason` where it is alike; false where it is another one.
    bool add(const std::string& reason);

    /// The reason, with "594 to 18300" where a figure differs.
    std::string text() const;

private:
    /// What stands around the figures, one more than there are of them.
    std::vector<std::string> words_;
    struct Range {
        std::string least;
        std::string greatest;
    };
    std::vector<Range> figures_;
};

}  // namespace reliefbench
