#pragma once

#include "core/json.hpp"
#include "scene/lighting.hpp"
#include "sweep/configuration.hpp"

namespace reliefbench {

/// The parts of a configuration that are no axes. What is left out keeps its default.
TruthSettings read_truth(const JsonView& view);
SamplingSettings read_sampling(const JsonView& view);
PreparationLimit read_preparation(const JsonView& view);
Lighting read_lighting(const JsonView& view);
SceneObject read_object(const JsonView& view);
MotionSettings read_motion(const JsonView& view);

Json to_json(const TruthSettings& truth);
Json to_json(const SamplingSettings& sampling);
Json to_json(const PreparationLimit& preparation);
Json to_json(const Lighting& lighting);
Json to_json(const SceneObject& object);
Json to_json(const MotionSettings& motion);

}  // namespace reliefbench
