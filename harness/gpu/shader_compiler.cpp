#include "gpu/shader_compiler.hpp"

#include "core/error.hpp"
#include "core/file.hpp"
#include "core/glsl_includes.hpp"
#include "core/suggest.hpp"
#include "gpu/flat_shader.hpp"
#include "gpu/shader_complaint.hpp"
#include "gpu/shader_source.hpp"

#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <memory>
#include <optional>
#include <set>
#include <string_view>

namespace reliefbench::gpu {

namespace {

constexpr int glsl_version = 460;
/// In glslang's messages, of what is put in front of a file.
constexpr const char* front_name = "preamble";
constexpr std::size_t deepest_include = 16;

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

/// glslang keeps process-wide tables, set up once and taken down at exit.
struct GlslangProcess {
    GlslangProcess() { glslang::InitializeProcess(); }
    ~GlslangProcess() { glslang::FinalizeProcess(); }
};

const auto parser_messages = static_cast<EShMessages>(EShMsgSpvRules | EShMsgVulkanRules);

/// One stage's text as glslang takes it: with what is put in front, or all in one.
class ShaderText {
public:
    ShaderText(ShaderStage stage, const std::string& front, const std::string& text, const std::string& name)
        : texts_{front.c_str(), text.c_str()},
          lengths_{static_cast<int>(front.size()), static_cast<int>(text.size())},
          names_{front_name, name.c_str()},
          shader_(glslang_stage(stage)) {
        const EShLanguage language = glslang_stage(stage);
        shader_.setStringsWithLengthsAndNames(texts_.data(), lengths_.data(), names_.data(), 2);
        shader_.setEnvInput(glslang::EShSourceGlsl, language, glslang::EShClientVulkan, glsl_version);
        shader_.setEnvClient(glslang::EShClientVulkan, glslang::EShTargetVulkan_1_3);
        shader_.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_6);
    }

    bool parse(Includer& includer) {
        return shader_.parse(GetDefaultResources(), glsl_version, ENoProfile, false, false, parser_messages, includer);
    }

    bool preprocess(Includer& includer, std::string& result) {
        return shader_.preprocess(GetDefaultResources(), glsl_version, ENoProfile, false, false, parser_messages,
                                  &result, includer);
    }

    glslang::TShader& shader() { return shader_; }

private:
    std::array<const char*, 2> texts_;
    std::array<int, 2> lengths_;
    std::array<const char*, 2> names_;
    glslang::TShader shader_;
};

/// What went wrong in a compilation, told with its place and its line.
class FailedCompilation {
public:
    FailedCompilation(const ShaderSource& source, const std::string& front, const std::string& text)
        : source_(source), front_(front), text_(text) {}

    /// Of glslang's parser or preprocessor, whose log this is.
    std::string of_parser(const char* log) {
        const std::optional<LogComplaint> complaint = first_complaint(log);
        if (!complaint) return fmt::format("{}: it does not compile, and the compiler does not say why", source_.file);
        const std::optional<FlatShader> flat = flatten();
        if (!flat) return of_preprocessor(*complaint);
        if (const std::optional<std::size_t> brace = flat->unbalanced_brace()) {
            const bool opens = flat->tokens()[*brace].is("{");
            return told(*flat, {opens ? "this '{' is never closed" : "this '}' closes nothing", brace});
        }
        if (complaint->message == "unexpected token") return of_foreign_character(*complaint);
        if (const std::optional<std::size_t> token = find_token(*complaint, *flat))
            return told(*flat, with_file_to_include(in_words(*complaint, *flat, *token), *complaint, *flat));
        return told(complaint->place, in_words(*complaint));
    }

    std::string of_linker(const char* log) {
        const std::optional<LogComplaint> complaint = first_complaint(log);
        const std::optional<FlatShader> flat = flatten();
        if (!complaint || !flat) return fmt::format("{}: it does not link: {}", source_.file, log);
        return told(*flat, linker_in_words(*complaint, *flat, source_.file));
    }

private:
    std::optional<FlatShader> flatten() {
        Includer includer(source_, silent_);
        std::string result;
        if (!ShaderText(source_.stage, front_, text_, source_.file).preprocess(includer, result)) return std::nullopt;
        return FlatShader(result, static_cast<int>(std::ranges::count(front_, '\n')), source_.file);
    }

    /// Parsed again with each token on a line of its own: lines of complaints then tell the token.
    std::optional<std::size_t> find_token(const LogComplaint& complaint, const FlatShader& flat) const {
        const std::string lines = flat.one_token_per_line();
        const std::string nothing;
        Includer includer(source_, silent_);
        ShaderText text(source_.stage, lines, nothing, source_.file);
        if (text.parse(includer)) return std::nullopt;
        const std::optional<LogComplaint> again = first_complaint(text.shader().getInfoLog());
        const std::size_t line = again ? static_cast<std::size_t>(again->place.line) : 0;
        if (!again || !again->says_the_same(complaint) || line < 1 || line > flat.tokens().size()) return std::nullopt;
        return line - 1;
    }

