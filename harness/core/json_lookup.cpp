#include "core/json_lookup.hpp"

#include <fmt/format.h>

namespace reliefbench {

Json value_at(const Json& json, std::initializer_list<const char*> path) {
    const Json* value = &json;
    for (const char* key : path) {
        if (!value->is_object() || !value->contains(key)) return nullptr;
        value = &value->at(key);
    }
    return *value;
}

std::string text_of(const Json& value) {
    if (value.is_null()) return "unknown";
    if (value.is_string()) return value.get<std::string>();
    return value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string scalar_text(const Json& scalar) {
    if (scalar.is_string()) return scalar.get<std::string>();
    if (scalar.is_number_float()) return fmt::format("{}", scalar.get<double>());
    return scalar.dump();
}

}  // namespace reliefbench
