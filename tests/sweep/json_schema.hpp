#pragma once

#include "core/json.hpp"

#include <string>
#include <vector>

namespace reliefbench {

/// Why `value` does not conform to the schema: empty when it does. Knows the keywords that configs/schema.json uses;
/// any other is reported as a complaint, so that none is passed over in silence.
std::vector<std::string> schema_complaints(const Json& root, const Json& schema, const Json& value,
                                           const std::string& path = "$");

}  // namespace reliefbench
