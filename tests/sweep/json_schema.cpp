#include "json_schema.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <regex>

namespace reliefbench {

namespace {

bool has_type(const Json& value, const std::string& type) {
    if (type == "object") return value.is_object();
    if (type == "array") return value.is_array();
    if (type == "string") return value.is_string();
    if (type == "boolean") return value.is_boolean();
    if (type == "integer") {
        return value.is_number_integer() ||
               (value.is_number() && std::trunc(value.get<double>()) == value.get<double>());
    }
    return type == "number" && value.is_number();
}

bool is_annotation(const std::string& keyword) {
    const std::vector<std::string> known{"$schema", "$id", "$defs", "title", "description", "default"};
    return std::ranges::find(known, keyword) != known.end();
}

bool number_conforms(const std::string& keyword, double bound, double number) {
    if (keyword == "minimum") return number >= bound;
    if (keyword == "maximum") return number <= bound;
    if (keyword == "exclusiveMinimum") return number > bound;
    return number < bound;
}

class Validator {
public:
    Validator(const Json& root, const Json& schema, const Json& value, std::string path)
        : root_(root), schema_(schema), value_(value), path_(std::move(path)) {}

    std::vector<std::string> complaints() {
        if (schema_.is_boolean()) {
            require(schema_.get<bool>(), "false");
            return found_;
        }
        for (const auto& [keyword, argument] : schema_.items()) {
            if (!is_annotation(keyword)) check(keyword, argument);
        }
        return found_;
    }

private:
    void check(const std::string& keyword, const Json& argument) {
        if (keyword == "$ref") {
            const std::string pointer = argument.get<std::string>().substr(1);
            nest(root_.at(Json::json_pointer(pointer)), value_, path_);
        } else if (keyword == "type") {
            const Json types = argument.is_array() ? argument : Json::array({argument});
            require(std::ranges::any_of(types, [&](const Json& type) { return has_type(value_, type); }), keyword);
        } else if (keyword == "enum") {
            require(std::ranges::find(argument, value_) != argument.end(), keyword);
        } else if (keyword == "oneOf") {
            const auto matches = std::ranges::count_if(
                argument, [&](const Json& option) { return schema_complaints(root_, option, value_, path_).empty(); });
            require(matches == 1, fmt::format("{} ({} of them hold)", keyword, matches));
        } else if (keyword == "minimum" || keyword == "maximum" || keyword == "exclusiveMinimum" ||
                   keyword == "exclusiveMaximum") {
            if (!value_.is_number()) return;
            require(number_conforms(keyword, argument.get<double>(), value_.get<double>()), keyword);
        } else if (keyword == "pattern" || keyword == "minLength") {
            check_string(keyword, argument);
        } else if (keyword == "items" || keyword == "minItems" || keyword == "maxItems") {
            check_array(keyword, argument);
        } else {
            check_object(keyword, argument);
        }
    }

    void check_string(const std::string& keyword, const Json& argument) {
        if (!value_.is_string()) return;
        const auto& text = value_.get_ref<const std::string&>();
        if (keyword == "minLength") {
            require(text.size() >= argument.get<std::size_t>(), keyword);
        } else {
            require(std::regex_search(text, std::regex(argument.get<std::string>())), keyword);
        }
    }

    void check_array(const std::string& keyword, const Json& argument) {
        if (!value_.is_array()) return;
        if (keyword == "minItems") require(value_.size() >= argument.get<std::size_t>(), keyword);
        if (keyword == "maxItems") require(value_.size() <= argument.get<std::size_t>(), keyword);
        if (keyword != "items") return;
        for (std::size_t index = 0; index < value_.size(); ++index) {
            nest(argument, value_[index], fmt::format("{}[{}]", path_, index));
        }
    }

    void check_object(const std::string& keyword, const Json& argument) {
        if (keyword == "required") {
            for (const Json& key : argument) {
                if (value_.is_object()) require(value_.contains(key.get<std::string>()), "required " + key.dump());
            }
        } else if (keyword == "minProperties") {
            if (value_.is_object()) require(value_.size() >= argument.get<std::size_t>(), keyword);
        } else if (keyword == "properties" || keyword == "additionalProperties") {
            if (!value_.is_object()) return;
            const Json named = schema_.value("properties", Json::object());
            for (const auto& [key, member] : value_.items()) {
                const std::string place = path_ + "." + key;
                if (keyword == "properties" && named.contains(key)) nest(named.at(key), member, place);
                if (keyword == "properties" || named.contains(key)) continue;
                if (argument.is_boolean()) {
                    if (!argument.get<bool>()) found_.push_back(place + ": unknown key");
                } else {
                    nest(argument, member, place);
                }
            }
        } else {
            found_.push_back("the validator of the tests does not know the keyword " + keyword);
        }
    }

    void require(bool holds, const std::string& what) {
        if (!holds) found_.push_back(fmt::format("{}: {} does not hold for {}", path_, what, value_.dump()));
    }

    void nest(const Json& schema, const Json& value, const std::string& path) {
        for (std::string& complaint : schema_complaints(root_, schema, value, path)) {
            found_.push_back(std::move(complaint));
        }
    }

    const Json& root_;
    const Json& schema_;
    const Json& value_;
    std::string path_;
    std::vector<std::string> found_;
};

}  // namespace

std::vector<std::string> schema_complaints(const Json& root, const Json& schema, const Json& value,
                                           const std::string& path) {
    return Validator(root, schema, value, path).complaints();
}

}  // namespace reliefbench
