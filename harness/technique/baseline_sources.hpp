#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace reliefbench {

/// Where techniques and the GLSL that they share are read from.
struct TechniqueSources {
    /// Folders of technique folders.
    std::vector<std::filesystem::path> roots;
    std::filesystem::path shaders;
    /// In words: "revision main (1234567890ab) of DIR".
    std::string description;
    /// What a reader of a comparison with them must know, in words.
    std::vector<std::string> notices = {};
};

/// Those of a baseline, which is
/// - a folder: a checkout (with techniques/, and with harness/shaders/ unless it shares those of `own`), or a folder of
///   technique folders;
/// - else a revision of the git repository in which the last of the roots of `own` lies that lies in one: what `own`
///   has there is read into `scratch` as it was in that revision, without touching the work tree; what lies elsewhere
///   is the same on both sides, and comes first. A root that did not exist in that revision is left out.
/// Roots may hold the same id: that of the later root counts (SameId::last_wins).
/// Shared shaders that do not fit this harness (shader_interface) are replaced by those of `own`, with a notice. A
/// baseline that is neither is an Error.
TechniqueSources find_baseline(const std::string& baseline, const TechniqueSources& own,
                               const std::filesystem::path& scratch);

/// What the harness binds to shared shaders: their declarations of bindings, blocks, push constants and specialization
/// constants, without comments and spaces, sorted. Shaders with another interface would read garbage and say nothing.
std::vector<std::string> shader_interface(const std::filesystem::path& shaders);

}  // namespace reliefbench
