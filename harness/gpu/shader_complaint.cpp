#include "gpu/shader_complaint.hpp"

#include "core/suggest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace reliefbench::gpu {

namespace {

using Declaration = GlslDeclaration;

std::string trimmed_text(std::string_view text) {
    constexpr std::string_view blanks = " \t\r\n";
    const std::size_t begin = text.find_first_not_of(blanks);
    if (begin == std::string_view::npos) return {};
    return std::string(text.substr(begin, text.find_last_not_of(blanks) + 1 - begin));
}

/// "trace.glsl:4: 'z' : undeclared identifier ", in parts. A linker's has none but its message.
LogComplaint complaint_of_line(std::string_view line) {
    LogComplaint complaint;
    const std::size_t quote = line.find(": '");
    const std::size_t end = quote == std::string_view::npos ? quote : line.find("' :", quote + 3);
    const std::size_t colon = end == std::string_view::npos ? end : line.rfind(':', quote - 1);
    if (colon == std::string_view::npos || quote == 0) {
        complaint.message = trimmed_text(line);
        return complaint;
    }
    complaint.place.file = line.substr(0, colon);
    complaint.place.line = std::atoi(std::string(line.substr(colon + 1, quote - colon - 1)).c_str());
    complaint.symbol = line.substr(quote + 3, end - quote - 3);
    complaint.message = trimmed_text(line.substr(end + 3));
    return complaint;
}

/// bison's names of GLSL's tokens, as they are written.
std::string written_token(const std::string& name) {
    static constexpr std::array<std::pair<std::string_view, std::string_view>, 16> names{{
        {"SEMICOLON", "';'"},
        {"COMMA", "','"},
        {"COLON", "':'"},
        {"DOT", "'.'"},
        {"EQUAL", "'='"},
        {"LEFT_PAREN", "'('"},
        {"RIGHT_PAREN", "')'"},
        {"LEFT_BRACE", "'{'"},
        {"RIGHT_BRACE", "'}'"},
        {"LEFT_BRACKET", "'['"},
        {"RIGHT_BRACKET", "']'"},
        {"IDENTIFIER", "a name"},
        {"TYPE_NAME", "a type"},
        {"WHILE", "'while'"},
        {"INTCONSTANT", "a number"},
        {"FLOATCONSTANT", "a number"},
    }};
    for (const auto& [token, written] : names) {
        if (token == name) return std::string(written);
    }
    return name;
}

/// "',' or ';'" of "syntax error, unexpected FOR, expecting COMMA or SEMICOLON"; empty where it does not say.
std::string expected_tokens(const std::string& message) {
    constexpr std::string_view word = "expecting ";
    const std::size_t begin = message.find(word);
    if (begin == std::string::npos) return {};
    std::string_view rest = std::string_view(message).substr(begin + word.size());
    std::string text;
    while (!rest.empty()) {
        const std::size_t end = std::min(rest.find(" or "), rest.size());
        text += (text.empty() ? "" : " or ") + written_token(std::string(rest.substr(0, end)));
        rest.remove_prefix(std::min(end + 4, rest.size()));
    }
    return text;
}

/// Types as glslang prints them, ' temp highp int', without what nobody wrote: 'int'.
std::string without_qualifiers(const std::string& message) {
    constexpr std::string_view qualifiers = " const temp global in out inout uniform highp mediump lowp flat smooth ";
    std::string text;
    bool quoted = false;
    for (std::size_t begin = 0; begin < message.size();) {
        const std::size_t end = std::min(message.find('\'', begin), message.size());
        std::string part = message.substr(begin, end - begin);
        if (quoted) {
            std::string kept;
            for (std::size_t word = 0; word < part.size();) {
                const std::size_t space = std::min(part.find(' ', word), part.size());
                const std::string name = part.substr(word, space - word);
                if (!name.empty() && qualifiers.find(" " + name + " ") == std::string_view::npos)
                    kept += (kept.empty() ? "" : " ") + name;
                word = space + 1;
            }
            part = kept;
        }
        text += part;
        if (end < message.size()) text += '\'';
        quoted = !quoted;
        begin = end + 1;
    }
    return text;
}

/// What comes after a marker in the text; empty where the marker is not there.
std::string text_after(const std::string& text, std::string_view marker) {
    const std::size_t at = text.find(marker);
    return at == std::string::npos ? std::string() : trimmed_text(text.substr(at + marker.size()));
}

std::string place_words(const SourcePlace& place) {
    return fmt::format("{}:{}", place.file, place.line);
}

std::vector<const Declaration*> functions_named(const FlatShader& shader, const std::string& name) {
    std::vector<const Declaration*> found;
    for (const Declaration& declared : shader.declarations()) {
        if (declared.kind == Declaration::Kind::function && declared.name == name) found.push_back(&declared);
    }
    return found;
}

std::vector<std::string> names_of_kind(const FlatShader& shader, Declaration::Kind kind) {
    std::vector<std::string> names;
    for (const Declaration& declared : shader.declarations()) {
        if (declared.kind == kind) names.push_back(declared.name);
    }
    return names;
}

/// Names that may have been meant at the token: all global ones, and what else its function has named before.
std::vector<std::string> names_before(const FlatShader& shader, std::size_t token) {
    std::size_t function_begin = 0;
    std::vector<std::string> names;
    for (const Declaration& declared : shader.declarations()) {
        if (declared.token > token) continue;
        names.push_back(declared.name);
        if (declared.has_body) function_begin = declared.token;
    }
    for (std::size_t i = function_begin; i < token; ++i) {
        const GlslToken& before = shader.tokens()[i];
        if (before.kind == GlslToken::Kind::word && before.text != shader.tokens()[token].text)
            names.push_back(before.text);
    }
    return names;
}

/// Whether the token is an argument for a parameter that is a sampler, of a function declared or of GLSL's own.
bool is_sampler_argument(const FlatShader& shader, std::size_t token) {
    std::size_t commas = 0;
    int depth = 0;
    std::size_t i = token;
    while (i > 0) {
        const GlslToken& before = shader.tokens()[--i];
        if (before.is(";") || before.is("{") || before.is("}")) return false;
        if (before.is(")")) ++depth;
        if (before.is(",") && depth == 0) ++commas;
        if (before.is("(") && depth-- == 0) break;
    }
    if (i == 0) return false;
    const std::string& function = shader.tokens()[i - 1].text;
    if (commas == 0 && (function.starts_with("texture") || function.starts_with("texel"))) return true;
    for (const Declaration* declared : functions_named(shader, function)) {
        std::string_view parameters = declared->text;
        parameters.remove_prefix(parameters.find('(') + 1);
        for (std::size_t skipped = 0; skipped < commas && !parameters.empty(); ++skipped)
            parameters.remove_prefix(
                std::min(std::min(parameters.find(','), parameters.size() - 1) + 1, parameters.size()));
        if (trimmed_text(parameters).starts_with("sampler")) return true;
    }
    return false;
}

std::string undeclared(const std::string& name, const FlatShader& shader, std::size_t token) {
    if (!is_sampler_argument(shader, token))
        return fmt::format("'{}' is not declared{}", name,
                           name.size() < 3 ? "" : did_you_mean(name, names_before(shader, token)));
    std::vector<std::string> maps;
    std::vector<std::string> quoted;
    for (const Declaration& declared : shader.declarations()) {
        // Of the front: the technique's own.
        const bool is_map =
            declared.text.find("sampler") != std::string::npos && shader.place(declared.token).file.empty();
        if (declared.kind != Declaration::Kind::variable || !is_map) continue;
        maps.push_back(declared.name);
        quoted.push_back("'" + declared.name + "'");
    }
    const std::string there = maps.empty()       ? "no map is declared that could be read here"
                              : maps.size() == 1 ? "the map that can be read here is " + quoted.front()
                                                 : "the maps that can be read here are " + join(quoted);
    return fmt::format("no map '{}' is declared{}; {}", name, did_you_mean(name, maps), there);
}

std::string no_function(const std::string& name, const FlatShader& shader) {
    const std::vector<const Declaration*> same = functions_named(shader, name);
    std::vector<std::string> signatures;
    for (const Declaration* declared : same) {
        const std::string quoted = "'" + declared->text + "'";
        if (std::ranges::find(signatures, quoted) == signatures.end()) signatures.push_back(quoted);
    }
    if (!signatures.empty()) return fmt::format("'{}' takes other arguments: {}", name, join(signatures));
    return fmt::format("there is no function '{}' that takes these arguments{}", name,
                       did_you_mean(name, names_of_kind(shader, Declaration::Kind::function)));
}

/// For a type that is none.
std::string type_meant(const std::string& name, const FlatShader& shader) {
    std::vector<std::string> types{"float", "int",   "uint",  "bool",  "void",  "vec2", "vec3",      "vec4",
                                   "ivec2", "ivec3", "ivec4", "uvec4", "bvec2", "mat4", "sampler2D", "const"};
    const std::vector<std::string> declared = names_of_kind(shader, Declaration::Kind::type);
    types.insert(types.end(), declared.begin(), declared.end());
    return did_you_mean(name, types);
}

WordedComplaint syntax_error(const std::string& message, const FlatShader& shader, std::size_t token) {
    const std::vector<GlslToken>& tokens = shader.tokens();
    const std::string expected = expected_tokens(message);
    const GlslToken& unexpected = tokens[token];
    const auto is_word = [&](std::size_t i) { return i < tokens.size() && tokens[i].kind == GlslToken::Kind::word; };
    if (expected.empty() && is_word(token) && is_word(token + 1))
        return {fmt::format("'{}' is no type{}", unexpected.text, type_meant(unexpected.text, shader)), token};
    const bool has_previous = token > 0 && !shader.place(token - 1).file.empty();
    if (!has_previous) return {fmt::format("'{}' is not expected here", unexpected.text), token};
    const GlslToken& previous = tokens[token - 1];
    if (expected.empty())
        return {fmt::format("'{}' is not expected after '{}'", unexpected.text, previous.text), token};
    const SourcePlace here = shader.place(token);
    const SourcePlace there = shader.place(token - 1);
    const bool on_one_line = here.line == there.line && here.file == there.file;
    if (!on_one_line && expected.find("';'") != std::string::npos)
        return {fmt::format("a ';' is missing after '{}'", previous.text), token - 1, true};
    const bool begins_body = unexpected.is("{") && previous.is(")");
    return {fmt::format("expected {} after '{}', not '{}'{}", expected, previous.text, unexpected.text,
                        begins_body ? "; no function can be defined within another" : ""),
            token};
}

/// Where the word stands in the statement that the token is in, before it: glslang names some words only when it has
/// read on. Else the token.
std::size_t token_of_word(const std::string& word, const FlatShader& shader, std::size_t token) {
    for (std::size_t i = token + 1; i-- > 0;) {
        const GlslToken& before = shader.tokens()[i];
        if (before.kind == GlslToken::Kind::word && before.text == word) return i;
        if (i < token && (before.is(";") || before.is("}"))) break;
    }
    return token;
}

/// The function whose body holds the token.
const Declaration* function_around(const FlatShader& shader, std::size_t token) {
    const Declaration* around = nullptr;
    for (const Declaration& declared : shader.declarations()) {
        if (declared.has_body && declared.token < token) around = &declared;
    }
    return around;
}

std::string defined_already(const std::string& name, const FlatShader& shader, std::size_t token) {
    for (const Declaration* declared : functions_named(shader, name)) {
        if (declared->has_body && declared->token < token)
            return fmt::format("'{}' is defined already, in {}", declared->text,
                               place_words(shader.place(declared->token)));
    }
    return fmt::format("'{}' is defined already", name);
}

/// Up to the parenthesis that glslang's own notation of the arguments begins with.
std::string function_name(const std::string& mangled) {
    return trimmed_text(mangled.substr(0, mangled.find('(')));
}

WordedComplaint undefined_function(const std::string& name, const FlatShader& shader) {
    const Declaration* wanted = nullptr;
    const Declaration* other = nullptr;
    std::vector<std::string> defined;
    for (const Declaration& declared : shader.declarations()) {
        if (declared.kind != Declaration::Kind::function) continue;
        if (declared.name == name && !declared.has_body && !wanted) wanted = &declared;
        if (declared.name == name && declared.has_body) other = &declared;
        if (declared.has_body) defined.push_back(declared.name);
    }
    if (!wanted) return {fmt::format("nothing defines the function '{}'", name)};
    const std::string what =
        fmt::format("nothing defines '{}', which {} declares", wanted->text, place_words(shader.place(wanted->token)));
    if (other) return {fmt::format("{}; this is '{}'", what, other->text), other->token};
    const std::string meant = did_you_mean(name, defined);
    WordedComplaint worded{what + meant};
    for (const Declaration& declared : shader.declarations()) {
        if (declared.has_body && meant.find("'" + declared.name + "'") != std::string::npos)
            worded.about = declared.token;
    }
    return worded;
}

}  // namespace

