#pragma once

#include "gpu/flat_shader.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace reliefbench::gpu {

/// The first complaint of glslang's log; what comes after it is mostly of its making.
struct LogComplaint {
    /// Without a column. The linker's have neither file nor line.
    SourcePlace place;
    /// What glslang quotes; may be empty.
    std::string symbol;
    /// Its words, further lines of the same complaint included.
    std::string message;

    /// But for the place.
    bool says_the_same(const LogComplaint& other) const { return symbol == other.symbol && message == other.message; }
};

/// Empty where the log has none.
std::optional<LogComplaint> first_complaint(std::string_view log);

/// One sentence, and the token that it is about, where that is known.
struct WordedComplaint {
    std::string sentence;
    std::optional<std::size_t> about = {};
    /// Whether something is missing behind that token.
    bool behind = false;
};

/// Plain words for a complaint of the preprocessor, which leaves nothing to point at.
std::string in_words(const LogComplaint& complaint);

/// Plain words for one of the parser, which is about this token of the shader.
WordedComplaint in_words(const LogComplaint& complaint, const FlatShader& shader, std::size_t token);

/// Plain words for one of the linker: no definition, no main() in `main_file`, recursion.
WordedComplaint linker_in_words(const LogComplaint& complaint, const FlatShader& shader, const std::string& main_file);

}  // namespace reliefbench::gpu
