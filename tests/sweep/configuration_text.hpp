#pragma once

#include "core/json.hpp"
#include "fake_techniques.hpp"
#include "support/error_message.hpp"
#include "sweep/configuration.hpp"

#include <string>
#include <vector>

namespace reliefbench {

/// Configurations as text, with the techniques of fake_techniques.hpp.
inline Configuration parse(const std::string& text, const std::vector<std::string>& overrides = {}) {
    return parse_configuration(parse_json(text, "test.json"), "test.json", overrides, fake_techniques());
}

inline std::vector<std::string> ids(const Configuration& configuration) {
    std::vector<std::string> found;
    for (const Cell& cell : expand(configuration, fake_techniques()))
        found.push_back(cell.id);
    return found;
}

inline std::string message_of(const std::string& text, const std::vector<std::string>& overrides = {}) {
    return error_message([&] { ids(parse(text, overrides)); });
}

/// A configuration that is right but for `members`.
inline std::string with(const std::string& members, const std::string& techniques = R"(["plain", "march", "tree"])") {
    return R"({"techniques": )" + techniques + R"(, )" + members + "}";
}

inline std::string with_axis(const std::string& axis) {
    return with(R"("axes": {"heightmap": "rock", )" + axis + "}");
}

inline std::string with_member(const std::string& member) {
    return with(R"("axes": {"heightmap": "rock", "view_angle": [0, 60], "azimuth": [0, 45, 90]}, )" + member);
}

}  // namespace reliefbench
