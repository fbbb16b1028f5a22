#include "manifest/shader_names.hpp"

#include "core/glsl_declarations.hpp"
#include "core/glsl_includes.hpp"

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
    for (const IncludedGlsl& included : glsl_with_includes(files, {shared, folder})) {
        if (included.root != 0) continue;
        for (const GlslDeclaration& declaration : glsl_declarations(included.tokens))
            names.insert(declaration.name);
    }
    return names;
}

}  // namespace reliefbench
