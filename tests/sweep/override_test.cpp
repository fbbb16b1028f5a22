#include "sweep/override.hpp"

#include "support/error_message.hpp"

#include <gmock/gmock.h>

namespace reliefbench {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::string message_of(const std::string& argument) {
    return error_message([&] { parse_override(argument); });
}

TEST(Override, ListsValues) {
    const Override given = parse_override("view_angle=0,60.5,80");
    EXPECT_EQ(given.name, "view_angle");
    EXPECT_EQ(given.argument, "-a view_angle=0,60.5,80");
    EXPECT_THAT(given.values, ElementsAre(Json(0), Json(60.5), Json(80)));
    EXPECT_THAT(parse_override("adaptive=true,false").values, ElementsAre(Json(true), Json(false)));
    EXPECT_THAT(parse_override("heightmap=a=b.png").values, ElementsAre(Json("a=b.png")));
}

TEST(Override, RangesIncludeTheirStopWhenMet) {
    EXPECT_THAT(parse_override("view_angle=[0:80:20]").values,
                ElementsAre(Json(0), Json(20), Json(40), Json(60), Json(80)));
    EXPECT_THAT(parse_override("view_angle=[0:79:40]").values, ElementsAre(Json(0), Json(40)));
    EXPECT_THAT(parse_override("view_angle=[60:0:-30]").values, ElementsAre(Json(60), Json(30), Json(0)));
    EXPECT_THAT(parse_override("view_angle=5,[10:20:10]").values, ElementsAre(Json(5), Json(10), Json(20)));
    EXPECT_TRUE(parse_override("factor=[1:3:1]").values[0].is_number_integer());
}

TEST(Override, RangesOfFractionsHaveNoRoundingNoise) {
    // In doubles 0.1 + 2·0.1 is 0.30000000000000004, and (0.3 − 0.1)/0.1 is below 2.
    EXPECT_THAT(parse_override("height_scale=[0.1:0.3:0.1]").values, ElementsAre(Json(0.1), Json(0.2), Json(0.3)));
}

TEST(Override, RangesOfNumbersThatNeitherIntegersNorDoublesHoldWell) {
    EXPECT_TRUE(parse_override("a=[9223372036854775807:9223372036854775807:1]").values[0].is_number_float());
    EXPECT_EQ(parse_override("a=[1e-310:1e-310:1e-310]").values[0].get<double>(), 1e-310);
}

TEST(Override, AnObjectIsOneValue) {
    EXPECT_THAT(parse_override(R"(heightmap={"file": "a.png", "invert": true})").values,
                ElementsAre(parse_json(R"({"file": "a.png", "invert": true})", "test")));
}

TEST(Override, ValuesWithCommasAndBracketsAreJson) {
    EXPECT_THAT(parse_override(R"(heightmap=["a b,c.png","d"])").values, ElementsAre(Json("a b,c.png"), Json("d")));
    EXPECT_THAT(parse_override(R"(heightmap="a,b.png",rock)").values, ElementsAre(Json("a,b.png"), Json("rock")));
    EXPECT_THAT(parse_override(R"(heightmap=["sp ace/a b,c=d|é\"<i>.png"])").values,
                ElementsAre(Json("sp ace/a b,c=d|é\"<i>.png")));
    EXPECT_THAT(
        parse_override(R"(heightmap=["[1].png", {"file": "a,b.png", "height_range": [0, 2]}],rock)").values,
        ElementsAre(Json("[1].png"), Json::parse(R"({"file": "a,b.png", "height_range": [0, 2]})"), Json("rock")));
    EXPECT_THAT(parse_override("view_angle=[0,30.5,60]").values, ElementsAre(Json(0), Json(30.5), Json(60)));
    EXPECT_THAT(parse_override("view_angle=[0, 30],45,[50:60:10]").values,
                ElementsAre(Json(0), Json(30), Json(45), Json(50), Json(60)));
}

TEST(Override, BracketsInsideAWordKeepItsCommas) {
    EXPECT_THAT(parse_override("heightmap=a[1,2].png,b],c").values,
                ElementsAre(Json("a[1,2].png"), Json("b]"), Json("c")));
}

TEST(Override, NamesOfTechniquesAndFilesAreNoNumbers) {
    EXPECT_THAT(parse_override("heightmap=256,true").values, ElementsAre(Json("256"), Json("true")));
    EXPECT_THAT(parse_override("technique=1e3").values, ElementsAre(Json("1e3")));
    EXPECT_THAT(parse_override("view_angle=1e1").values, ElementsAre(Json(10.0)));
}

TEST(Override, ThatCannotBeReadIsAnError) {
    EXPECT_THAT(message_of("heightmap=[\"a\",b]"), HasSubstr("-a heightmap=[\"a\",b]:1:6"));
    EXPECT_THAT(message_of("heightmap=[a,b]"), HasSubstr("strings with commas or brackets of their own as JSON"));
    EXPECT_THAT(message_of("heightmap=[\"a\"]b"), HasSubstr("expected a comma behind [\"a\"], found 'b'"));
    EXPECT_THAT(message_of("heightmap=\"a"), HasSubstr("lacks its closing quote"));
    EXPECT_THAT(message_of("heightmap=[\"a]\""), HasSubstr("lacks its closing bracket"));
    EXPECT_THAT(message_of("view_angle"),
                HasSubstr("-a view_angle: expected name=value,value or name=[start:stop:step]"));
    EXPECT_THAT(message_of("=3"), HasSubstr("expected name=value"));
    EXPECT_THAT(message_of("view_angle="), HasSubstr("expected name=value"));
    EXPECT_THAT(message_of("view_angle=0,,60"), HasSubstr("a value is missing between commas"));
    EXPECT_THAT(message_of("view_angle=[0:80"), HasSubstr("lacks its closing bracket"));
    EXPECT_THAT(message_of("view_angle=[0:80]"), HasSubstr("does not have three numbers; write [start:stop:step]"));
    EXPECT_THAT(message_of("view_angle=[]"), HasSubstr("the list is empty"));
    EXPECT_THAT(message_of("view_angle=[0:x:20]"), HasSubstr("has 'x' for a number"));
    EXPECT_THAT(message_of("view_angle=[0:80:0]"), HasSubstr("has a step of zero"));
    EXPECT_THAT(message_of("view_angle=[0:80:-5]"), HasSubstr("steps away from its stop"));
    EXPECT_THAT(message_of("view_angle=[0:80:1e-9]"), HasSubstr("has more than 100000 values"));
    EXPECT_THAT(message_of("view_angle=[0:nan:1]"), HasSubstr("has 'nan' for a number"));
    EXPECT_THAT(message_of("heightmap={\"file\""), HasSubstr("-a heightmap="));
}

}  // namespace
}  // namespace reliefbench
