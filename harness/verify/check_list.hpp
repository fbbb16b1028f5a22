#pragma once

#include "verify/circumstance.hpp"
#include "verify/conformance.hpp"
#include "verify/drawing.hpp"

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace reliefbench {

/// What a check found: whether the bound holds, and the figures.
struct Finding {
    bool passed = false;
    std::string detail;
    /// Of a failure: the pixel that shows it most.
    std::optional<PixelPlace> worst = {};
    /// Where several draws were looked at: the parameters of the one that fails.
    std::optional<ParameterValues> parameters = {};
};

/// The technique under test, the scenes it is tested on, and the checks done so far.
class CheckList {
public:
    /// `preparation`: of every picture that a check draws.
    CheckList(const gpu::Device& device, const Technique& technique, const std::function<void(const Check&)>& on_check,
              const PreparationSettings& preparation = {});

    const gpu::Device& device() const { return *device_; }
    const Technique& technique() const { return *technique_; }
    const Manifest& manifest() const { return technique_->manifest; }
    SceneCollection& scenes() { return scenes_; }
    /// δ of r16, measured when first asked for.
    double filter_deviation();
    /// make_renderer, with what is known of maps that cannot be made.
    Renderer make_renderer(const ParameterValues& parameters, const CoordinateScene& scene, const View& view);
    /// The picture beside its truth; NoPicture where it is not the technique's.
    TruthComparison compare(const ParameterValues& parameters, const CoordinateScene& scene, const View& view);
    /// The same, drawn and traced when first asked for: promises look at the same pictures.
    const TruthComparison& comparison(const ParameterValues& parameters, const Circumstance& circumstance);

    /// Runs `body` and records what it found; an Error (a shader that does not compile, a lost device, memory used up)
    /// is a failure with its message, and NoPicture what it says. Returns whether it passed.
    bool check(const std::string& name, const ParameterValues& parameters, const Circumstance& where,
               const std::function<Finding()>& body);
    /// The same of what draws nothing.
    bool check(const std::string& name, const std::string& circumstances, const std::function<Finding()>& body);
    /// Records that nothing can be checked here, and why.
    void skip(const std::string& name, const std::string& circumstances, const std::string& reason);

    std::vector<Check> take() { return std::move(checks_); }

private:
    bool record(Check check, const std::function<Finding()>& body);

    const gpu::Device* device_;
    const Technique* technique_;
    std::function<void(const Check&)> on_check_;
    MapPreparation maps_;
    SceneCollection scenes_;
    double filter_deviation_ = -1;
    std::map<std::string, TruthComparison> comparisons_;
    std::vector<Check> checks_;
};

}  // namespace reliefbench
