#include "verify/check_list.hpp"

#include "core/error.hpp"

namespace reliefbench {

CheckList::CheckList(const gpu::Device& device, const Technique& technique,
                     const std::function<void(const Check&)>& on_check, const PreparationSettings& preparation)
    : device_(&device), technique_(&technique), on_check_(on_check), preparation_(preparation), scenes_(device) {}

double CheckList::filter_deviation() {
    if (filter_deviation_ < 0) filter_deviation_ = measure_filter_deviation(*device_, HeightFormat::r16);
    return filter_deviation_;
}

const Comparison& CheckList::comparison(const ParameterValues& parameters, const Circumstance& circumstance) {
    const std::string key = describe(parameters, manifest()) + "; " + describe(circumstance);
    const auto known = comparisons_.find(key);
    if (known != comparisons_.end()) return known->second;
    const CoordinateScene& scene = scenes_.get(circumstance.map, circumstance.map_size);
    Comparison found = compare_with_truth(*device_, *technique_, parameters, scene, circumstance.view, preparation_);
    return comparisons_.emplace(key, std::move(found)).first->second;
}

bool CheckList::check(const std::string& name, const std::string& circumstances, const std::function<Finding()>& body) {
    Check check{manifest().id, name, circumstances, false, {}};
    try {
        const Finding finding = body();
        check.passed = finding.passed;
        check.detail = finding.detail;
    } catch (const Error& error) {
        check.detail = error.what();
    }
    checks_.push_back(check);
    if (on_check_) on_check_(check);
    return check.passed;
}

}  // namespace reliefbench
