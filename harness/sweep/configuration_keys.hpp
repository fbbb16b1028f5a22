#pragma once

#include <string>
#include <vector>

namespace reliefbench {

/// The keys that each object of a configuration may have. configs/schema.json is tested against them.
namespace configuration_keys {

const std::vector<std::string>& top();
const std::vector<std::string>& technique();
const std::vector<std::string>& truth();
const std::vector<std::string>& sampling();
const std::vector<std::string>& preparation();
const std::vector<std::string>& lighting();
const std::vector<std::string>& light();
const std::vector<std::string>& fog();
const std::vector<std::string>& object();
const std::vector<std::string>& motion();

}  // namespace configuration_keys

}  // namespace reliefbench
