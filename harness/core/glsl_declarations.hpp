#pragma once

#include "core/glsl_tokens.hpp"

#include <string>
#include <vector>

namespace reliefbench {

/// A name that GLSL declares outside of all functions.
struct GlslDeclaration {
    enum class Kind { function, variable, type, macro };
    Kind kind = Kind::variable;
    std::string name;
    /// Of a function from its return type to its closing parenthesis, "float tap_height(vec2 uv)"; of a variable or an
    /// unnamed block's member its type.
    std::string text;
    /// Of a function that is defined here, not only declared.
    bool has_body = false;
    /// Which of the tokens is the name.
    std::size_t token = 0;
};

/// In their order, of all branches of conditions. Members of a block without an instance's name are variables, as the
/// instance's name is; words such as "in" of a layout alone may come as variables, too: no name of anything can be one.
std::vector<GlslDeclaration> glsl_declarations(const std::vector<GlslToken>& tokens);

}  // namespace reliefbench
