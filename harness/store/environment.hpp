#pragma once

#include "core/json.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace reliefbench {

/// The state of the sources that the tool was built from.
struct SourceRevision {
    /// Empty when unknown.
    std::string commit;
    /// Whether files differ from the commit; unknown where no work tree can be asked.
    std::optional<bool> dirty;
};

/// What a run was made on and with, as far as no GPU is needed to tell. Names no host and no user.
struct Environment {
    std::string tool_version;
    SourceRevision source;
    std::string cpu;
    unsigned cores = 0;
    std::string os;
    /// ISO 8601, UTC, to the second.
    std::string time;
};

/// Of `folder` when it is the top of a git work tree.
std::optional<SourceRevision> read_source_revision(const std::filesystem::path& folder);

/// The source revision is that of the source folder at run time if it is still there, because techniques and shaders
/// are read from it; else that of the build's configuration.
Environment collect_environment();

/// What is unknown is null.
Json to_json(const Environment& environment);
Json environment_to_json();

}  // namespace reliefbench
