#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace reliefbench {

/// Bytes of a file of GLSL that is read.
inline constexpr std::uint64_t largest_glsl_file = std::uint64_t{4} << 20;

struct GlslToken {
    enum class Kind { word, number, mark, directive };
    Kind kind = Kind::mark;
    /// Of a directive its whole line from '#' on, continuation lines included, comments left out.
    std::string text;
    /// Where its first character stands, both from 1, the column in bytes.
    int line = 1;
    int column = 1;

    bool is(std::string_view mark) const { return kind != Kind::directive && text == mark; }
};

/// GLSL cut into words, numbers, operators and directives, without comments. Nothing is expanded, and all branches of
/// conditions are there. Never fails: what is no GLSL comes as marks of one byte.
std::vector<GlslToken> glsl_tokens(std::string_view text);

/// Editors put one in front of a text in UTF-8; no compiler of GLSL takes it.
std::string_view without_byte_order_mark(std::string_view text);

/// "include" and "\"march.glsl\"" of a directive, without spaces around either.
struct GlslDirective {
    std::string name;
    std::string rest;
};
GlslDirective glsl_directive(const GlslToken& token);

/// The file that a directive includes; empty where it is another one.
std::string included_file(const GlslToken& token);

}  // namespace reliefbench
