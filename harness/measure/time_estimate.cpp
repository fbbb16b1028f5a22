#include "measure/time_estimate.hpp"

#include <algorithm>

namespace reliefbench {

TimeEstimate::TimeEstimate(std::size_t cells, int rounds) : cells_(static_cast<double>(cells)), rounds_(rounds) {}

void TimeEstimate::add_preparation(double seconds) {
    ++prepared_;
    preparation_seconds_ += seconds;
}

void TimeEstimate::add_visit(double seconds) {
    ++visits_;
    ++timed_visits_;
    visit_seconds_ += seconds;
}

void TimeEstimate::add_untimed_visit() {
    ++visits_;
}

void TimeEstimate::drop_cell(std::size_t visits_done) {
    visits_ += rounds_ - static_cast<double>(visits_done);
}

double TimeEstimate::remaining_seconds() const {
    const double cells_left = std::max(0.0, cells_ - prepared_);
    const double visits_left = std::max(0.0, cells_ * rounds_ - visits_);
    if ((cells_left > 0 && prepared_ == 0) || (visits_left > 0 && timed_visits_ == 0)) return -1;
    const double preparation = cells_left > 0 ? cells_left * preparation_seconds_ / prepared_ : 0;
    const double sampling = visits_left > 0 ? visits_left * visit_seconds_ / timed_visits_ : 0;
    return preparation + sampling;
}

}  // namespace reliefbench
