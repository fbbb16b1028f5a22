#pragma once

#include <cstddef>

namespace reliefbench {

/// How long a run will go on, from what its cells have taken so far: each is prepared once and visited in every round.
class TimeEstimate {
public:
    TimeEstimate(std::size_t cells, int rounds);

    void add_preparation(double seconds);
    void add_visit(double seconds);
    /// A visit whose time says nothing of the others'.
    void add_untimed_visit();
    /// A cell that ends before its visits are over, `visits` of them done.
    void drop_cell(std::size_t visits_done);

    /// Negative while unknown: until a cell has been prepared and one visited.
    double remaining_seconds() const;

private:
    double cells_;
    double rounds_;
    double prepared_ = 0;
    double preparation_seconds_ = 0;
    double visits_ = 0;
    double timed_visits_ = 0;
    double visit_seconds_ = 0;
};

}  // namespace reliefbench
