#include "core/json.hpp"

#include "core/counted.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "core/suggest.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace reliefbench {

namespace {

/// Reads characters and tells how far the parser has come.
class CountingIterator {
public:
    using iterator_category = std::input_iterator_tag;
    using value_type = char;
    using difference_type = std::ptrdiff_t;
    using pointer = const char*;
    using reference = const char&;

    CountingIterator(const char* position, const char** furthest) : position_(position), furthest_(furthest) {}

    reference operator*() const { return *position_; }
    CountingIterator& operator++() {
        *furthest_ = ++position_;
        return *this;
    }
    CountingIterator operator++(int) {
        const CountingIterator before = *this;
        ++*this;
        return before;
    }
    bool operator==(const CountingIterator& other) const { return position_ == other.position_; }

private:
    const char* position_;
    const char** furthest_;
};

/// "line:column", both from 1; columns count bytes.
std::string line_and_column(std::string_view text, std::size_t offset) {
    const std::string_view before = text.substr(0, std::min(offset, text.size()));
    const auto line = 1 + std::count(before.begin(), before.end(), '\n');
    const std::size_t line_start = before.rfind('\n') + 1;  // npos + 1 == 0
    return fmt::format("{}:{}", line, before.size() - line_start + 1);
}

/// Where the string starts whose closing quote is the last character before `end`.
std::size_t start_of_string(std::string_view text, std::size_t end) {
    std::size_t quote = end - 1;
    for (;;) {
        quote = text.rfind('"', quote - 1);
        std::size_t backslashes = 0;
        while (backslashes < quote && text[quote - 1 - backslashes] == '\\')
            ++backslashes;
        if (backslashes % 2 == 0) return quote;
    }
}

/// The library's message without its code and position.
std::string syntax_message(const std::string& message) {
    for (const std::string_view lead : {": ", "] "}) {
        const std::size_t found = message.find(lead);
        if (found != std::string::npos) return message.substr(found + lead.size());
    }
    return message;
}

constexpr std::size_t longest_value_shown = 60;

/// Far above what any of our files has. What reads values goes down as deep as they are; members of one object are
/// looked for one after the other.
constexpr int deepest_nesting = 64;
constexpr std::size_t max_members = 10000;

std::string shown(const Json& value) {
    std::string text = value.dump(-1, ' ', false, Json::error_handler_t::replace);
    if (text.size() <= longest_value_shown) return text;
    if (value.is_object()) return fmt::format("an object with {}", counted(value.size(), "member"));
    if (value.is_array()) return fmt::format("an array of {}", counted(value.size(), "value"));
    return text.substr(0, longest_value_shown) + "...";
}

std::string member_path(const std::string& path, const std::string& key) {
    const bool plain = !key.empty() && std::all_of(key.begin(), key.end(), [](unsigned char character) {
        return std::isalnum(character) != 0 || character == '_' || character == '-';
    });
    if (path.empty() && plain) return key;
    return plain ? path + "." + key : path + "[" + shown(Json(key)) + "]";
}

}  // namespace

Json parse_json(std::string_view text, const std::string& file) {
    if (text.find_first_not_of(" \t\r\n") == std::string_view::npos) fail("{}: it is empty; expected JSON", file);
    const char* position = text.data();
    std::vector<std::set<std::string>> keys_of_open_objects;
    const auto here = [&](std::size_t back = 0) {
        return line_and_column(text, static_cast<std::size_t>(position - text.data()) - back);
    };
    const auto check = [&](int depth, Json::parse_event_t event, Json& parsed) {
        if (depth >= deepest_nesting) fail("{}:{}: nested more than {} deep", file, here(1), deepest_nesting);
        if (event == Json::parse_event_t::object_start) keys_of_open_objects.emplace_back();
        if (event == Json::parse_event_t::object_end) keys_of_open_objects.pop_back();
        if (event != Json::parse_event_t::key) return true;
        if (!keys_of_open_objects.back().insert(parsed).second) {
            const std::size_t key = start_of_string(text, static_cast<std::size_t>(position - text.data()));
            fail("{}:{}: duplicate key {}", file, line_and_column(text, key), shown(parsed));
        }
        if (keys_of_open_objects.back().size() > max_members) {
            fail("{}:{}: an object with more than {} members", file, here(), max_members);
        }
        return true;
    };
    try {
        const char* end = text.data() + text.size();
        return Json::parse(CountingIterator(text.data(), &position), CountingIterator(end, &position), check);
    } catch (const Json::parse_error& error) {
        fail("{}:{}: {}", file, line_and_column(text, error.byte - 1), syntax_message(error.what()));
    } catch (const Json::exception& error) {  // a number that no double holds
        fail("{}:{}: {}", file, here(), syntax_message(error.what()));
    }
}

