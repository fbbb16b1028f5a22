#include "measure/time_estimate.hpp"

#include <algorithm>

namespace reliefbench {

TimeEstimate::TimeEstimate(std::size_t cells, int min_rounds)
    : to_prepare_(static_cast<double>(cells)), min_rounds_(min_rounds), unfinished_(static_cast<double>(cells)) {}

void TimeEstimate::add_preparation(double seconds) {
    --to_prepare_;
    ++prepared_;
    preparation_seconds_ += seconds;
}

void TimeEstimate::extend_preparation(double seconds) {
    preparation_seconds_ += seconds;
}

void TimeEstimate::add_visit(double seconds) {
    ++unfinished_visits_;
    ++timed_visits_;
    visit_seconds_ += seconds;
}

void TimeEstimate::finish_cell(std::size_t visits) {
    drop_cell(visits);
    ++finished_;
    finished_visits_ += static_cast<double>(visits);
}

void TimeEstimate::drop_cell(std::size_t visits) {
    --unfinished_;
    unfinished_visits_ -= static_cast<double>(visits);
}

double TimeEstimate::remaining_seconds() const {
    const double visits_each = std::max(min_rounds_, finished_ > 0 ? finished_visits_ / finished_ : 0);
    const double visits_left = std::max(0.0, unfinished_ * visits_each - unfinished_visits_);
    if ((to_prepare_ > 0 && prepared_ == 0) || (visits_left > 0 && timed_visits_ == 0)) return -1;
    const double preparation = to_prepare_ > 0 ? to_prepare_ * preparation_seconds_ / prepared_ : 0;
    const double sampling = visits_left > 0 ? visits_left * visit_seconds_ / timed_visits_ : 0;
    return preparation + sampling;
}

double ShareDone::of(double elapsed_s, double remaining_s) {
    const double whole_s = elapsed_s + remaining_s;
    if (remaining_s >= 0 && whole_s > 0) most_ = std::max(most_, elapsed_s / whole_s);
    return remaining_s < 0 ? -1 : most_;
}

}  // namespace reliefbench
