#pragma once

#include "core/file.hpp"
#include "manifest/shared_shaders.hpp"
#include "verify_test.hpp"

#include <filesystem>
#include <string>

namespace reliefbench::test {

/// A copy of the shared shaders, in a folder that lives as long as the object, with one passage of one file replaced.
class BrokenShaders {
public:
    BrokenShaders(const std::string& file, const std::string& passage, const std::string& replacement) {
        std::filesystem::copy(shader_root(), shaders(), std::filesystem::copy_options::recursive);
        const std::filesystem::path broken = find_shared_file(shaders(), file);
        std::string text = read_text_file(broken);
        const std::size_t place = text.find(passage);
        if (place == std::string::npos) {
            ADD_FAILURE() << file << " has no passage '" << passage << "'";
            return;
        }
        text.replace(place, passage.size(), replacement);
        write_text_file(broken, text);
    }

    Technique compile(const std::string& id) const {
        return find_techniques({default_technique_root()}, shaders()).get(id);
    }

private:
    std::filesystem::path shaders() const { return folder_ / "shaders"; }

    TemporaryFolder folder_;
};

}  // namespace reliefbench::test
