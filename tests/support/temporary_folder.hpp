#pragma once

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <system_error>

namespace reliefbench {

/// An empty folder that no other test or process has, deleted with all its content at the end of the scope.
class TemporaryFolder {
public:
    TemporaryFolder() {
        const std::filesystem::path parent = std::filesystem::canonical(std::filesystem::temp_directory_path());
        std::string name = (parent / "reliefbench_test_XXXXXX").string();
        if (mkdtemp(name.data()) == nullptr) {
            throw std::filesystem::filesystem_error("cannot make a temporary folder", name,
                                                    std::error_code(errno, std::generic_category()));
        }
        path_ = name;
    }
    ~TemporaryFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    /// Absolute, without links.
    const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

inline std::filesystem::path operator/(const TemporaryFolder& folder, const std::filesystem::path& name) {
    return folder.path() / name;
}

}  // namespace reliefbench
