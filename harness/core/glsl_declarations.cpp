#include "core/glsl_declarations.hpp"

#include <algorithm>

namespace reliefbench {

namespace {

/// Tokens put together as they are written by hand.
std::string as_written(const std::vector<GlslToken>& tokens, std::size_t begin, std::size_t end) {
    std::string text;
    const auto is_close = [](const GlslToken& token) {
        return token.is("(") || token.is("[") || token.is(")") || token.is("]") || token.is(",") || token.is(";");
    };
    for (std::size_t i = begin; i < end; ++i) {
        if (tokens[i].kind == GlslToken::Kind::directive) continue;
        const bool opened = !text.empty() && (text.back() == '(' || text.back() == '[');
        if (!text.empty() && !opened && !is_close(tokens[i])) text += ' ';
        text += tokens[i].text;
    }
    return text;
}

/// One past the bracket that closes the one at `open`; the end where none does.
std::size_t past_bracket(const std::vector<GlslToken>& tokens, std::size_t open) {
    int depth = 0;
    for (std::size_t i = open; i < tokens.size(); ++i) {
        const GlslToken& token = tokens[i];
        if (token.is("(") || token.is("[") || token.is("{")) ++depth;
        if (token.is(")") || token.is("]") || token.is("}")) --depth;
        if (depth == 0) return i + 1;
    }
    return tokens.size();
}

class DeclarationReader {
public:
    explicit DeclarationReader(const std::vector<GlslToken>& tokens) : tokens_(tokens) {}

    std::vector<GlslDeclaration> read() {
        while (at_ < tokens_.size())
            read_statement();
        return std::move(found_);
    }

private:
    void read_statement() {
        const GlslToken& token = tokens_[at_];
        if (token.kind == GlslToken::Kind::directive) {
            add_macro(at_++);
            return;
        }
        if (token.is("layout") && at_ + 1 < tokens_.size()) {
            at_ = past_bracket(tokens_, at_ + 1);
            return;
        }
        read_declaration();
    }

    void add_macro(std::size_t at) {
        const auto [name, rest] = glsl_directive(tokens_[at]);
        if (name != "define") return;
        const std::vector<GlslToken> words = glsl_tokens(rest);
        if (!words.empty() && words.front().kind == GlslToken::Kind::word)
            found_.push_back({GlslDeclaration::Kind::macro, words.front().text, {}, false, at});
    }

    void add(GlslDeclaration::Kind kind, std::size_t token, std::string text) {
        found_.push_back({kind, tokens_[token].text, std::move(text), false, token});
    }

    /// From a type or a qualifier to ';' or the end of a body.
    void read_declaration() {
        const std::size_t begin = at_;
        // The last word outside of brackets and initialisers: a declarator's name when one ends.
        std::size_t name = tokens_.size();
        bool initialised = false;
        for (; at_ < tokens_.size(); ++at_) {
            const GlslToken& token = tokens_[at_];
            if (token.kind == GlslToken::Kind::directive) {
                add_macro(at_);
            } else if (token.is(";") || token.is(",")) {
                if (name < tokens_.size()) add(GlslDeclaration::Kind::variable, name, type_of(begin, name));
                name = tokens_.size();
                initialised = false;
                if (token.is(";")) break;
            } else if (token.is("=")) {
                initialised = true;
            } else if (token.is("{") && !initialised) {
                read_members(begin, name);
                name = tokens_.size();
            } else if (token.is("(") && !initialised && name < tokens_.size()) {
                if (read_function(begin, name)) return;
                name = tokens_.size();
            } else if (token.is("(") || token.is("[") || token.is("{")) {
                at_ = past_bracket(tokens_, at_) - 1;
            } else if (token.is("}")) {
                break;
            } else if (token.kind == GlslToken::Kind::word && !initialised) {
                name = at_;
            }
        }
        at_ = std::min(at_ + 1, tokens_.size());
    }

    std::string type_of(std::size_t begin, std::size_t name) const { return as_written(tokens_, begin, name); }

    /// Of a structure or a block, whose name stands before the brace at `at_`, which then stands at its end. Members of
    /// a block without an instance are global, too.
    void read_members(std::size_t begin, std::size_t name) {
        const std::size_t end = past_bracket(tokens_, at_);
        const bool is_structure = name > begin && name < tokens_.size() && tokens_[name - 1].is("struct");
        if (name < tokens_.size()) add(GlslDeclaration::Kind::type, name, {});
        if (!is_structure && end < tokens_.size() && tokens_[end].is(";")) {
            const std::vector<GlslToken> members(tokens_.begin() + static_cast<std::ptrdiff_t>(at_) + 1,
                                                 tokens_.begin() + static_cast<std::ptrdiff_t>(end) - 1);
            for (GlslDeclaration& member : glsl_declarations(members)) {
                member.token += at_ + 1;
                found_.push_back(std::move(member));
            }
        }
        at_ = end - 1;
    }

    /// False where what has parentheses is none.
    bool read_function(std::size_t begin, std::size_t name) {
        const std::size_t end = past_bracket(tokens_, at_);
        const bool has_type = name > begin;
        const bool has_body = end < tokens_.size() && tokens_[end].is("{");
        if (!has_type || (!has_body && !(end < tokens_.size() && tokens_[end].is(";")))) {
            at_ = end - 1;
            return false;
        }
        found_.push_back(
            {GlslDeclaration::Kind::function, tokens_[name].text, as_written(tokens_, begin, end), has_body, name});
        at_ = has_body ? past_bracket(tokens_, end) : end + 1;
        return true;
    }

    const std::vector<GlslToken>& tokens_;
    std::size_t at_ = 0;
    std::vector<GlslDeclaration> found_;
};

}  // namespace

std::vector<GlslDeclaration> glsl_declarations(const std::vector<GlslToken>& tokens) {
    return DeclarationReader(tokens).read();
}

}  // namespace reliefbench
