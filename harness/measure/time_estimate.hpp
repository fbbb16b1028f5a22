#pragma once

#include <cstddef>

namespace reliefbench {

/// How long a run will go on, from what its cells have taken so far: each is prepared once, then visited until it is
/// finished. How many visits that takes is known beforehand (`min_rounds`) only where the stopping rule fixes it;
/// else those that are finished tell.
class TimeEstimate {
public:
    TimeEstimate(std::size_t cells, int min_rounds);

    void add_preparation(double seconds);
    /// More for cells whose preparation was added before.
    void extend_preparation(double seconds);
    void add_visit(double seconds);
    /// A cell that wants no more visits after so many.
    void finish_cell(std::size_t visits);
    /// The same for one whose number of visits says nothing of the others', because it failed.
    void drop_cell(std::size_t visits);

    /// Negative while unknown: until a cell has been prepared and one visited.
    double remaining_seconds() const;

private:
    double to_prepare_;
    double min_rounds_;
    double prepared_ = 0;
    double preparation_seconds_ = 0;
    /// Cells that want visits, and the visits that they have had.
    double unfinished_;
    double unfinished_visits_ = 0;
    double finished_ = 0;
    double finished_visits_ = 0;
    double timed_visits_ = 0;
    double visit_seconds_ = 0;
};

/// How much of the time of a whole is over. What is not known yet is estimated anew while it goes on, but what is told
/// never goes back.
class ShareDone {
public:
    /// In [0, 1]; negative while unknown, which a negative `remaining_s` is.
    double of(double elapsed_s, double remaining_s);

private:
    double most_ = -1;
};

}  // namespace reliefbench
