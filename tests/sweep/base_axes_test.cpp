#include "configuration_text.hpp"
#include "manifest/reserved_names.hpp"

#include <gmock/gmock.h>

namespace reliefbench {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

/// Of contract 1, with a parameter that has the name of a later axis.
Manifest technique_with_parameter(const std::string& name) {
    const std::string text = R"({"title": "Old", "kind": "march", "citation": "Nobody", "shape": "quad",
        "promises": [], "parameters": [{"name": ")" +
                             name + R"(", "type": "real", "default": 0, "range": [-1, 1], "help": "Bend."}]})";
    return parse_manifest(parse_json(text, "old"), "old", "old");
}

TEST(BaseAxes, TechniquesOfTheFirstContractMayHaveTheirNamesAsParameters) {
    for (const char* name : {"base", "curvature", "base_segments", "base_fit"}) {
        EXPECT_EQ(check_glsl_name(name, 1), "") << name;
        EXPECT_THAT(check_glsl_name(name, 2), HasSubstr("is an axis of a configuration")) << name;
        EXPECT_NE(technique_with_parameter(name).find_parameter(name), nullptr) << name;
    }
    const std::vector<Manifest> old{technique_with_parameter("curvature")};
    const auto cells = [&](const std::string& text) {
        std::vector<std::string> found;
        for (const Cell& cell : expand(parse_configuration(parse_json(text, "test.json"), "test.json", {}, old), old))
            found.push_back(cell.id);
        return found;
    };
    EXPECT_THAT(cells(R"({"techniques": [{"technique": "old", "parameters": {"curvature": 0.5}}],
                          "axes": {"heightmap": "rock"}})"),
                ElementsAre("old curvature=0.5 | heightmap=rock"));
    EXPECT_THAT(
        error_message([&] { cells(R"({"techniques": ["old"], "axes": {"heightmap": "rock", "curvature": 0.5}})"); }),
        AllOf(HasSubstr("$.axes.curvature: 'curvature' is an axis of the view, and the technique old has a "
                        "parameter of that name"),
              HasSubstr(R"({"technique": "old", "parameters": {"curvature": ...}})")));
}

}  // namespace
}  // namespace reliefbench
