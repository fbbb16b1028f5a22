#include "gpu/shader_compiler.hpp"

#include "core/error.hpp"
#include "core/file.hpp"
#include "core/suggest.hpp"

#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>

#include <algorithm>
#include <cstring>
#include <memory>
#include <optional>
#include <set>
#include <sstream>

namespace reliefbench::gpu {

namespace {

constexpr int glsl_version = 460;
constexpr std::size_t deepest_include = 16;
constexpr std::uint64_t largest_source = std::uint64_t{4} << 20;

EShLanguage glslang_stage(ShaderStage stage) {
    switch (stage) {
        case ShaderStage::vertex:
            return EShLangVertex;
        case ShaderStage::tessellation_control:
            return EShLangTessControl;
        case ShaderStage::tessellation_evaluation:
            return EShLangTessEvaluation;
        case ShaderStage::fragment:
            return EShLangFragment;
        case ShaderStage::compute:
            return EShLangCompute;
    }
    fail("unknown shader stage {}", static_cast<int>(stage));
}

/// The text of a file named in GLSL; an Error says why it may not or cannot be read.
std::string read_source(const ShaderSource& source, const std::string& name) {
    const auto generated = source.generated.find(name);
    if (generated != source.generated.end()) return generated->second;

    const std::filesystem::path relative(name);
    if (relative.is_absolute() || std::find(relative.begin(), relative.end(), "..") != relative.end())
        fail("'{}' leaves the folders that shaders are taken from; name a file inside them", name);

    std::optional<std::filesystem::path> found;
    for (const std::filesystem::path& root : source.roots) {
        const std::filesystem::path candidate = root / relative;
        if (!std::filesystem::is_regular_file(candidate)) continue;
        // A symbolic link may lead out of the folder although its name does not.
        const std::filesystem::path canonical_root = std::filesystem::canonical(root);
        const std::filesystem::path canonical = std::filesystem::canonical(candidate);
        const auto [root_end, rest] =
            std::mismatch(canonical_root.begin(), canonical_root.end(), canonical.begin(), canonical.end());
        if (root_end != canonical_root.end())
            fail("'{}' is a link that leads out of {}; put the file itself there", name, root.string());
        if (found) fail("'{}' exists both as {} and as {}; rename one", name, found->string(), candidate.string());
        found = candidate;
    }
    if (!found) {
        std::vector<std::string> places;
        for (const std::filesystem::path& root : source.roots)
            places.push_back(root.string());
        fail("'{}' is not in {}", name, join(places, " or "));
    }
    return read_text_file(*found, largest_source);
}

class Includer final : public glslang::TShader::Includer {
public:
    Includer(const ShaderSource& source, const ChildNote& note) : source_(source), note_(note) {}

    IncludeResult* includeLocal(const char* name, const char* /*includer*/, std::size_t depth) override {
        std::string resolved = name;
        std::string text;
        try {
            if (depth > deepest_include) fail("'{}' is included {} deep: does a file include itself?", name, depth);
            text = read_source(source_, name);
            note(name);
        } catch (const std::exception& error) {
            resolved.clear();
            text = error.what();
        }
        auto* kept = new std::string(std::move(text));
        return new IncludeResult(resolved, kept->data(), kept->size(), kept);
    }

    IncludeResult* includeSystem(const char* name, const char* includer, std::size_t depth) override {
        return includeLocal(name, includer, depth);
    }

    void releaseInclude(IncludeResult* result) override {
        if (!result) return;
        delete static_cast<std::string*>(result->userData);
        delete result;
    }

private:
    /// A file that is read again and again is told once.
    void note(const std::string& name) {
        if (last_noted_ != name) note_("it had read '" + name + "'");
        last_noted_ = name;
    }

