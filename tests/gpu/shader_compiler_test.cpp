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
