#include "verify/check_list.hpp"

#include "core/attempt.hpp"

namespace reliefbench {

CheckList::CheckList(const gpu::Device& device, const Technique& technique,
                     const std::function<void(const Check&)>& on_check, const PreparationSettings& preparation)
    : device_(&device), technique_(&technique), on_check_(on_check), maps_{.settings = preparation}, scenes_(device) {}

double CheckList::filter_deviation() {
    if (filter_deviation_ < 0) filter_deviation_ = measure_filter_deviation(*device_, HeightFormat::r16);
    return filter_deviation_;
}

Renderer CheckList::make_renderer(const ParameterValues& parameters, const CoordinateScene& scene, const View& view) {
    return reliefbench::make_renderer(*device_, *technique_, parameters, scene, view, maps_);
}

TruthComparison CheckList::compare(const ParameterValues& parameters, const CoordinateScene& scene, const View& view) {
    Probe probe = make_renderer(parameters, scene, view).probe();
    require_picture(*device_, *technique_, parameters, probe);
    return beside_truth(std::move(probe), scene, view);
}

const TruthComparison& CheckList::comparison(const ParameterValues& parameters, const Circumstance& circumstance) {
    const std::string key = describe(parameters, manifest()) + "; " + describe(circumstance);
    const auto known = comparisons_.find(key);
    if (known != comparisons_.end()) return known->second;
    const CoordinateScene& scene = scenes_.get(circumstance.map, circumstance.map_size);
    return comparisons_.emplace(key, compare(parameters, scene, circumstance.view)).first->second;
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
    const std::string failure = failure_of([&] {
        try {
            const Finding finding = body();
            check.passed = finding.passed;
            check.detail = finding.detail;
            worst = finding.worst;
            if (check.drawn && finding.parameters) check.drawn->parameters = *finding.parameters;
        } catch (const NoPicture& none) {
            check.skipped = none.skipped;
            check.detail = none.what();
            worst = none.worst;
        }
    });
    if (!failure.empty()) check.detail = failure;
    if (check.drawn) check.drawn->worst = worst;
    checks_.push_back(check);
    if (on_check_) on_check_(check);
    return check.passed;
}

}  // namespace reliefbench
