// Manifests in folders, and the sets of parameters, maps and passes that they include from the shared shaders.
#include "complete_manifest.hpp"
#include "core/file.hpp"
#include "support/temporary_folder.hpp"

#include <gmock/gmock.h>

#include <filesystem>

namespace reliefbench {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

/// A folder of its own for each test, removed at its end.
class ManifestFolder : public testing::Test {
protected:
    ManifestFolder() { fs::create_directories(folder_ / "sub"); }

    void write(const std::string& name, const std::string& text = "") { write_text_file(folder_ / name, text); }
    std::string load_message() {
        return error_message([&] { load_manifest(folder_); });
    }

    const TemporaryFolder temporary_;
    const fs::path folder_ = temporary_ / "marcher";
};

TEST_F(ManifestFolder, IsCompleteWithItsShaders) {
    write("technique.json", complete().dump());
    EXPECT_THAT(load_message(),
                AllOf(HasSubstr("technique.json"), HasSubstr("'trace.glsl', which is not in the folder")));
    write("trace.glsl");
    write("leaves.glsl");
    write("nodes.glsl");
    EXPECT_THAT(load_message(), AllOf(HasSubstr("the pass 'search'"), HasSubstr("'sub/search.glsl'")));
    write("sub/search.glsl");
    EXPECT_EQ(load_manifest(folder_).id, "marcher");
    EXPECT_EQ(load_manifest(folder_ / "").id, "marcher");
}

TEST_F(ManifestFolder, OfPatchesHasBothTessellationStages) {
    Json json = complete();
    json["maps"] = Json::array();
    json["passes"] = Json::array();
    json["shape"] = parse_json(R"({"patches": {"parameter": "max_steps"}})", "test");
    write("technique.json", json.dump());
    EXPECT_THAT(load_message(), HasSubstr("'control.tesc'"));
    write("control.tesc");
    EXPECT_THAT(load_message(), HasSubstr("'evaluation.tese'"));
    write("evaluation.tese");
    EXPECT_NO_THROW(load_manifest(folder_));
}

/// A name of a file that only some techniques include is theirs to avoid.
TEST_F(ManifestFolder, NamesOfIncludedFilesAreItsShadersToo) {
    Json json = complete();
    json["maps"] = Json::array();
    json["passes"] = Json::array();
    json["parameters"][1]["name"] = "contact";
    json.erase("sample_count_minimum");
    json.erase("search_cap");
    write("technique.json", json.dump());
    write("trace.glsl", "#include \"sub/search.glsl\"\nfloat adaptive_own; // #include \"cone_march.glsl\"\n");
    write("sub/search.glsl", "const int own = 1;\n");
    EXPECT_NO_THROW(load_manifest(folder_, shared_shaders));
    write("sub/search.glsl", "\xEF\xBB\xBF#include \"cone_refinement.glsl\"\n");
    EXPECT_THAT(error_message([&] { load_manifest(folder_, shared_shaders); }),
                HasSubstr("$.parameters[1].name: 'contact' is a name that the harness's shaders use; choose another"));
}

TEST_F(ManifestFolder, WithoutAManifestIsAnError) {
    EXPECT_THAT(load_message(), HasSubstr("technique.json"));
    write("technique.json", "{\"title\": ");
    EXPECT_THAT(load_message(), HasSubstr("technique.json:1:"));
}

/// A folder with sets of shared parameters beside that of a technique.
class IncludedSets : public ManifestFolder {
protected:
    IncludedSets() {
        fs::create_directories(shared_);
        write_text_file(shared_ / "steps.json", R"({
            "parameters": [
                {"name": "count", "type": "integer", "default": 15, "range": [1, 64], "help": "Layers."},
                {"name": "search", "type": "choice", "choices": ["none", "binary"], "default": "none", "help": "Last."},
                {"name": "halvings", "type": "integer", "default": 6, "range": [0, 24], "published": 6,
                 "only_with": {"search": "binary"}, "help": "Halvings."}],
            "maps": [{"name": "mips", "format": "r16", "only_with": {"search": ["none", "binary"], "count": 9}}],
            "passes": [{"name": "copy", "shader": "copy.glsl", "writes": "mips"}]})");
        write("trace.glsl");
    }

    static Json including(const std::string& sets, const std::string& parameters) {
        return parse_json(R"({"title": "T", "kind": "march", "citation": "N", "promises": [], "shape": "quad",
                              "include": )" +
                              sets + R"(, "parameters": )" + parameters + "}",
                          "test");
    }
    Manifest parse_including(const Json& json) const { return parse_manifest(json, "test", "technique.json", shared_); }
    std::string message_including(const std::string& sets, const std::string& parameters) const {
        return error_message([&] { parse_including(including(sets, parameters)); });
    }
    void write_set(const std::string& name, const std::string& parameters) const {
        write_text_file(shared_ / name, R"({"parameters": )" + parameters + "}");
    }

    const fs::path shared_ = temporary_ / "shared";
};

