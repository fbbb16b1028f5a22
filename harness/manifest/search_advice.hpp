#pragma once

#include "manifest/manifest.hpp"

#include <string>

namespace reliefbench {

/// What to change where searches end by their cap: the parameters that cap them with their values and their ranges, or,
/// where the manifest names none, those that might. Completes "...; ".
std::string advise_longer_search(const Manifest& manifest, const ParameterValues& values);

/// The same where the device ended the loops.
std::string advise_shorter_search(const Manifest& manifest, const ParameterValues& values);

}  // namespace reliefbench
