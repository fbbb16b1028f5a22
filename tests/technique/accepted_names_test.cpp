// Names that parameters may have, against the compiler: whatever the manifest accepts beside the shaders compiles
// beside them.

#include "test_scene.hpp"

#include "core/glsl_declarations.hpp"
#include "core/glsl_tokens.hpp"
#include "manifest/reserved_names.hpp"
#include "manifest/shader_names.hpp"
#include "manifest/shared_shaders.hpp"
#include "technique/program.hpp"
#include "technique/source_identity.hpp"

#include <set>

namespace reliefbench {
namespace {

using namespace test;

/// All words of the shaders below a folder: names of GLSL, of the shaders, and of what they call.
void add_words(const std::filesystem::path& folder, std::set<std::string>& words) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        const std::string extension = entry.path().extension().string();
        if (extension == ".json" || extension == ".md" || extension == ".png" || entry.is_directory()) continue;
        for (const GlslToken& token : glsl_tokens(read_text_file(entry.path()))) {
            if (token.kind == GlslToken::Kind::word) words.insert(token.text);
        }
    }
}

using AcceptedNames = DeviceTest;

// Of each shipped technique all words that its manifest accepts become parameters at once. Where a word is missing from
// those reserved, a shader that uses it does not compile, and the complaint has the word.
TEST_F(AcceptedNames, CompileBesideEveryShader) {
    std::set<std::string> words{"max_steps", "factor", "h", "vec", "matter", "scale", "mat_5", "flatness"};
    add_words(shader_root(), words);
    add_words(default_technique_root(), words);
    for (const Technique& shipped : find_techniques({default_technique_root()}).techniques) {
        if (!device().info().has_feature("tessellationShader") && shipped.manifest.shape.kind == "patches") continue;
        std::set<std::string> taken = names_of_shaders(shipped.manifest, shipped.shaders, shipped.folder);
        for (const Parameter& parameter : shipped.manifest.parameters) {
            taken.insert(parameter.name);
            for (const std::string& choice : parameter.choices)
                taken.insert(parameter.name + "_" + choice);
        }
        for (const MapDeclaration& map : shipped.manifest.maps)
            taken.insert(map.name);
        // What the technique's own shaders declare is their author's to know.
        for (const std::filesystem::path& file : source_files(shipped.manifest, shipped.folder, shipped.shaders)) {
            if (file.extension() == ".json") continue;
            for (const GlslDeclaration& declared :
                 glsl_declarations(glsl_tokens(read_text_file(shipped.folder / file))))
                taken.insert(declared.name);
        }
        Technique technique = shipped;
        technique.hash += " with all words";
        std::size_t accepted = 0;
        for (const std::string& word : words) {
            if (taken.contains(word) || !check_glsl_name(word).empty()) continue;
            ++accepted;
            Parameter parameter;
            parameter.name = word;
            parameter.type = ParameterType::integer;
            parameter.default_value = std::int64_t{1};
            parameter.maximum = 1;
            technique.manifest.parameters.push_back(parameter);
        }
        EXPECT_GT(accepted, 250U) << shipped.manifest.id;
        const ParameterValues values = technique.manifest.defaults();
        View view;
        view.depth_write = DepthWrite::conservative;
        EXPECT_NO_THROW(compile_draw(device(), technique, values, Variant::probed, view));
        view.material.kind = MaterialFilter::Kind::mip;
        view.material.gradients = MaterialFilter::Gradients::analytic;
        EXPECT_NO_THROW(compile_draw(device(), technique, values, Variant::probed, view));
        for (const PassDeclaration& pass : technique.manifest.passes)
            EXPECT_NO_THROW(compile_pass(device(), technique, values, pass, Variant::probed)) << pass.name;
    }
}

}  // namespace
}  // namespace reliefbench
