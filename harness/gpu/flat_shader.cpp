#include "gpu/flat_shader.hpp"

#include <algorithm>
#include <cstdlib>
#include <iterator>

namespace reliefbench::gpu {

namespace {

/// Of "#line 8 \"relief.glsl\"": what the next line is.
SourcePlace named_place(const GlslDirective& directive) {
    const std::size_t open = directive.rest.find('"');
    const std::size_t close = directive.rest.rfind('"');
    const std::string file = open < close ? directive.rest.substr(open + 1, close - open - 1) : std::string();
    return {file, std::atoi(directive.rest.c_str()), 0};
}

std::string_view line_of(std::string_view source, int line) {
    for (; line > 1; --line) {
        const std::size_t end = source.find('\n');
        if (end == std::string_view::npos) return {};
        source.remove_prefix(end + 1);
    }
    source = source.substr(0, source.find('\n'));
    if (!source.empty() && source.back() == '\r') source.remove_suffix(1);
    return source;
}

/// Bytes after the first of a character in UTF-8.
bool continues_character(char c) {
    return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;
}

}  // namespace

FlatShader::FlatShader(std::string_view preprocessed, int front_lines, const std::string& main_file) {
    // The place of line `base` of the text; those after it follow on.
    SourcePlace place{main_file, 1, 0};
    int base = front_lines + 1;
    for (GlslToken& token : glsl_tokens(preprocessed)) {
        const GlslDirective directive = glsl_directive(token);
        if (directive.name == "line") {
            SourcePlace named = named_place(directive);
            if (named.file.empty()) named.file = place.file;
            place = std::move(named);
            base = token.line + 1;
            continue;
        }
        const bool of_front = token.line < base;
        places_.push_back(of_front ? SourcePlace{} : SourcePlace{place.file, place.line + token.line - base, 0});
        tokens_.push_back(std::move(token));
    }
    declarations_ = glsl_declarations(tokens_);
}

std::string FlatShader::one_token_per_line() const {
    std::string text;
    for (const GlslToken& token : tokens_)
        text += token.text + '\n';
    return text;
}

int FlatShader::earlier_on_its_line(std::size_t token) const {
    int count = 0;
    const auto on_same_line = [&](std::size_t other) {
        return places_[other].line == places_[token].line && places_[other].file == places_[token].file;
    };
    for (std::size_t i = token; i > 0 && on_same_line(i - 1); --i) {
        if (tokens_[i - 1].text == tokens_[token].text) ++count;
    }
    return count;
}

std::optional<std::size_t> FlatShader::unbalanced_brace() const {
    std::vector<std::size_t> open;
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
        if (tokens_[i].is("{")) open.push_back(i);
        if (!tokens_[i].is("}")) continue;
        if (open.empty()) return i;
        open.pop_back();
    }
    if (open.empty()) return std::nullopt;
    return open.front();
}

int column_of(std::string_view source, int line, std::string_view text, int n) {
    int first = 1;
    bool is_first = true;
    for (const GlslToken& token : glsl_tokens(source)) {
        if (token.line != line) continue;
        if (is_first) first = token.column;
        is_first = false;
        if (token.text == text && n-- == 0) return token.column;
    }
    return first;
}

std::string show_line(std::string_view source, int line, int column) {
    constexpr std::size_t widest = 110;
    constexpr std::size_t before_caret = 70;
    constexpr std::string_view indent = "    ";
    std::string_view text = line_of(source, line);
    if (line < 1 || text.empty()) return {};
    const std::size_t first = std::min(text.find_first_not_of(" \t"), text.size());
    std::size_t caret = column < 1 ? first : std::min<std::size_t>(static_cast<std::size_t>(column) - 1, text.size());
    std::string shown(indent);
    if (text.size() > widest) {
        std::size_t begin = caret > before_caret ? caret - before_caret : 0;
        while (begin > 0 && continues_character(text[begin]))
            --begin;
        std::size_t end = std::min(begin + widest, text.size());
        while (end < text.size() && continues_character(text[end]))
            ++end;
        if (begin > 0) shown += "...";
        text = text.substr(begin, end - begin);
        caret -= begin;
    }
    std::string pointer(shown.size(), ' ');
    for (std::size_t i = 0; i < caret; ++i) {
        if (!continues_character(text[i])) pointer += text[i] == '\t' ? '\t' : ' ';
    }
    std::ranges::replace_copy_if(
        text, std::back_inserter(shown), [](char c) { return c >= '\0' && c < ' ' && c != '\t'; }, '?');
    return shown + '\n' + pointer + '^';
}

}  // namespace reliefbench::gpu
