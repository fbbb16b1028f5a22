#include "manifest/shader_names.hpp"

#include "core/error.hpp"
#include "core/file.hpp"
#include "core/glsl_declarations.hpp"

#include <algorithm>
#include <utility>

namespace reliefbench {

namespace {

constexpr const char* pass_stage = "prepare.comp";
constexpr std::uint64_t largest_shader = std::uint64_t{4} << 20;

class NameCollector {
public:
    NameCollector(const std::filesystem::path& shared, const std::filesystem::path& folder)
        : shared_(shared), folder_(folder) {}

    /// With what it includes, whatever the conditions: a name counts in the compilation that has it.
    void add_file(const std::string& name) {
        const std::filesystem::path path(name);
        const bool leaves = path.is_absolute() || std::ranges::find(path, "..") != path.end();
        if (leaves || !seen_.insert(name).second) return;
        const bool is_shared = std::filesystem::is_regular_file(shared_ / name);
        const std::filesystem::path file = (is_shared ? shared_ : folder_) / name;
        if (!is_shared && (folder_.empty() || !std::filesystem::is_regular_file(file))) return;
        const std::vector<GlslToken> tokens = glsl_tokens(read_text_file(file, largest_shader));
        if (is_shared) {
            for (const GlslDeclaration& declaration : glsl_declarations(tokens))
                names_.insert(declaration.name);
        }
        for (const GlslToken& token : tokens) {
            const std::string included = included_file(token);
            if (!included.empty()) add_file(included);
        }
    }

    std::set<std::string> take() { return std::move(names_); }

private:
    const std::filesystem::path& shared_;
    const std::filesystem::path& folder_;
    std::set<std::string> seen_;
    std::set<std::string> names_;
};

}  // namespace

std::set<std::string> names_of_shaders(const Manifest& manifest, const std::filesystem::path& shared,
                                       const std::filesystem::path& folder) {
    NameCollector collector(shared, folder);
    for (const std::string& file : stage_files(manifest.shape.kind))
        collector.add_file(file);
    collector.add_file(pass_stage);
    for (const PassDeclaration& pass : manifest.passes)
        collector.add_file(pass.shader);
    return collector.take();
}

}  // namespace reliefbench
