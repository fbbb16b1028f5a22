// What the author of a technique reads when it does not compile.

#include "test_scene.hpp"

#include "core/glsl_declarations.hpp"
#include "gpu/shader_compiler.hpp"
#include "manifest/shader_names.hpp"
#include "support/error_message.hpp"
#include "technique/program.hpp"

#include <gmock/gmock.h>

#include <cstring>
#include <set>

namespace reliefbench {
namespace {

using namespace test;
using Files = TemporaryTechnique::Files;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;

const char* const marching = R"(// A march.
Trace trace(ReliefRay ray) {
    float s = 0.0;
    for (int i = 0; i < 8; ++i) {
        float h = tap_height(point_on_ray(ray, s));
        if (h > 1.0 - s) break;
        s += 0.125;
    }
    return hit_on_ray(s, 8);
}
)";

std::string replaced(std::string text, const std::string& passage, const std::string& replacement) {
    const std::size_t at = text.find(passage);
    EXPECT_NE(at, std::string::npos) << passage;
    return text.replace(at, passage.size(), replacement);
}

class CompileMessage : public DeviceTest {
protected:
    static void draw(const Files& files) {
        const TemporaryTechnique folder(files);
        const SceneOnDevice scene(device(), make_map({4, 4}, [](int, int) { return 0.5; }), grey_albedo());
        make_renderer(device(), folder.load(), scene, make_view(0, Projection::parallel, {4, 4})).probe();
    }

    /// After the line that names the technique.
    static std::string message(const Files& files) {
        const std::string text = error_message([&] { draw(files); });
        EXPECT_THAT(text, testing::ContainsRegex("^technique 'technique_[0-9]+' \\(.*\\) does not compile:"));
        return text.substr(std::min(text.find('\n') + 1, text.size()));
    }

