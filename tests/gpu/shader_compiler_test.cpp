#include "gpu/shader_compiler.hpp"

#include "core/file.hpp"
#include "support/error_message.hpp"
#include "support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

namespace reliefbench::gpu {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// Two folders for shaders, and one outside of them.
class ShaderCompiler : public testing::Test {
protected:
    void SetUp() override {
        for (const char* sub_folder : {"a", "b", "outside"})
            fs::create_directories(folder_ / sub_folder);
        write_text_file(folder_ / "outside" / "secret.glsl", "const int secret = 1;\n");
    }

    void write(const std::string& name, const std::string& text) const { write_text_file(folder_ / name, text); }

    SpirV compile(const std::string& preamble = "") const {
        return compile_shader({.stage = ShaderStage::compute,
                               .file = "main.comp",
                               .roots = {folder_ / "a", folder_ / "b"},
                               .generated = {{"made.glsl", "const int made = 4;\n"}},
                               .preamble = preamble});
    }

    std::string error() const {
        return error_message([&] { compile(); });
    }

    /// Of a compiler that is given little.
    std::string error_within(const ChildLimits& limits) const {
        return error_message([&] {
            compile_shader({.stage = ShaderStage::compute,
                            .file = "main.comp",
                            .roots = {folder_ / "a", folder_ / "b"},
                            .generated = {},
                            .preamble = ""},
                           limits);
        });
    }

    const fs::path& folder() const { return folder_.path(); }

private:
    const TemporaryFolder folder_;
};

TEST_F(ShaderCompiler, FindsFilesInEveryRootAndGeneratedOnes) {
    write("a/main.comp",
          "#include \"helper.glsl\"\n#include \"made.glsl\"\nvoid main() { int x = help + made + given; }");
    write("b/helper.glsl", "const int help = 2;\n");
    const SpirV code = compile("const int given = 1;\n");
    ASSERT_FALSE(code.empty());
    constexpr std::uint32_t spirv_magic = 0x07230203;
    EXPECT_EQ(code.front(), spirv_magic);
}

TEST_F(ShaderCompiler, ErrorNamesFileAndLineOfAnInclude) {
    write("a/main.comp", "#include \"helper.glsl\"\nvoid main() {}\n");
    write("b/helper.glsl", "\n\nint broken = ;\n");
    EXPECT_THAT(error(), HasSubstr("helper.glsl:3:"));
}

TEST_F(ShaderCompiler, ErrorAfterAnIncludeNamesTheIncludingFile) {
    write("a/main.comp", "#include \"helper.glsl\"\n\nvoid main() { nonsense(); }\n");
    write("b/helper.glsl", "const int help = 2;\n\n\n\n");
    EXPECT_THAT(error(), HasSubstr("main.comp:3:"));
}

TEST_F(ShaderCompiler, IncludeCannotClimb) {
    write("a/main.comp", "#include \"../outside/secret.glsl\"\nvoid main() {}\n");
    EXPECT_THAT(error(), HasSubstr("leaves the folders"));
    write("a/main.comp", "#include \"" + (folder() / "outside" / "secret.glsl").string() + "\"\nvoid main() {}\n");
    EXPECT_THAT(error(), HasSubstr("leaves the folders"));
}

TEST_F(ShaderCompiler, LinkCannotLeadOut) {
    write("a/main.comp", "#include \"link.glsl\"\nvoid main() {}\n");
    fs::create_symlink(folder() / "outside" / "secret.glsl", folder() / "a" / "link.glsl");
    EXPECT_THAT(error(), HasSubstr("leads out"));
}

TEST_F(ShaderCompiler, CycleEnds) {
    write("a/main.comp", "#include \"loop.glsl\"\nvoid main() {}\n");
    write("a/loop.glsl", "#include \"loop.glsl\"\n");
    EXPECT_THAT(error(), HasSubstr("does a file include itself?"));
}

TEST_F(ShaderCompiler, IncludesThatMultiplyEnd) {
    // Each file includes the next one twice: 2^15 files in all.
    write("a/main.comp", "#include \"0.glsl\"\nvoid main() {}\n");
    for (int i = 0; i < 40; ++i)
        write(fmt::format("a/{}.glsl", i), fmt::format("#include \"{0}.glsl\"\n#include \"{0}.glsl\"\n", i + 1));
    const std::string message = error();
    EXPECT_THAT(message, HasSubstr("15.glsl:1:"));
    EXPECT_LT(message.size(), 10000u) << "one complaint after the other";
}

/// x0 is one statement, x1 two of it, x2 four, ... and main() has the last.
std::string doubling_macros(int doublings) {
    std::string text = "#define x0 y += 1.0;\n";
    for (int i = 1; i <= doublings; ++i)
        text += fmt::format("#define x{0} x{1} x{1}\n", i, i - 1);
    return text + fmt::format("void main() {{ float y = 0.0; x{} }}\n", doublings);
}

TEST_F(ShaderCompiler, AMillionMacroExpansionsEnd) {
    write("a/main.comp", "#include \"macros.glsl\"\n");
    write("a/macros.glsl", doubling_macros(20));
    const std::string within_time = error_within({.cpu_s = 1});
    EXPECT_THAT(within_time, HasSubstr("main.comp: the compiler did not come to an end: "));
    EXPECT_THAT(within_time, HasSubstr("it had read 'macros.glsl'"));
    EXPECT_THAT(error_within({.memory_bytes = 100 << 20}), HasSubstr("did not come to an end"));
}

TEST_F(ShaderCompiler, WhatIsTooLargeForADriverIsNotGivenToIt) {
    write("a/main.comp", doubling_macros(10));
    EXPECT_THAT(error_within({.result_bytes = 4096}), HasSubstr("what it made is larger than 1 MB"));
    EXPECT_FALSE(compile().empty());
}

TEST_F(ShaderCompiler, ACompilerThatCrashesIsAnError) {
    // Every level is a call of the parser's, and of all that walk the tree.
    constexpr int levels = 200000;
    write("a/main.comp",
          "void main() { int x = " + std::string(levels, '(') + "1" + std::string(levels, ')') + "; }\n");
    EXPECT_THAT(error(), HasSubstr("main.comp"));
    write("a/main.comp", "void main() { int x = " + std::string(levels, '-') + "1; }\n");
    EXPECT_THAT(error(), HasSubstr("main.comp"));
}

TEST_F(ShaderCompiler, NameInTwoRootsIsAmbiguous) {
    write("a/main.comp", "#include \"helper.glsl\"\nvoid main() {}\n");
    write("a/helper.glsl", "");
    write("b/helper.glsl", "");
    EXPECT_THAT(error(), HasSubstr("rename one"));
}

TEST_F(ShaderCompiler, MissingFilesAreNamed) {
    EXPECT_THAT(error(), HasSubstr("'main.comp' is not in"));
    write("a/main.comp", "\n#include \"nowhere.glsl\"\nvoid main() {}\n");
    EXPECT_THAT(error(), HasSubstr("main.comp:2:"));
    EXPECT_THAT(error(), HasSubstr("'nowhere.glsl' is not in"));
}

}  // namespace
}  // namespace reliefbench::gpu