Json read_json_file(const std::filesystem::path& path) {
    return parse_json(read_text_file(path, largest_json_file), path.string());
}

Json finite_or_null(const std::optional<double>& value) {
    return value && std::isfinite(*value) ? Json(*value) : Json(nullptr);
}

JsonView::JsonView(const Json& value, std::string file, std::string path)
    : value_(&value), file_(std::move(file)), path_(std::move(path)) {}

void JsonView::require_only(const std::vector<std::string>& known_keys) const {
    if (!value_->is_object()) fail_expected("an object");
    for (const auto& [key, value] : value_->items()) {
        if (std::find(known_keys.begin(), known_keys.end(), key) != known_keys.end()) continue;
        const std::string suggestion = did_you_mean(key, known_keys);
        const std::string help = suggestion.empty() ? fmt::format(" (known keys: {})", join(known_keys)) : suggestion;
        fail_here(fmt::format("unknown key {}{}", shown(Json(key)), help));
    }
}

bool JsonView::has(const std::string& key) const {
    if (!value_->is_object()) fail_expected("an object");
    return value_->contains(key);
}

JsonView JsonView::at(const std::string& key) const {
    if (!has(key)) fail_here(fmt::format("key {} is missing", shown(Json(key))));
    return {value_->at(key), file_, member_path(path_, key)};
}

std::vector<std::pair<std::string, JsonView>> JsonView::members() const {
    if (!value_->is_object()) fail_expected("an object");
    std::vector<std::pair<std::string, JsonView>> members;
    for (const auto& [key, value] : value_->items()) {
        members.emplace_back(key, JsonView(value, file_, member_path(path_, key)));
    }
    return members;
}

std::vector<JsonView> JsonView::items() const {
    if (!value_->is_array()) fail_expected("an array");
    std::vector<JsonView> items;
    for (const Json& value : *value_) {
        items.emplace_back(value, file_, fmt::format("{}[{}]", path_, items.size()));
    }
    return items;
}

std::string JsonView::string() const {
    if (!value_->is_string()) fail_expected("a string");
    return value_->get<std::string>();
}

bool JsonView::boolean() const {
    if (!value_->is_boolean()) fail_expected("true or false");
    return value_->get<bool>();
}

double JsonView::number(double minimum, double maximum) const {
    const bool has_minimum = minimum > std::numeric_limits<double>::lowest();
    const bool has_maximum = maximum < std::numeric_limits<double>::max();
    if (value_->is_number()) {
        const double number = value_->get<double>();
        if (std::isfinite(number) && number >= minimum && number <= maximum) return number;
    }
    if (has_minimum && has_maximum) fail_expected(fmt::format("a number from {} to {}", minimum, maximum));
    if (has_minimum) fail_expected(fmt::format("a number of at least {}", minimum));
    if (has_maximum) fail_expected(fmt::format("a number of at most {}", maximum));
    fail_expected("a number");
}

std::int64_t JsonView::integer(std::int64_t minimum, std::int64_t maximum) const {
    const bool has_minimum = minimum > std::numeric_limits<std::int64_t>::min();
    const bool has_maximum = maximum < std::numeric_limits<std::int64_t>::max();
    const bool too_large = value_->is_number_unsigned() && value_->get<std::uint64_t>() > INT64_MAX;
    if (value_->is_number_integer() && !too_large) {
        const auto integer = value_->get<std::int64_t>();
        if (integer >= minimum && integer <= maximum) return integer;
    }
    if (has_minimum && has_maximum) fail_expected(fmt::format("an integer from {} to {}", minimum, maximum));
    if (has_minimum) fail_expected(fmt::format("an integer of at least {}", minimum));
    if (has_maximum) fail_expected(fmt::format("an integer of at most {}", maximum));
    fail_expected("an integer");
}

std::size_t JsonView::choice(const std::vector<std::string>& choices) const {
    if (value_->is_string()) {
        const auto& text = value_->get_ref<const std::string&>();
        const auto found = std::find(choices.begin(), choices.end(), text);
        if (found != choices.end()) return static_cast<std::size_t>(found - choices.begin());
        fail_here(
            fmt::format("expected one of {}, found {}{}", join(choices), shown(*value_), did_you_mean(text, choices)));
    }
    fail_expected("one of " + join(choices));
}

void JsonView::fail_expected(std::string_view expected) const {
    fail_here(fmt::format("expected {}, found {}", expected, shown(*value_)));
}

void JsonView::fail_here(std::string_view message) const {
    fail("{}: {}{}{}", file_, path_, path_.empty() ? "" : ": ", message);
}

}  // namespace reliefbench
