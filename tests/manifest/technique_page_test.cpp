// docs/adding_a_technique.md against the shaders that it speaks of.

#include "core/file.hpp"
#include "core/glsl_declarations.hpp"
#include "manifest/shared_shaders.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <regex>
#include <set>

namespace reliefbench {
namespace {

namespace fs = std::filesystem;

const fs::path sources = RELIEFBENCH_SOURCE_DIR;

std::string page() {
    return read_text_file(sources / "docs" / "adding_a_technique.md");
}

/// Of the whole page, code and tables.
std::string one_line(const std::string& text) {
    return std::regex_replace(text, std::regex("\\s+"), " ");
}

/// All GLSL between fences, one after the other.
std::string glsl_of(const std::string& text) {
    constexpr std::string_view fence = "```";
    constexpr std::string_view opening = "```glsl\n";
    std::string code;
    for (std::size_t at = text.find(opening); at != std::string::npos; at = text.find(opening, at)) {
        const std::size_t begin = at + opening.size();
        at = text.find(fence, begin);
        code += text.substr(begin, at - begin);
    }
    return code;
}

/// Passes of a map of two dimensions have this one.
std::string with_texel_type(const std::string& text) {
    return std::regex_replace(text, std::regex("RELIEFBENCH_TEXEL"), "ivec2");
}

struct Shader {
    std::string file;
    /// Of harness/shaders.
    std::string folder;
    std::vector<GlslToken> tokens;
    std::vector<GlslDeclaration> declarations;
};

std::vector<Shader> shaders() {
    std::vector<Shader> all;
    std::vector<fs::path> files;
    for (const fs::path& folder : shared_shader_folders(sources / "harness" / "shaders")) {
        for (const fs::directory_entry& entry : fs::directory_iterator(folder))
            files.push_back(entry.path());
    }
    for (const fs::path& file : files) {
        if (file.extension() == ".json") continue;
        std::vector<GlslToken> tokens = glsl_tokens(read_text_file(file));
        std::vector<GlslDeclaration> declarations = glsl_declarations(tokens);
        all.push_back({file.filename().string(), file.parent_path().filename().string(), std::move(tokens),
                       std::move(declarations)});
    }
    return all;
}

std::set<std::string> signatures_of_shaders() {
    std::set<std::string> signatures;
    for (const Shader& shader : shaders()) {
        for (const GlslDeclaration& declared : shader.declarations) {
            if (declared.kind == GlslDeclaration::Kind::function) signatures.insert(with_texel_type(declared.text));
        }
    }
    return signatures;
}

/// Its prototypes, and what its tables name between back quotes.
std::set<std::string> signatures_of_page() {
    const std::string text = page();
    std::set<std::string> signatures;
    for (const GlslDeclaration& declared : glsl_declarations(glsl_tokens(glsl_of(text)))) {
        if (declared.kind == GlslDeclaration::Kind::function && !declared.has_body) signatures.insert(declared.text);
    }
    static const std::regex quoted(R"(`((?:void|bool|int|float|[iu]?vec[234]|Trace) \w+\([^`]*\))`)");
    for (std::sregex_iterator found(text.begin(), text.end(), quoted), end; found != end; ++found)
        signatures.insert((*found)[1].str());
    return signatures;
}

/// The tokens of each structure, by its name.
std::map<std::string, std::vector<std::string>> structures(const std::vector<GlslToken>& tokens) {
    std::map<std::string, std::vector<std::string>> found;
    for (std::size_t i = 0; i + 1 < tokens.size(); ++i) {
        if (!tokens[i].is("struct")) continue;
        std::vector<std::string>& members = found[tokens[i + 1].text];
        for (std::size_t member = i + 2; member < tokens.size() && !tokens[member].is("}"); ++member)
            members.push_back(tokens[member].text);
    }
    return found;
}

TEST(TechniquePage, EverySignatureOnItIsOneOfTheShaders) {
    const std::set<std::string> known = signatures_of_shaders();
    const std::set<std::string> stated = signatures_of_page();
    EXPECT_GT(stated.size(), 80U);
    // Of a pass of a map with a depth, and of one's own trace.
    const std::set<std::string> of_techniques{"void prepare(ivec3 texel)", "Trace trace(ReliefRay ray)"};
    for (const std::string& signature : stated) {
        EXPECT_TRUE(known.contains(signature) || of_techniques.contains(signature)) << signature;
    }
}

TEST(TechniquePage, EveryFunctionThatATechniqueMayCallIsOnIt) {
    const std::string text = one_line(page());
    // What contract and library rest on, not what techniques are told to call.
    const std::set<std::string> own_files{"answer_range.glsl", "scene.glsl", "work.glsl", "work_counters.glsl",
                                          "relief_ray_1.glsl"};
    // Shaders of the sets' passes.
    const auto is_pass = [](const std::string& file) {
        return file.starts_with("prepare_") || file.starts_with("height_mips_");
    };
    const std::set<std::string> own_functions{"count_tap", "between_levels", "footprint_level", "this_texel", "main"};
    std::size_t functions = 0;
    for (const Shader& shader : shaders()) {
        const bool is_api = shader.folder != "driver" || shader.file == "prepare.comp";
        if (!is_api || is_pass(shader.file) || own_files.contains(shader.file)) continue;
        const bool is_always_there = shader.file.starts_with("relief") || shader.file == "prepare.comp";
        EXPECT_TRUE(is_always_there || text.find(shader.file) != std::string::npos) << shader.file;
        for (const GlslDeclaration& declared : shader.declarations) {
            if (declared.kind != GlslDeclaration::Kind::function || own_functions.contains(declared.name)) continue;
            ++functions;
            const std::string expected = with_texel_type(declared.text);
            EXPECT_NE(text.find(expected), std::string::npos) << shader.file << ": " << expected;
        }
    }
    EXPECT_GT(functions, 80U);
}

TEST(TechniquePage, ItsStructuresAreThoseOfTheShaders) {
    std::map<std::string, std::vector<std::string>> known;
    for (const Shader& shader : shaders()) {
        // What contract 1 calls by the same names.
        if (shader.file != "relief_ray_1.glsl") known.merge(structures(shader.tokens));
    }
    const auto stated = structures(glsl_tokens(glsl_of(page())));
    EXPECT_GE(stated.size(), 9U);
    for (const auto& [name, members] : stated)
        EXPECT_EQ(members, known[name]) << name;
}

}  // namespace
}  // namespace reliefbench
