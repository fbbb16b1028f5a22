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

const TruthComparison& CheckList::comparison(const ParameterValues& parameters, const Circumstance& circumstance) {
    const std::string key = describe(parameters, manifest()) + "; " + describe(circumstance);
    const auto known = comparisons_.find(key);
    if (known != comparisons_.end()) return known->second;
    const CoordinateScene& scene = scenes_.get(circumstance.map, circumstance.map_size);
    TruthComparison found =
        compare_with_truth(*device_, *technique_, parameters, scene, circumstance.view, preparation_);
    return comparisons_.emplace(key, std::move(found)).first->second;
}

bool CheckList::check(const std::string& name, const ParameterValues& parameters, const Circumstance& where,
                      const std::function<Finding()>& body) {
    Check check{.technique = manifest().id,
                .name = name,
                .circumstances = describe(parameters, manifest()) + "; " + describe(where),
                .detail = {},
                .drawn = Check::Drawn{parameters, where}};
    return record(std::move(check), body);
}

bool CheckList::check(const std::string& name, const std::string& circumstances, const std::function<Finding()>& body) {
    return record({.technique = manifest().id, .name = name, .circumstances = circumstances, .detail = {}}, body);
}

void CheckList::skip(const std::string& name, const std::string& circumstances, const std::string& reason) {
    checks_.push_back(
        {.technique = manifest().id, .name = name, .circumstances = circumstances, .skipped = true, .detail = reason});
    if (on_check_) on_check_(checks_.back());
}

bool CheckList::record(Check check, const std::function<Finding()>& body) {
    std::optional<PixelPlace> worst;
    try {
        const Finding finding = body();
        check.passed = finding.passed;
        check.detail = finding.detail;
        worst = finding.worst;
        if (check.drawn && finding.parameters) check.drawn->parameters = *finding.parameters;
    } catch (const OutOfRange& error) {
        check.detail = error.what();
        worst = error.worst;
    } catch (const Error& error) {
        check.detail = error.what();
    }
    if (check.drawn) check.drawn->worst = worst;
    checks_.push_back(check);
    if (on_check_) on_check_(check);
    return check.passed;
}

}  // namespace reliefbench
