#pragma once

#include <nlohmann/json.hpp>

#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace reliefbench {

/// Members keep the order of the file: parameters are listed, and cells expanded, in the order their author chose.
using Json = nlohmann::ordered_json;

/// A JSON file that is larger is not read.
inline constexpr std::uint64_t largest_json_file = std::uint64_t{256} << 20;

/// Parses JSON; nothing but white space, a syntax error, a duplicate key, or nesting or an object that is absurdly
/// large is an Error that names `file` and the position.
Json parse_json(std::string_view text, const std::string& file);
Json read_json_file(const std::filesystem::path& path);

/// JSON has neither infinity nor NaN: null, as for no value.
Json finite_or_null(const std::optional<double>& value);

/// A JSON value together with where it stands, so that every complaint names file, JSON path and what was expected.
/// Reading is strict: a wrong type or a value out of range is an Error. Refers to the value; does not own it.
class JsonView {
public:
    /// With an empty path, of what is no file, members are called by their names alone: "lights[0].direction".
    JsonView(const Json& value, std::string file, std::string path = "$");

    const Json& json() const { return *value_; }
    const std::string& file() const { return file_; }
    const std::string& path() const { return path_; }

    /// Of an object. `require_only` refuses unknown keys with a "did you mean".
    void require_only(const std::vector<std::string>& known_keys) const;
    bool has(const std::string& key) const;
    JsonView at(const std::string& key) const;
    std::vector<std::pair<std::string, JsonView>> members() const;

    /// Of an array.
    std::vector<JsonView> items() const;

    std::string string() const;
    bool boolean() const;
    double number(double minimum = std::numeric_limits<double>::lowest(),
                  double maximum = std::numeric_limits<double>::max()) const;
    std::int64_t integer(std::int64_t minimum = std::numeric_limits<std::int64_t>::min(),
                         std::int64_t maximum = std::numeric_limits<std::int64_t>::max()) const;
    /// One of `choices`; returns its index.
    std::size_t choice(const std::vector<std::string>& choices) const;

    /// Throws: "<file>: <path>: expected <expected>, found <value>".
    [[noreturn]] void fail_expected(std::string_view expected) const;
    /// Throws: "<file>: <path>: <message>".
    [[noreturn]] void fail_here(std::string_view message) const;

private:
    const Json* value_;
    std::string file_;
    std::string path_;
};

}  // namespace reliefbench