std::optional<LogComplaint> first_complaint(std::string_view log) {
    constexpr std::string_view prefix = "ERROR: ";
    std::optional<LogComplaint> complaint;
    while (!log.empty()) {
        const std::size_t end = std::min(log.find('\n'), log.size());
        std::string_view line = log.substr(0, end);
        log.remove_prefix(std::min(end + 1, log.size()));
        if (line.starts_with(prefix)) {
            if (complaint) break;
            complaint = complaint_of_line(line.substr(prefix.size()));
        } else if (complaint && !trimmed_text(line).empty()) {
            complaint->message += " " + trimmed_text(line);
        }
    }
    return complaint;
}

std::string in_words(const LogComplaint& complaint) {
    const auto& [place, symbol, message] = complaint;
    // Of an include that failed, after the reason that the includer gave.
    const std::size_t header = message.find(" for header name: ");
    if (header != std::string::npos) return message.substr(0, header);
    if (symbol == "#version") return "the harness gives '#version' itself; leave it out";
    if (symbol == "#error") return "#error " + message;
    if (message.starts_with("invalid directive"))
        return fmt::format("there is no directive '#{}'", text_after(message, ":"));
    if (symbol == "string literal") return "GLSL has no texts between quotation marks";
    if (symbol == "comment") return "a comment begins here that has no '*/'";
    if (message == "mismatched statements") return fmt::format("'{}' has no '#if' before it", symbol);
    const std::string words = without_qualifiers(message);
    return symbol.empty() ? words : fmt::format("'{}': {}", symbol, words);
}

