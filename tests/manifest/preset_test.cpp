#include "complete_manifest.hpp"

#include <gmock/gmock.h>

namespace reliefbench {
namespace {

using testing::HasSubstr;

Json with_presets(const std::string& presets) {
    Json json = complete();
    json["presets"] = Json::parse(presets);
    return json;
}

TEST(Presets, AreReadWithTheirSource) {
    const Manifest manifest = parse(with_presets(
        R"([{"name": "engine_4", "title": "Engine 4", "source": "engine/engine, parallax.glsl at 1234567",
             "parameters": {"max_steps": 16, "bias": 0.5}, "not_expressed": "Its fade."}])"));
    ASSERT_EQ(manifest.presets.size(), 1U);
    const Preset* const preset = find_preset(manifest, "engine_4");
    ASSERT_NE(preset, nullptr);
    EXPECT_EQ(preset->title, "Engine 4");
    EXPECT_EQ(preset->source, "engine/engine, parallax.glsl at 1234567");
    EXPECT_EQ(preset->not_expressed, "Its fade.");
    EXPECT_EQ(values_of_preset(manifest, preset).at("max_steps"), ParameterValue(std::int64_t{16}));
    EXPECT_EQ(values_of_preset(manifest, preset).at("min_steps"), manifest.defaults().at("min_steps"));
    EXPECT_EQ(find_preset(manifest, "engine_5"), nullptr);
    EXPECT_EQ(values_of_preset(manifest, nullptr), manifest.defaults());
}

TEST(Presets, ThatAreWrongAreErrorsThatNameTheirPlace) {
    const auto complaint = [](const std::string& members) {
        return message_of(with_presets(R"([{"title": "E", "source": "s", )" + members + "}]"));
    };
    EXPECT_THAT(complaint(R"("name": "Engine", "parameters": {})"), HasSubstr("technique.json: $.presets[0].name"));
    EXPECT_THAT(complaint(R"("name": "e", "parameters": {"max_step": 3})"),
                HasSubstr("$.presets[0].parameters.max_step: no parameter 'max_step' (did you mean 'max_steps'?)"));
    EXPECT_THAT(complaint(R"("name": "e", "parameters": {"max_steps": 3000})"),
                HasSubstr("$.presets[0].parameters.max_steps"));
    EXPECT_THAT(complaint(R"("name": "e", "parameters": {}, "licence": "x")"), HasSubstr("licence"));
    EXPECT_THAT(complaint(R"("name": "e", "parameters": {"lod_fade_end": 2})"),
                HasSubstr("'lod_fade_end' has no effect in this preset: it needs lod_fade=mip or distance"));
    EXPECT_THAT(message_of(with_presets(R"([{"name": "e", "title": "E", "source": "s", "parameters": {}},
                                            {"name": "e", "title": "F", "source": "s", "parameters": {}}])")),
                HasSubstr("$.presets[1].name: the preset 'e' is given twice"));
}

}  // namespace
}  // namespace reliefbench
