#pragma once

#include "manifest/manifest.hpp"

#include <string>

namespace reliefbench {

/// Why a parameter or a map cannot have this name, as one sentence, or empty when it can: it becomes a GLSL identifier
/// of the same name, beside those of the language and of the harness, and an axis beside those of the view. Axes that
/// came after a contract are no hindrance to techniques of that contract, which stay as they are; a configuration then
/// sets such a parameter by its technique alone (sweep/plan.cpp).
std::string check_glsl_name(const std::string& name, int contract = newest_contract);

}  // namespace reliefbench
