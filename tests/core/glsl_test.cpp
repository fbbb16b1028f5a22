#include "core/glsl_declarations.hpp"
#include "core/glsl_tokens.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace reliefbench {
namespace {

using testing::ElementsAre;

std::vector<std::string> texts(const std::vector<GlslToken>& tokens) {
    std::vector<std::string> result;
    for (const GlslToken& token : tokens)
        result.push_back(token.text);
    return result;
}

std::vector<std::string> names(const std::string& glsl) {
    std::vector<std::string> result;
    for (const GlslDeclaration& declared : glsl_declarations(glsl_tokens(glsl)))
        result.push_back(declared.name);
    return result;
}

TEST(GlslTokens, AreWordsNumbersAndOperatorsWithoutComments) {
    EXPECT_THAT(texts(glsl_tokens("a<<=1.5e-3f; // no\n/* nor\n this */x.y>=0x1e+2u")),
                ElementsAre("a", "<<=", "1.5e-3f", ";", "x", ".", "y", ">=", "0x1e", "+", "2u"));
    EXPECT_THAT(texts(glsl_tokens("a / b")), ElementsAre("a", "/", "b"));
    EXPECT_TRUE(glsl_tokens("").empty());
    EXPECT_TRUE(glsl_tokens("/* open").empty());
    EXPECT_THAT(texts(glsl_tokens("\xC3\xBC")), ElementsAre("\xC3", "\xBC"));
}

TEST(GlslTokens, ACommentThatEndsInABackslashGoesOn) {
    EXPECT_THAT(texts(glsl_tokens("a // b \\\nc\nd // e \\\r\nf")), ElementsAre("a", "d"));
}

TEST(GlslTokens, ACarriageReturnAloneEndsALine) {
    EXPECT_THAT(texts(glsl_tokens("a // b\rc\r#if 1\rd")), ElementsAre("a", "c", "#if 1", "d"));
}

TEST(GlslTokens, NamesOfIncludedFilesMayHoldWhatBeginsAComment) {
    EXPECT_EQ(included_file(glsl_tokens("#include \"p//own.glsl\" // p").front()), "p//own.glsl");
    EXPECT_EQ(included_file(glsl_tokens("#include <p/*/own.glsl>").front()), "p/*/own.glsl");
}

TEST(GlslTokens, TellWhereTheyStand) {
    const std::vector<GlslToken> tokens = glsl_tokens("\xEF\xBB\xBF/* a\n */ x\r\n\t+= 2;");
    ASSERT_EQ(tokens.size(), 4U);
    EXPECT_EQ(tokens[0].line, 2);
    EXPECT_EQ(tokens[0].column, 5);
    EXPECT_EQ(tokens[1].line, 3);
    EXPECT_EQ(tokens[1].column, 2);
}

TEST(GlslTokens, ADirectiveIsOneTokenWithItsContinuations) {
    const std::vector<GlslToken> tokens =
        glsl_tokens("  # define f(x) \\\r\n  (x) // no\n#include \"a.glsl\" /* */\nb # c");
    ASSERT_EQ(tokens.size(), 5U);
    EXPECT_EQ(glsl_directive(tokens[0]).name, "define");
    EXPECT_EQ(glsl_directive(tokens[0]).rest, "f(x)    (x)");
    EXPECT_EQ(included_file(tokens[1]), "a.glsl");
    EXPECT_EQ(tokens[1].line, 3);
    EXPECT_EQ(included_file(tokens[0]), "");
    EXPECT_EQ(tokens[2].text, "b");
    EXPECT_NE(tokens[3].kind, GlslToken::Kind::directive) << "it does not begin its line";
}

TEST(GlslDeclarations, AreWhatIsGlobal) {
    EXPECT_THAT(
        names("#define M(a) a\nconst int a = f(1, 2), b[2] = int[](1, 2); float g(vec2 uv) { int c; return uv.x; }\n"
              "float h(int);\nstruct S { int d; } e;\nint i;"),
        ElementsAre("M", "a", "b", "g", "h", "S", "e", "i"));
    EXPECT_THAT(names("layout(set = 0, binding = 1) uniform sampler2D map;\n"
                      "layout(std140) uniform B { int x; } y;\nlayout(std430) buffer C { uint z; uint w[]; };"),
                ElementsAre("map", "B", "y", "C", "z", "w"));
    EXPECT_THAT(names("#ifdef A\nint a;\n#else\nint b;\n#endif"), ElementsAre("a", "b"));
    EXPECT_THAT(names("void f() { if (true) { } } int a;"), ElementsAre("f", "a"));
}

TEST(GlslDeclarations, FunctionsHaveTheirSignatures) {
    const auto found =
        glsl_declarations(glsl_tokens("vec4\n f( sampler2D map ,ivec2 texel, out float[2] x ) { }\nbool g();"));
    ASSERT_EQ(found.size(), 2U);
    EXPECT_EQ(found[0].text, "vec4 f(sampler2D map, ivec2 texel, out float[2] x)");
    EXPECT_TRUE(found[0].has_body);
    EXPECT_EQ(found[1].text, "bool g()");
    EXPECT_FALSE(found[1].has_body);
}

// What editors hold half-written.
TEST(GlslDeclarations, WhatIsCutShortEnds) {
    for (const char* text : {"struct", "struct S {", "int a[", "f(", "void f() {", "layout", "layout(", "}", ")",
                             "int a =", "#", "#define", "=", "{", "uniform B {", "uniform B { int a; } "})
        glsl_declarations(glsl_tokens(text));
}

}  // namespace
}  // namespace reliefbench