    static std::string message_of_march(const std::string& passage, const std::string& replacement) {
        return message({{"trace.glsl", replaced(marching, passage, replacement)}});
    }
};

TEST_F(CompileMessage, AMissingSemicolonIsMissingWhereItIs) {
    EXPECT_EQ(message_of_march("// A march.", "const float extra = 1.0"),
              "trace.glsl:1:24: a ';' is missing after '1.0'\n"
              "    const float extra = 1.0\n"
              "                           ^");
    EXPECT_EQ(message_of_march("float s = 0.0;", "float s = 0.0 // the entry"),
              "trace.glsl:3:18: a ';' is missing after '0.0'\n"
              "        float s = 0.0 // the entry\n"
              "                     ^");
    EXPECT_EQ(message({{"trace.glsl", std::string(marching) + "\nconst int last = 3"}}),
              "trace.glsl:12:19: a ';' is missing after '3'\n"
              "    const int last = 3\n"
              "                      ^")
        << "the next token stands in a file of the harness";
}

TEST_F(CompileMessage, IsAboutTheFileOfTheFault) {
    const std::string including = replaced(marching, "// A march.", "#include \"helper.glsl\"");
    EXPECT_EQ(message({{"trace.glsl", including}, {"helper.glsl", "\nfloat help(float x) {\n\treturn x + y;\n}\n"}}),
              "helper.glsl:3:13: 'y' is not declared\n"
              "    \treturn x + y;\n"
              "    \t           ^");
    EXPECT_THAT(message({{"trace.glsl", including}, {"helper.glsl", "const int a = 3"}}),
                HasSubstr("helper.glsl:1:16: a ';' is missing after '3'"));
    EXPECT_THAT(message_of_march("        s += 0.125", "        { s += 0.125"),
                HasSubstr("trace.glsl:2:28: this '{' is never closed"));
    EXPECT_THAT(message_of_march("float s = 0.0;", "float s = 0.0; }"),
                HasSubstr("trace.glsl:10:1: this '}' closes nothing"));
    EXPECT_THAT(message_of_march("// A march.", "\n#ifdef X"),
                HasSubstr("trace.glsl:2:1: this condition has no '#endif'"));
    EXPECT_THAT(
        message_of_march("// A march.", "#include \"marsh.glsl\""),
        testing::AllOf(HasSubstr("trace.glsl:1: 'marsh.glsl' is not in "), HasSubstr("(did you mean 'march.glsl'?)")));
}

TEST_F(CompileMessage, HasNoComplaintsThatFollowFromTheFirst) {
    for (const char* wrong : {"float s = z;", "int s = 0.5;", "float s = 0.0; @", "float s = 0.0; float s = 1.0;"}) {
        const std::string text = message_of_march("float s = 0.0;", wrong);
        EXPECT_THAT(text, HasSubstr("trace.glsl:3:")) << wrong;
        EXPECT_THAT(text, Not(HasSubstr("quad.frag"))) << wrong;
        EXPECT_THAT(text, EndsWith("^")) << wrong;
    }
}

TEST_F(CompileMessage, SaysWhatThereIsInPlainWords) {
    EXPECT_THAT(message_of_march("tap_height(", "tap_hight("),
                HasSubstr("there is no function 'tap_hight' that takes these arguments (did you mean 'tap_height'?)"));
    EXPECT_THAT(message_of_march("point_on_ray(ray, s)", "ray, s"),
                HasSubstr("trace.glsl:5:19: 'tap_height' takes other arguments: 'float tap_height(vec2 uv)'"));
    EXPECT_THAT(message_of_march("Trace trace", "Trac trace"),
                HasSubstr("trace.glsl:2:1: 'Trac' is no type (did you mean 'Trace'?)"));
    EXPECT_THAT(message_of_march("return hit_on_ray(s, 8)", "return s"),
                HasSubstr("what is returned is not what 'Trace trace(ReliefRay ray)' returns"));
    EXPECT_THAT(message_of_march("// A march.", "float tap_height(vec2 uv) { return 0.0; }"),
                HasSubstr("trace.glsl:1:7: 'float tap_height(vec2 uv)' is defined already, in taps.glsl:"));
    EXPECT_THAT(message_of_march("float s = 0.0;", "float s = 0.0; search_cones(ray, 3);"),
                HasSubstr("; cone_march.glsl declares it, which is not included"));
}

TEST_F(CompileMessage, SaysWhichFunctionIsNotDefined) {
    EXPECT_THAT(message_of_march("Trace trace(", "Trace tracer("),
                testing::AllOf(HasSubstr("nothing defines 'Trace trace(ReliefRay ray)', which checked_trace.glsl:"),
                               HasSubstr("(did you mean 'tracer'?)")));
    EXPECT_THAT(message_of_march("ReliefRay ray)", "ReliefRay ray, int x)"),
                HasSubstr("trace.glsl:2:7: nothing defines 'Trace trace(ReliefRay ray)', which checked_trace.glsl:"));
    EXPECT_THAT(message({{"trace.glsl",
                          "#include \"cone_march.glsl\"\nvec2 tap_cone(ReliefRay ray, float s) { return vec2(0.0); }\n"
                          "float least_step(ReliefRay ray, float s) { return 0.1; }\nTrace trace(ReliefRay ray) "
                          "{ ConeSearch c = search_cones(ray, 3); return answer(c, unrefined(c)); }\n"}}),
                HasSubstr("nothing defines 'bool looks_for_bumps()', which cone_march.glsl:"));
    EXPECT_THAT(message_of_march("float s = 0.0;", "trace(ray); float s = 0.0;"),
                HasSubstr("trace.glsl:2:7: 'trace' calls itself; GLSL has no recursion"));
}

/// Two maps, the second made after the first.
Files with_maps(const std::string& trace, const std::string& second_pass) {
    return {{"technique.json",
             manifest_json("", R"(, "maps": [{"name": "tree", "format": "r32f"}, {"name": "leaves", "format": "r32f"}],
                                    "passes": [{"name": "a", "shader": "a.glsl", "writes": "tree"},
                                               {"name": "b", "shader": "b.glsl", "writes": "leaves"}])")},
            {"a.glsl", "void prepare(ivec2 texel) { write_map(vec4(tap_height_texel(texel))); }\n"},
            {"b.glsl", second_pass},
            {"trace.glsl", trace}};
}

TEST_F(CompileMessage, AnUndeclaredMapListsThoseThatThereAre) {
    const char* const pass = "void prepare(ivec2 texel) { write_map(tap_map_texel(tree, texel, 0)); }\n";
    const auto reading = [](const std::string& fetch) {
        return "Trace trace(ReliefRay ray) {\n    return hit_on_ray(" + fetch + ".r, 0);\n}\n";
    };
    EXPECT_EQ(
        message(with_maps(reading("tap_map(tre, ray.uv, 0.0)"), pass)),
        "trace.glsl:2:31: no map 'tre' is declared (did you mean 'tree'?); the maps that can be read here are 'tree', "
        "'leaves'\n"
        "        return hit_on_ray(tap_map(tre, ray.uv, 0.0).r, 0);\n"
        "                                  ^");
    EXPECT_THAT(message(with_maps(marching, replaced(pass, "tree", "leaves"))),
                HasSubstr("b.glsl:1:53: no map 'leaves' is declared; the map that can be read here is 'tree'"));
    EXPECT_THAT(message({{"trace.glsl", reading("tap_map_texel(tree, ivec2(0), 0)")}}),
                HasSubstr("no map 'tree' is declared; no map is declared that could be read here"));
    EXPECT_NO_THROW(draw(with_maps(reading("tap_map(leaves, ray.uv, 0.0)"), pass)));
}

TEST_F(CompileMessage, PassesAndStagesAreToldAlike) {
    EXPECT_THAT(message(with_maps(marching, "void prepare(ivec2 texel) {\n    write_map(vec4(1.0)\n}\n")),
                HasSubstr("b.glsl:3:1: expected ')' or ',' after ')', not '}'"));
    EXPECT_THAT(message(with_maps(marching, "void prepares(ivec2 texel) {}\n")),
                testing::AllOf(HasSubstr("nothing defines 'void prepare(ivec2 texel)', which prepare.comp:"),
                               HasSubstr("(did you mean 'prepares'?)")));
    if (!device().info().has_feature("tessellationShader")) return;
    const Files patches{
        {"technique.json",
         manifest_json(R"({"name": "patches", "type": "integer", "default": 2, "range": [0, 8], "help": "h"})", "",
                       R"({"patches": {"parameter": "patches"}})")},
        {"control.tesc",
         "#include \"patches.glsl\"\nvoid main() {\n    pass_corner();\n    set_tessellation_factor(1.0);\n}\n"},
        {"evaluation.tese",
         "#include \"patches.glsl\"\nlayout(quads, equal_spacing, ccw) in;\nvoid main() {\n"
         "    emit_surface(grid_coordinates(), 0.5);\n}\n"}};
    const auto broken = [&](const std::string& file, const std::string& passage, const std::string& replacement) {
        Files files = patches;
        files[file] = replaced(files[file], passage, replacement);
        return message(files);
    };
    EXPECT_NO_THROW(draw(patches));
    EXPECT_THAT(broken("control.tesc", "(1.0);", "(1.0)"), HasSubstr("control.tesc:4:33: a ';' is missing after ')'"));
    EXPECT_THAT(broken("control.tesc", "#include", "x\n#include"), HasSubstr("control.tesc:1:1: "));
    EXPECT_THAT(broken("evaluation.tese", "0.5", "half_way"),
                HasSubstr("evaluation.tese:4:38: 'half_way' is not declared"));
    EXPECT_THAT(broken("evaluation.tese", "void main", "void mein"),
                HasSubstr("evaluation.tese: there is no 'void main()'"));
}

TEST_F(CompileMessage, AByteOrderMarkIsNoFault) {
    const std::string mark = "\xEF\xBB\xBF";
    EXPECT_NO_THROW(draw({{"trace.glsl", mark + "#include \"helper.glsl\"\n" + marching},
                          {"helper.glsl", mark + "const int helping = 1;\n"}}));
    EXPECT_NO_THROW(
        draw(with_maps(marching, mark + "void prepare(ivec2 texel) { write_map(tap_map_texel(tree, texel, 0)); }\n")));
    EXPECT_THAT(message({{"trace.glsl", mark + replaced(marching, "// A march.", "int x = y;")}}),
                HasSubstr("trace.glsl:1:9: 'y' is not declared"));
}

/// What a module names: variables outside of functions, specialization constants, structures and blocks, functions.
std::set<std::string> global_names(const gpu::SpirV& module) {
    constexpr std::uint32_t op_name = 5, op_type_struct = 30, op_spec_constant_true = 48, op_spec_constant = 50;
    constexpr std::uint32_t op_function = 54, op_variable = 59, storage_function = 7;
    std::map<std::uint32_t, std::string> names;
    std::set<std::string> found;
    for (std::size_t at = 5; at < module.size(); at += module[at] >> 16) {
        const std::uint32_t code = module[at] & 0xFFFFU;
        const auto add = [&](std::uint32_t id) {
            const std::string& name = names[id];
            found.insert(name.substr(0, name.find('(')));
        };
        if (code == op_name) names[module[at + 1]] = reinterpret_cast<const char*>(&module[at + 2]);
        if (code == op_type_struct) add(module[at + 1]);
        if (code >= op_spec_constant_true && code <= op_spec_constant) add(module[at + 2]);
        if (code == op_function || (code == op_variable && module[at + 3] != storage_function)) add(module[at + 2]);
    }
    return found;
}

// The scan of the shaders' text against the compiler: what it names for the harness is reserved.
TEST_F(CompileMessage, NamesThatTheCompilerKnowsAreReserved) {
    for (const char* id : {"pom", "cone_step", "qdm", "tessellation"}) {
        const Technique technique = find_techniques({default_technique_root()}).get(id);
        const Manifest& manifest = technique.manifest;
        if (manifest.shape.kind == "patches" && !device().info().has_feature("tessellationShader")) continue;
        const std::set<std::string> reserved = names_of_shaders(manifest, technique.shaders, technique.folder);
        std::set<std::string> own{"", "main", "gl_PerVertex"};
        for (const Parameter& parameter : manifest.parameters)
            own.insert(parameter.name);
        for (const MapDeclaration& map : manifest.maps)
            own.insert(map.name);
        for (const auto& file : std::filesystem::directory_iterator(technique.folder)) {
            if (file.path().extension() == ".png" || file.path().extension() == ".md") continue;
            for (const GlslDeclaration& declared : glsl_declarations(glsl_tokens(read_text_file(file.path()))))
                own.insert(declared.name);
        }
        std::vector<gpu::CompiledStage> stages =
            compile_draw(device(), technique, manifest.defaults(), Variant::probed, View{});
        for (const PassDeclaration& pass : manifest.passes)
            stages.push_back(compile_pass(device(), technique, manifest.defaults(), pass, Variant::probed));
        std::size_t looked_at = 0;
        for (const gpu::CompiledStage& stage : stages) {
            for (const std::string& name : global_names(*stage.code)) {
                if (own.contains(name) || name.starts_with("gl_") || name == "target_map") continue;
                ++looked_at;
                EXPECT_TRUE(reserved.contains(name)) << id << ": " << name;
            }
        }
        EXPECT_GT(looked_at, 30U) << id;
    }
}

}  // namespace
}  // namespace reliefbench
