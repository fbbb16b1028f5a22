#pragma once

#include <string>

namespace reliefbench {

/// Why a parameter or a map cannot have this name, as one sentence, or empty when it can: it becomes a GLSL identifier
/// of the same name, beside those of the language and of the harness, and an axis beside those of the view.
std::string check_glsl_name(const std::string& name);

}  // namespace reliefbench
