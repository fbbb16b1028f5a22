#include "report/flat_fields.hpp"

namespace reliefbench {

namespace {

void flatten(const Json& value, const std::string& path, FlatFields& fields) {
    if (value.is_object()) {
        for (const auto& [key, member] : value.items()) {
            flatten(member, path.empty() ? key : path + "." + key, fields);
        }
    } else if (value.is_array()) {
        // Arrays of two are intervals.
        constexpr const char* bounds[] = {".low", ".high"};
        for (std::size_t index = 0; index < value.size(); ++index) {
            flatten(value[index], path + (value.size() == 2 ? bounds[index] : "." + std::to_string(index)), fields);
        }
    } else {
        fields.emplace_back(path, value);
    }
}

}  // namespace

FlatFields flat_fields(const CellResult& cell) {
    FlatFields fields;
    flatten(to_json(cell), "", fields);
    return fields;
}

}  // namespace reliefbench
