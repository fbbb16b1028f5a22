#include "core/scratch_folder.hpp"

#include "core/error.hpp"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <string>
#include <system_error>

namespace reliefbench {

ScratchFolder::ScratchFolder() {
    std::error_code error;
    const std::filesystem::path parent = std::filesystem::temp_directory_path(error);
    if (error) fail("there is no folder for temporary files: {}; set TMPDIR to one", error.message());
    std::string name = (parent / "reliefbench_XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) {
        fail("cannot make a temporary folder in {}: {}; set TMPDIR to a folder that can be written", parent.string(),
             std::strerror(errno));
    }
    path_ = name;
}

ScratchFolder::~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}

}  // namespace reliefbench
