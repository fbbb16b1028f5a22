#pragma once

#include "core/glsl_declarations.hpp"
#include "core/glsl_tokens.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace reliefbench::gpu {

/// Where something stands in the sources, both from 1; 0 where it is not known, or is the whole file or line.
struct SourcePlace {
    std::string file;
    int line = 0;
    int column = 0;
};

/// One compilation after its preprocessor, in one piece: what the compiler's parser sees.
class FlatShader {
public:
    /// `preprocessed` is glslang's, with a #line for each change of file. Its first `front_lines` lines are no file's,
    /// `main_file` comes after them.
    FlatShader(std::string_view preprocessed, int front_lines, const std::string& main_file);

    /// Directives among them are those that the parser sees, #version and #extension.
    const std::vector<GlslToken>& tokens() const { return tokens_; }

    /// The same program with each token on a line of its own: a complaint's line, from 1, is then a token's number.
    std::string one_token_per_line() const;

    /// Line and file of a token; of one of the front the file is empty.
    SourcePlace place(std::size_t token) const { return places_[token]; }

    /// How many tokens of the same text stand before it on its line.
    int earlier_on_its_line(std::size_t token) const;

    /// A brace that closes nothing, else the outermost one that nothing closes.
    std::optional<std::size_t> unbalanced_brace() const;

    const std::vector<GlslDeclaration>& declarations() const { return declarations_; }

private:
    std::vector<GlslToken> tokens_;
    std::vector<SourcePlace> places_;
    std::vector<GlslDeclaration> declarations_;
};

/// Of the n-th token (from 0) of this text on the line of `source`, the column; of the line's first token where there
/// is none, as in a macro's text.
int column_of(std::string_view source, int line, std::string_view text, int n);

/// The line and a caret under the column (0: where the line begins), each after four spaces; empty where there is no
/// such line. Of a long line the part around the column.
std::string show_line(std::string_view source, int line, int column);

}  // namespace reliefbench::gpu