    const ShaderSource& source_;
    const ChildNote& note_;
    std::string last_noted_;
};

/// glslang's log with one complaint per line and without its "ERROR: " and its closing counts.
std::string complaints(const char* log) {
    constexpr std::string_view prefix = "ERROR: ";
    constexpr int most_told = 20;
    std::istringstream lines(log);
    std::string result;
    int told = 0;
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with(prefix)) line.erase(0, prefix.size());
        const bool says_something = line.find(':') != std::string::npos && !line.starts_with("WARNING");
        if (!says_something) continue;
        if (told++ == most_told) return result + "\n...";
        if (!result.empty()) result += '\n';
        result += line;
    }
    return result;
}

/// glslang keeps process-wide tables, set up once and taken down at exit.
struct GlslangProcess {
    GlslangProcess() { glslang::InitializeProcess(); }
    ~GlslangProcess() { glslang::FinalizeProcess(); }
};

SpirV compile_here(const ShaderSource& source, const ChildNote& note) {
    const EShLanguage stage = glslang_stage(source.stage);
    const std::string front = "#version " + std::to_string(glsl_version) +
                              "\n#extension GL_GOOGLE_include_directive : require\n" + source.preamble;
    const std::string text = read_source(source, source.file);
    const char* const texts[] = {front.c_str(), text.c_str()};
    const int lengths[] = {static_cast<int>(front.size()), static_cast<int>(text.size())};
    const char* const names[] = {"preamble", source.file.c_str()};

    glslang::TShader shader(stage);
    shader.setStringsWithLengthsAndNames(texts, lengths, names, 2);
    shader.setEnvInput(glslang::EShSourceGlsl, stage, glslang::EShClientVulkan, glsl_version);
    shader.setEnvClient(glslang::EShClientVulkan, glslang::EShTargetVulkan_1_3);
    shader.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_6);
    const auto messages = static_cast<EShMessages>(EShMsgSpvRules | EShMsgVulkanRules);
    Includer includer(source, note);
    if (!shader.parse(GetDefaultResources(), glsl_version, ENoProfile, false, false, messages, includer))
        fail("{}", complaints(shader.getInfoLog()));

    glslang::TProgram program;
    program.addShader(&shader);
    if (!program.link(messages)) fail("{}: {}", source.file, complaints(program.getInfoLog()));

    glslang::SpvOptions options;
    options.disableOptimizer = true;
    const auto translate = [&] {
        SpirV words;
        glslang::GlslangToSpv(*program.getIntermediate(stage), words, &options);
        return words;
    };
    SpirV words = translate();
    if (source.inspect) {
        options.generateDebugInfo = true;
        source.inspect(translate());
    }
    return words;
}

/// The tables of a stage's built-in functions take most of the time of a small shader: made once here, the children
/// have them.
void make_tables(ShaderStage stage) {
    static const GlslangProcess process;
    static std::set<ShaderStage> made;
    if (!made.insert(stage).second) return;
    const std::string layout = stage == ShaderStage::tessellation_control      ? "layout(vertices = 1) out;\n"
                               : stage == ShaderStage::tessellation_evaluation ? "layout(triangles) in;\n"
                                                                               : "";
    const ShaderSource nothing{.stage = stage,
                               .file = "nothing",
                               .roots = {},
                               .generated = {{"nothing", layout + "void main() {}\n"}},
                               .preamble = ""};
    compile_here(nothing, [](std::string_view) {});
}

}  // namespace

SpirV compile_shader(const ShaderSource& source, const ChildLimits& limits) {
    make_tables(source.stage);
    const auto compile = [&](const ChildNote& note) {
        const SpirV words = compile_here(source, note);
        return std::string(reinterpret_cast<const char*>(words.data()), words.size() * sizeof(words.front()));
    };
    const std::string what = source.file + ": the compiler did not come to an end";
    const std::string bytes = run_in_child(what, compile, limits);
    SpirV words(bytes.size() / sizeof(words.front()));
    std::memcpy(words.data(), bytes.data(), bytes.size());
    return words;
}

}  // namespace reliefbench::gpu
