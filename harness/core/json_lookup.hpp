#pragma once

#include "core/json.hpp"

#include <initializer_list>
#include <string>

namespace reliefbench {

/// The member of a record at the end of the path. Null where one on the way is missing: records of other versions lack
/// some.
Json value_at(const Json& json, std::initializer_list<const char*> path);

/// A value of a record as a reader wants it: strings without quotes, "unknown" for null.
std::string text_of(const Json& value);

/// A scalar as ids write it: numbers in the shortest form that reads back equal.
std::string scalar_text(const Json& scalar);

}  // namespace reliefbench
