#include "manifest/shader_names.hpp"

#include "core/glsl_declarations.hpp"
#include "core/glsl_includes.hpp"
#include "manifest/shared_shaders.hpp"

#include <vector>

namespace reliefbench {

namespace {

constexpr const char* pass_stage = "prepare.comp";

}  // namespace

std::set<std::string> names_of_shaders(const Manifest& manifest, const std::filesystem::path& shared,
                                       const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> files{pass_stage};
    for (const std::string& file : stage_files(manifest.shape.kind))
        files.emplace_back(file);
    for (const PassDeclaration& pass : manifest.passes)
        files.emplace_back(pass.shader);
    std::set<std::string> names;
    std::vector<std::filesystem::path> roots = shared_shader_folders(shared);
    const std::size_t own = roots.size();
    roots.push_back(folder);
    for (const IncludedGlsl& included : glsl_with_includes(files, roots)) {
        if (included.root == own) continue;
        for (const GlslDeclaration& declaration : glsl_declarations(included.tokens))
            names.insert(declaration.name);
    }
    return names;
}

}  // namespace reliefbench
