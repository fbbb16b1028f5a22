#include "core/glsl_tokens.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace reliefbench {

namespace {

bool is_glsl_digit(char c) {
    return c >= '0' && c <= '9';
}

bool begins_glsl_word(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

bool is_glsl_blank(char c) {
    return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}

/// From the longest on.
constexpr std::array<std::string_view, 23> glsl_operators{
    "<<=", ">>=", "++", "--", "<<", ">>", "<=", ">=", "==", "!=", "&&",  "||",
    "^^",  "+=",  "-=", "*=", "/=", "%=", "&=", "|=", "^=", "##", "\\\n"};

class GlslReader {
public:
    explicit GlslReader(std::string_view text) : text_(with_plain_line_ends(text)) {}

    std::vector<GlslToken> read() {
        bool at_line_begin = true;
        while (!at_end()) {
            const char c = text_[at_];
            if (c == '\n') at_line_begin = true;
            if (c == '\n' || is_glsl_blank(c)) {
                advance(1);
            } else if (const std::size_t length = comment_length()) {
                advance(length);
            } else {
                const std::size_t token_length = c == '#' && at_line_begin ? 0 : length_of_token();
                at_line_begin = false;
                if (token_length == 0)
                    add_directive();
                else
                    add(kind_of(c), token_length);
            }
        }
        return std::move(tokens_);
    }

private:
    /// A carriage return alone ends a line, too; before a line feed it is a blank.
    static std::string with_plain_line_ends(std::string_view text) {
        std::string plain(text);
        for (std::size_t i = 0; i < plain.size(); ++i) {
            if (plain[i] == '\r' && (i + 1 == plain.size() || plain[i + 1] != '\n')) plain[i] = '\n';
        }
        return plain;
    }

    bool at_end() const { return at_ >= text_.size(); }
    char peek(std::size_t ahead) const { return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0'; }

    void advance(std::size_t count) {
        for (; count > 0 && !at_end(); --count, ++at_) {
            ++column_;
            if (text_[at_] != '\n') continue;
            ++line_;
            column_ = 1;
        }
    }

    /// Of this line and those that continue it.
    std::size_t end_of_line() const {
        std::size_t end = text_.find('\n', at_);
        while (end != std::string_view::npos) {
            const std::size_t last = end > 0 && text_[end - 1] == '\r' ? end - 1 : end;
            if (last == 0 || text_[last - 1] != '\\') return end;
            end = text_.find('\n', end + 1);
        }
        return text_.size();
    }

    /// 0 where none begins.
    std::size_t comment_length() const {
        if (peek(0) != '/') return 0;
        if (peek(1) == '/') return end_of_line() - at_;
        if (peek(1) != '*') return 0;
        const std::size_t end = text_.find("*/", at_ + 2);
        return (end == std::string_view::npos ? text_.size() : end + 2) - at_;
    }

    GlslToken::Kind kind_of(char c) const {
        if (begins_glsl_word(c)) return GlslToken::Kind::word;
        return is_glsl_digit(c) || (c == '.' && is_glsl_digit(peek(1))) ? GlslToken::Kind::number
                                                                        : GlslToken::Kind::mark;
    }

    std::size_t length_of_token() const {
        std::size_t length = 1;
        switch (kind_of(peek(0))) {
            case GlslToken::Kind::word:
                while (begins_glsl_word(peek(length)) || is_glsl_digit(peek(length)))
                    ++length;
                return length;
            case GlslToken::Kind::number: {
                const bool hexadecimal = peek(1) == 'x' || peek(1) == 'X';
                const auto is_exponent = [&](std::size_t i) {
                    return !hexadecimal && (peek(i) == 'e' || peek(i) == 'E') &&
                           (peek(i + 1) == '+' || peek(i + 1) == '-');
                };
                while (begins_glsl_word(peek(length)) || is_glsl_digit(peek(length)) || peek(length) == '.')
                    length += is_exponent(length) ? 2 : 1;
                return length;
            }
            default:
                break;
        }
        for (const std::string_view word : glsl_operators) {
            if (std::string_view(text_).substr(at_).starts_with(word)) return word.size();
        }
        return 1;
    }

    void add(GlslToken::Kind kind, std::size_t length) {
        const std::string_view text = std::string_view(text_).substr(at_, length);
        if (text != "\\\n") tokens_.push_back({kind, std::string(text), line_, column_});
        advance(length);
    }

    void add_directive() {
        GlslToken token{GlslToken::Kind::directive, {}, line_, column_};
        while (!at_end() && peek(0) != '\n') {
            if (peek(0) == '\\' && (peek(1) == '\n' || (peek(1) == '\r' && peek(2) == '\n'))) {
                advance(peek(1) == '\n' ? 2 : 3);
                token.text += ' ';
            } else if (const std::size_t length = file_name_length(token)) {
                token.text += text_.substr(at_, length);
                advance(length);
            } else if (const std::size_t comment = comment_length()) {
                advance(comment);
                token.text += ' ';
            } else {
                if (peek(0) != '\r') token.text += peek(0);
                advance(1);
            }
        }
        tokens_.push_back(std::move(token));
    }

    /// Of what an include names, in which "//" begins no comment; 0 where none begins.
    std::size_t file_name_length(const GlslToken& directive) const {
        const char end = peek(0) == '<' ? '>' : '"';
        if (peek(0) != '<' && peek(0) != '"') return 0;
        if (glsl_directive(directive).name != "include") return 0;
        const std::size_t close = text_.find(end, at_ + 1);
        return close < text_.find('\n', at_) ? close + 1 - at_ : 0;
    }

    std::string text_;
    std::size_t at_ = 0;
    int line_ = 1;
    int column_ = 1;
    std::vector<GlslToken> tokens_;
};

std::string_view without_blanks(std::string_view text) {
    while (!text.empty() && is_glsl_blank(text.front()))
        text.remove_prefix(1);
    while (!text.empty() && is_glsl_blank(text.back()))
        text.remove_suffix(1);
    return text;
}

}  // namespace

std::vector<GlslToken> glsl_tokens(std::string_view text) {
    return GlslReader(without_byte_order_mark(text)).read();
}

std::string_view without_byte_order_mark(std::string_view text) {
    constexpr std::string_view mark = "\xEF\xBB\xBF";
    if (text.starts_with(mark)) text.remove_prefix(mark.size());
    return text;
}

GlslDirective glsl_directive(const GlslToken& token) {
    if (token.kind != GlslToken::Kind::directive) return {};
    const std::string_view text = without_blanks(std::string_view(token.text).substr(1));
    std::size_t length = 0;
    while (length < text.size() && begins_glsl_word(text[length]))
        ++length;
    return {std::string(text.substr(0, length)), std::string(without_blanks(text.substr(length)))};
}

std::string included_file(const GlslToken& token) {
    const auto [name, rest] = glsl_directive(token);
    if (name != "include" || rest.size() < 2) return {};
    const std::size_t end = rest.find(rest.front() == '<' ? '>' : '"', 1);
    const bool quoted = rest.front() == '<' || rest.front() == '"';
    return quoted && end != std::string::npos ? rest.substr(1, end - 1) : std::string();
}

}  // namespace reliefbench