    /// A condition that is never closed is the fault of the file that opens it.
    std::string of_preprocessor(const LogComplaint& complaint) const {
        if (complaint.message != "missing #endif") return told(complaint.place, in_words(complaint));
        for (IncludedGlsl& file : glsl_with_includes({source_.file}, source_.roots)) {
            std::vector<GlslToken> open;
            for (GlslToken& token : file.tokens) {
                const std::string name = glsl_directive(token).name;
                if (name.starts_with("if")) open.push_back(std::move(token));
                if (name == "endif" && !open.empty()) open.pop_back();
            }
            if (!open.empty())
                return told({file.name.string(), open.front().line, open.front().column},
                            "this condition has no '#endif'");
        }
        return told(complaint.place, in_words(complaint));
    }

    std::string of_foreign_character(const LogComplaint& complaint) const {
        for (const GlslToken& token : glsl_tokens(source_text(complaint.place.file))) {
            const auto first = static_cast<unsigned char>(token.text.front());
            const bool foreign = first < ' ' || first > '~' || token.is("@") || token.is("$") || token.is("`");
            if (token.line == complaint.place.line && foreign && token.kind == GlslToken::Kind::mark)
                return told({complaint.place.file, token.line, token.column},
                            fmt::format("GLSL has no such character (byte 0x{:02x})", first));
        }
        return told(complaint.place, in_words(complaint));
    }

    /// Where what is not declared is declared by a file that is not included.
    WordedComplaint with_file_to_include(WordedComplaint worded, const LogComplaint& complaint,
                                         const FlatShader& flat) const {
        const bool missing = complaint.message == "undeclared identifier" ||
                             complaint.message.starts_with("no matching overloaded function");
        const auto is_declared = [&](const GlslDeclaration& declared) { return declared.name == complaint.symbol; };
        if (!missing || std::ranges::any_of(flat.declarations(), is_declared)) return worded;
        for (const std::filesystem::path& file : shader_files(source_)) {
            const auto tokens = glsl_tokens(read_text_file(file, largest_glsl_file));
            if (std::ranges::any_of(glsl_declarations(tokens), is_declared))
                worded.sentence += fmt::format("; {} declares it, which is not included", file.filename().string());
        }
        return worded;
    }

    std::string told(const FlatShader& flat, const WordedComplaint& worded) const {
        if (!worded.about) return worded.sentence;
        const std::string& text = flat.tokens()[*worded.about].text;
        SourcePlace place = flat.place(*worded.about);
        place.column = column_of(source_text(place.file), place.line, text, flat.earlier_on_its_line(*worded.about));
        if (worded.behind) place.column += static_cast<int>(text.size());
        return told(place, worded.sentence);
    }

    std::string told(const SourcePlace& place, const std::string& sentence) const {
        std::string text = place.file.empty() ? source_.file : place.file;
        if (place.line > 0) text += fmt::format(":{}", place.line);
        if (place.column > 0) text += fmt::format(":{}", place.column);
        text += ": " + sentence;
        const std::string line = show_line(source_text(place.file), place.line, place.column);
        return line.empty() ? text : text + '\n' + line;
    }

    /// Empty where there is none: of the front no line is anybody's.
    std::string source_text(const std::string& file) const {
        try {
            return file.empty() || file == front_name ? std::string() : read_source(source_, file);
        } catch (const Error&) {
            return {};
        }
    }

    const ShaderSource& source_;
    const std::string& front_;
    const std::string& text_;
    const ChildNote silent_ = [](std::string_view) {};
};

SpirV compile_here(const ShaderSource& source, const ChildNote& note) {
    const std::string front = "#version " + std::to_string(glsl_version) +
                              "\n#extension GL_GOOGLE_include_directive : require\n" + source.preamble;
    const std::string text = read_source(source, source.file);
    ShaderText compiled(source.stage, front, text, source.file);
    Includer includer(source, note);
    if (!compiled.parse(includer))
        fail("{}", FailedCompilation(source, front, text).of_parser(compiled.shader().getInfoLog()));

    glslang::TProgram program;
    program.addShader(&compiled.shader());
    if (!program.link(parser_messages))
        fail("{}", FailedCompilation(source, front, text).of_linker(program.getInfoLog()));

    glslang::SpvOptions options;
    options.disableOptimizer = true;
    const auto translate = [&] {
        SpirV words;
        glslang::GlslangToSpv(*program.getIntermediate(glslang_stage(source.stage)), words, &options);
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
