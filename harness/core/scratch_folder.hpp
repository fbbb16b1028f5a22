#pragma once

#include <filesystem>

namespace reliefbench {

/// An empty folder of this process's own among the system's temporary files, deleted with all its content at the end
/// of the scope. One that cannot be made is an Error.
class ScratchFolder {
public:
    ScratchFolder();
    ~ScratchFolder();
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    /// Absolute.
    const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

}  // namespace reliefbench