std::vector<std::string> names_of(const Manifest& manifest) {
    std::vector<std::string> names;
    for (const Parameter& parameter : manifest.parameters)
        names.push_back(parameter.name);
    return names;
}

TEST_F(IncludedSets, ComeAfterTheTechniquesOwnWhichMayChangeTheirDefaults) {
    const Manifest manifest = parse_including(including(R"(["steps.json"])", R"([
        {"name": "search", "default": "binary", "published": "binary", "help": "Found how."},
        {"name": "own", "type": "boolean", "default": true, "help": "Mine."},
        {"name": "halvings", "default": 5}])"));
    EXPECT_THAT(names_of(manifest), ElementsAre("search", "own", "halvings", "count"));
    const Parameter& search = *manifest.find_parameter("search");
    EXPECT_EQ(search.default_value, ParameterValue(std::string("binary")));
    EXPECT_EQ(search.published, ParameterValue(std::string("binary")));
    EXPECT_EQ(search.help, "Found how.");
    EXPECT_THAT(search.choices, ElementsAre("none", "binary"));
    const Parameter& halvings = *manifest.find_parameter("halvings");
    EXPECT_EQ(halvings.default_value, ParameterValue(std::int64_t{5}));
    EXPECT_EQ(halvings.published, ParameterValue(std::int64_t{6})) << "what is not changed is the set's";
    EXPECT_EQ(halvings.maximum, 24);
    EXPECT_EQ(manifest.find_parameter("count")->default_value, ParameterValue(std::int64_t{15}));
    ASSERT_EQ(manifest.maps.size(), 1U);
    EXPECT_EQ(manifest.maps[0].only_with.size(), 2U);
    EXPECT_TRUE(manifest.passes.at(0).is_shared);
}

// A technique goes on from what the passes of its sets leave, and they may write what it declares.
TEST_F(IncludedSets, PassesOfSetsRunFirstAndWriteMapsOfEither) {
    write_text_file(shared_ / "search.json", R"({"parameters": [],
        "maps": [{"name": "found", "format": "r16"}],
        "passes": [{"name": "search", "shader": "search.glsl", "writes": "found"},
                   {"name": "other_search", "shader": "other.glsl", "writes": "mine"}]})");
    Json json = including(R"(["search.json"])", "[]");
    json["maps"] = parse_json(R"([{"name": "mine", "format": "r16"}])", "test");
    json["passes"] = parse_json(R"([{"name": "smooth", "shader": "smooth.glsl", "writes": "found"}])", "test");
    const Manifest manifest = parse_including(json);
    const auto names = [](const auto& declarations) {
        std::vector<std::string> found;
        for (const auto& declaration : declarations)
            found.push_back(declaration.name);
        return found;
    };
    EXPECT_THAT(names(manifest.maps), ElementsAre("found", "mine"));
    EXPECT_THAT(names(manifest.passes), ElementsAre("search", "other_search", "smooth"));
    EXPECT_TRUE(manifest.passes[1].is_shared);
    EXPECT_FALSE(manifest.passes[2].is_shared);
    json["maps"].push_back(parse_json(R"({"name": "idle", "format": "r16"})", "test"));
    EXPECT_THAT(error_message([&] { parse_including(json); }), HasSubstr("technique.json: $: no pass writes the map"));
    json["maps"] = Json::array();
    EXPECT_THAT(error_message([&] { parse_including(json); }),
                HasSubstr("search.json: $.passes[1].writes: no map 'mine' is declared"));
}

TEST_F(IncludedSets, NeedTheirShadersAmongTheSharedOnes) {
    write("technique.json", including(R"(["steps.json"])", "[]").dump());
    EXPECT_THAT(error_message([&] { load_manifest(folder_, shared_); }),
                AllOf(HasSubstr("the pass 'copy'"), HasSubstr("'copy.glsl'")));
    write_text_file(shared_ / "copy.glsl", "");
    EXPECT_EQ(load_manifest(folder_, shared_).parameters.size(), 3U);
}

