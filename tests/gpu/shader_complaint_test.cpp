#include "gpu/shader_complaint.hpp"

#include <gtest/gtest.h>

namespace reliefbench::gpu {
namespace {

TEST(ShaderComplaint, IsTheLogsFirst) {
    const auto complaint = first_complaint(
        "WARNING: a.glsl:1: 'x' : something\nERROR: a: b.glsl:12: 'z' : undeclared identifier \nERROR: c.frag:3: '' : "
        "more\n");
    ASSERT_TRUE(complaint);
    EXPECT_EQ(complaint->place.file, "a: b.glsl");
    EXPECT_EQ(complaint->place.line, 12);
    EXPECT_EQ(complaint->symbol, "z");
    EXPECT_EQ(complaint->message, "undeclared identifier");
    EXPECT_FALSE(first_complaint("WARNING: only\n\n"));
    EXPECT_FALSE(first_complaint(""));
}

TEST(ShaderComplaint, OfTheLinkerHasAllItsLines) {
    const auto complaint =
        first_complaint("ERROR: Linking fragment stage: No function definition (body) found: \n    f(vf2;\n\n");
    ASSERT_TRUE(complaint);
    EXPECT_EQ(complaint->place.file, "");
    EXPECT_EQ(complaint->message, "Linking fragment stage: No function definition (body) found: f(vf2;");
}

/// Two lines in front, then a.frag with b.glsl in its middle.
const char* const preprocessed =
    "#version 460\nconst int p = 0;\nint a;\n#line 1 \"b.glsl\"\n\nint b = p + p;\n#line 3 \"a.frag\"\n"
    "void main(){ }\n";

TEST(FlatShader, KnowsWhereItsTokensCameFrom) {
    const FlatShader flat(preprocessed, 2, "a.frag");
    const auto place_of = [&](const std::string& text, int n = 0) {
        for (std::size_t i = 0; i < flat.tokens().size(); ++i) {
            if (flat.tokens()[i].text == text && n-- == 0) return flat.place(i);
        }
        return SourcePlace{"nowhere", 0, 0};
    };
    EXPECT_EQ(place_of("460").file, "nowhere") << "a directive is one token";
    EXPECT_EQ(place_of("p").file, "");
    EXPECT_EQ(place_of("a").file, "a.frag");
    EXPECT_EQ(place_of("a").line, 1);
    EXPECT_EQ(place_of("b").file, "b.glsl");
    EXPECT_EQ(place_of("b").line, 2);
    EXPECT_EQ(place_of("main").file, "a.frag");
    EXPECT_EQ(place_of("main").line, 3);
    EXPECT_FALSE(flat.unbalanced_brace());
    EXPECT_TRUE(flat.one_token_per_line().starts_with("#version 460\nconst\nint\np\n=\n0\n;\nint\na\n;\nint\nb\n"));
}

TEST(FlatShader, TheSecondOfTwoAlikeHasItsOwnColumn) {
    const FlatShader flat(preprocessed, 2, "a.frag");
    std::size_t last = 0;
    for (std::size_t i = 0; i < flat.tokens().size(); ++i) {
        if (flat.tokens()[i].text == "p") last = i;
    }
    EXPECT_EQ(flat.earlier_on_its_line(last), 1);
    EXPECT_EQ(column_of("\n  int b = p /* p */ + p;\n", 2, "p", 1), 23);
    EXPECT_EQ(column_of("\n  int b = P(1);\n", 2, "p", 0), 3) << "of a macro the line's beginning";
}

TEST(FlatShader, UnbalancedBracesAreFound) {
    EXPECT_EQ(FlatShader("void f() { { }\nvoid g() { }\n", 0, "a").unbalanced_brace(), 4U);
    EXPECT_EQ(FlatShader("void f() { } }\n", 0, "a").unbalanced_brace(), 6U);
}

TEST(ShownLine, HasItsCaretUnderTheColumn) {
    EXPECT_EQ(show_line("a\n\tb\xC3\xBC = c;\r\n", 2, 8), "    \tb\xC3\xBC = c;\n    \t     ^")
        << "columns are of bytes";
    EXPECT_EQ(show_line("  ab", 1, 0), "      ab\n      ^");
    EXPECT_EQ(show_line("ab", 1, 3), "    ab\n      ^") << "behind the line's end";
    EXPECT_EQ(show_line("ab", 2, 1), "");
    const std::string wide = std::string(300, 'x').append("y").append(300, 'z');
    const std::string shown = show_line(wide, 1, 301);
    const std::size_t end = shown.find('\n');
    EXPECT_LT(end, 125U);
    EXPECT_EQ(shown[shown.size() - 1 - end - 1], 'y') << "the caret's column of the first line";
}

}  // namespace
}  // namespace reliefbench::gpu
