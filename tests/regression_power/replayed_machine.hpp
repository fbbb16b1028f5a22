#pragma once

#include "core/json.hpp"
#include "measure/clock.hpp"
#include "measure/subject.hpp"

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace reliefbench {

/// What a shared machine did to identical draws, as recorded by benchmarks/regression_power; recorded_noise.json.
struct RecordedNoise {
    /// Times of one draw, one after the other with nothing between, while another process was busy.
    std::vector<double> draws_ms;
    /// What a cell took in each run (lower quartile of its samples): by cell, by run.
    std::vector<std::vector<double>> run_times_ms;
};

RecordedNoise read_recorded_noise();

/// A clock and a device in one: every draw takes its nominal time, stretched by what the machine did at that moment of
/// the record. Starts anywhere in the record and goes round.
class ReplayedMachine : public Clock {
public:
    ReplayedMachine(const std::vector<double>& draws_ms, std::size_t start);

    double seconds() const override { return now_s_; }
    /// Milliseconds.
    double draw(double nominal_ms);

private:
    const std::vector<double>* draws_ms_;
    double median_ms_;
    std::size_t next_;
    double now_s_ = 0;
};

class ReplayedSubject : public Subject {
public:
    ReplayedSubject(ReplayedMachine& machine, double nominal_ms) : machine_(&machine), nominal_ms_(nominal_ms) {}

    void warm_up() override { machine_->draw(nominal_ms_); }
    std::map<std::string, std::vector<double>> visit(int count) override;

private:
    ReplayedMachine* machine_;
    double nominal_ms_;
};

}  // namespace reliefbench
