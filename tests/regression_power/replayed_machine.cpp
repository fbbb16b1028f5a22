#include "replayed_machine.hpp"

#include "core/statistics.hpp"

namespace reliefbench {

RecordedNoise read_recorded_noise() {
    const std::string path = RELIEFBENCH_SOURCE_DIR "/tests/regression_power/recorded_noise.json";
    const Json json = read_json_file(path);
    RecordedNoise noise;
    noise.draws_ms = json.at("draws_ms").get<std::vector<double>>();
    noise.run_times_ms = json.at("run_times_ms").get<std::vector<std::vector<double>>>();
    return noise;
}

ReplayedMachine::ReplayedMachine(const std::vector<double>& draws_ms, std::size_t start)
    : draws_ms_(&draws_ms), median_ms_(median(draws_ms)), next_(start % draws_ms.size()) {}

double ReplayedMachine::draw(double nominal_ms) {
    const double took_ms = nominal_ms * (*draws_ms_)[next_] / median_ms_;
    next_ = (next_ + 1) % draws_ms_->size();
    now_s_ += took_ms / 1000;
    return took_ms;
}

std::map<std::string, std::vector<double>> ReplayedSubject::visit(int count) {
    std::vector<double> samples;
    for (int sample = 0; sample < count; ++sample) {
        samples.push_back(machine_->draw(nominal_ms_));
    }
    return {{"draw", samples}};
}

}  // namespace reliefbench