TEST_F(IncludedSets, WhatIsWrongIsNamedWithItsPlace) {
    EXPECT_THAT(message_including(R"(["stepps.json"])", "[]"), HasSubstr("$.include[0]: expected a .json file"));
    EXPECT_THAT(message_including(R"(["../shared/steps.json"])", "[]"), HasSubstr("$.include[0]: expected a .json"));
    EXPECT_THAT(message_including(R"(["steps.json", "steps.json"])", "[]"), HasSubstr("$.include[1]: 'steps.json'"));
    EXPECT_THAT(message_including(R"(["steps.json"])", R"([{"name": "count", "default": 65}])"),
                HasSubstr("technique.json: $.parameters[0].default: count cannot be 65"));
    EXPECT_THAT(message_including(R"(["steps.json"])", R"([{"name": "count", "range": [1, 2]}])"),
                HasSubstr("$.parameters[0]: count cannot be 15: it is an integer from 1 to 2"));
    EXPECT_THAT(message_including(R"(["steps.json"])", R"([{"name": "count", "range": [1, 65]}])"),
                HasSubstr("$.parameters[0].range: expected a range within that of steps.json, 1 to 64"));
    EXPECT_THAT(message_including(R"(["steps.json"])", R"([{"name": "search", "choices": ["none"]}])"),
                HasSubstr("unknown key \"choices\""));
    EXPECT_THAT(message_including(R"(["steps.json"])", R"([{"name": "count", "type": "real", "default": 1}])"),
                HasSubstr("'count' is a parameter of steps.json"));
    EXPECT_THAT(message_including(R"(["steps.json"])", R"([{"name": "count"}, {"name": "count"}])"),
                HasSubstr("$.parameters[1]"));
    write_set("typo.json", R"([{"name": "x", "type": "boolean", "default": 1, "help": "X."}])");
    EXPECT_THAT(message_including(R"(["typo.json"])", "[]"), HasSubstr("typo.json: $.parameters[0].default"));
    write_set("again.json", R"([{"name": "count", "type": "boolean", "default": true, "help": "X."}])");
    EXPECT_THAT(message_including(R"(["steps.json", "again.json"])", "[]"), HasSubstr("'count' is given twice"));
    write_text_file(shared_ / "key.json", R"({"parameters": [], "promises": []})");
    EXPECT_THAT(message_including(R"(["key.json"])", "[]"), HasSubstr("key.json: $: unknown key \"promises\""));
}

TEST_F(IncludedSets, ConditionsNameParametersBeforeThem) {
    const auto write_condition = [&](const std::string& condition) {
        write_set("c.json", R"([{"name": "a", "type": "boolean", "default": true, "help": "A."},
            {"name": "b", "type": "boolean", "default": true, "help": "B.", "only_with": )" +
                                condition + R"(}, {"name": "c", "type": "boolean", "default": true, "help": "C."}])");
    };
    const auto message = [&](const std::string& condition) {
        write_condition(condition);
        return message_including(R"(["c.json"])", "[]");
    };
    write_condition(R"({"a": false})");
    EXPECT_NO_THROW(parse_including(including(R"(["c.json"])", "[]")));
    EXPECT_THAT(message(R"({"c": true})"),
                HasSubstr("$.parameters[1].only_with.c: no parameter 'c' is declared before"));
    EXPECT_THAT(message(R"({"a": 3})"), HasSubstr("$.parameters[1].only_with.a: a cannot be 3"));
    EXPECT_THAT(message(R"({"a": []})"), HasSubstr("expected at least one value"));
    EXPECT_THAT(message("{}"), HasSubstr("expected at least one parameter"));
}

TEST_F(IncludedSets, QuadJsonBelongsToEveryQuad) {
    write_set("quad.json", R"([{"name": "fade", "type": "boolean", "default": false, "help": "Fade."}])");
    EXPECT_THAT(names_of(parse_including(including("[]", "[]"))), ElementsAre("fade"));
    EXPECT_THAT(message_including(R"(["quad.json"])", "[]"), HasSubstr("'quad.json' is included already"));
    Json patches =
        including("[]", R"([{"name": "n", "type": "integer", "default": 1, "range": [1, 2], "help": "N."}])");
    patches["shape"] = parse_json(R"({"patches": {"parameter": "n"}})", "test");
    EXPECT_THAT(names_of(parse_including(patches)), ElementsAre("n"));
}

TEST_F(IncludedSets, IdleParametersKeepTheirDefaults) {
    const Manifest manifest = parse_including(including(R"(["steps.json"])", "[]"));
    ParameterValues values = manifest.defaults();
    values["halvings"] = std::int64_t{3};
    reset_idle(manifest, values, true);
    EXPECT_EQ(values.at("halvings"), ParameterValue(std::int64_t{6}));
    values["search"] = std::string("binary");
    values["halvings"] = std::int64_t{3};
    reset_idle(manifest, values, true);
    EXPECT_EQ(values.at("halvings"), ParameterValue(std::int64_t{3}));
}

}  // namespace
}  // namespace reliefbench