WordedComplaint in_words(const LogComplaint& complaint, const FlatShader& shader, std::size_t token) {
    const auto& [place, symbol, message] = complaint;
    if (message.starts_with("syntax error")) return syntax_error(message, shader, token);
    const std::size_t named = token_of_word(symbol, shader, token);
    if (message == "undeclared identifier") return {undeclared(symbol, shader, named), named};
    if (message.starts_with("no matching overloaded function")) return {no_function(symbol, shader), named};
    if (message == "function already has a body") return {defined_already(symbol, shader, named), named};
    if (message == "redefinition") return {fmt::format("'{}' is declared a second time", symbol), named};
    if (message.starts_with("function does not return a value")) {
        const std::string name = text_after(message, ":");
        return {fmt::format("the function '{}' returns no value", name), token_of_word(name, shader, token)};
    }
    if (message.starts_with("type does not match, or is not convertible to, the function's return type")) {
        const Declaration* function = function_around(shader, token);
        return {fmt::format("what is returned is not what '{}' returns", function ? function->text : "the function"),
                token};
    }
    if (message.starts_with("l-value required")) {
        const std::size_t begin = message.find('"');
        const std::size_t end = message.find('"', begin + 1);
        const std::string name = end == std::string::npos ? symbol : message.substr(begin + 1, end - begin - 1);
        std::string why = text_after(message, "can't modify a ");
        if (!why.empty() && why.back() == ')') why.pop_back();
        return {fmt::format("'{}' cannot be changed{}", name, why.empty() ? "" : ": it is a " + why),
                token_of_word(name, shader, token)};
    }
    if (message == "vector swizzle selection out of range")
        return {fmt::format("'{}' names components that the vector does not have", symbol), named};
    return {in_words(complaint), named};
}

WordedComplaint linker_in_words(const LogComplaint& complaint, const FlatShader& shader, const std::string& main_file) {
    const std::string& message = complaint.message;
    const std::string undefined = text_after(message, "No function definition (body) found:");
    if (!undefined.empty()) return undefined_function(function_name(undefined), shader);
    const std::string cycle = text_after(message, "Recursion detected:");
    if (!cycle.empty()) {
        const std::string from = function_name(cycle);
        const std::string to = function_name(text_after(cycle, " calling "));
        const std::vector<const Declaration*> functions = functions_named(shader, from);
        const auto defined = std::ranges::find_if(functions, &Declaration::has_body);
        WordedComplaint worded{
            from == to ? fmt::format("'{}' calls itself; GLSL has no recursion", from)
                       : fmt::format("'{}' calls '{}', which leads back to it; GLSL has no recursion", from, to)};
        if (defined != functions.end()) worded.about = (*defined)->token;
        return worded;
    }
    if (message.find("Missing entry point") != std::string::npos) return {main_file + ": there is no 'void main()'"};
    return {main_file + ": " + message};
}

}  // namespace reliefbench::gpu
