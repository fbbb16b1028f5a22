#include "core/json.hpp"

#include "support/error_message.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

using namespace reliefbench;

namespace {

std::string message_of_parsing(const std::string& text) {
    return error_message([&] { parse_json(text, "file.json"); });
}

TEST(Json, MembersKeepTheOrderOfTheFile) {
    EXPECT_EQ(parse_json(R"({"z": 1, "a": {"y": 2, "b": 3}})", "file.json").dump(), R"({"z":1,"a":{"y":2,"b":3}})");
}

TEST(Json, SyntaxErrorsNameFileLineAndColumn) {
    EXPECT_THAT(message_of_parsing("{\n  \"a\": 1,\n  \"b\" 2\n}"), testing::StartsWith("file.json:3:7: syntax error"));
    EXPECT_THAT(message_of_parsing("{\"a\": tru}"), testing::StartsWith("file.json:1:10: "));
    EXPECT_EQ(message_of_parsing(""), "file.json: it is empty; expected JSON");
    EXPECT_EQ(message_of_parsing(" \n"), "file.json: it is empty; expected JSON");
    EXPECT_THAT(message_of_parsing("{\"a\":\n[1, 2"), testing::StartsWith("file.json:2:6: "));
    EXPECT_THAT(message_of_parsing("{} x"), testing::StartsWith("file.json:1:4: "));
}

TEST(Json, NumbersThatNoDoubleHoldsAreRefused) {
    EXPECT_THAT(message_of_parsing("[\n1e999]"), testing::StartsWith("file.json:2:"));
    EXPECT_THAT(message_of_parsing("[NaN]"), testing::StartsWith("file.json:1:2: "));
}

TEST(Json, DuplicateKeysAreRefusedWhereTheSecondStands) {
    EXPECT_EQ(message_of_parsing("{\"a\": 1,\n  \"a\": 2}"), "file.json:2:3: duplicate key \"a\"");
    EXPECT_EQ(message_of_parsing(R"({"x": [{"q\"": 1, "q\"": 2}]})"), R"(file.json:1:19: duplicate key "q\"")");
    EXPECT_NO_THROW(parse_json(R"({"a": 1, "b": {"a": 2}, "c": [{"a": 3}, {"a": 4}]})", "file.json"));
}

TEST(Json, NestingAndObjectsWithoutEndAreRefused) {
    const std::string brackets(100000, '[');
    EXPECT_EQ(message_of_parsing("{\"a\":\n" + brackets), "file.json:2:64: nested more than 64 deep");
    EXPECT_EQ(message_of_parsing(brackets), "file.json:1:65: nested more than 64 deep");
    EXPECT_NO_THROW(parse_json(std::string(64, '[') + std::string(64, ']'), "file.json"));
    std::string members = "{\"0\":0";
    for (int i = 1; i <= 10000; ++i)
        members += fmt::format(",\"{}\":0", i);
    EXPECT_THAT(message_of_parsing(members + "}"), testing::HasSubstr("more than 10000 members"));
}

class JsonViewTest : public testing::Test {
protected:
    const Json json = parse_json(R"({"axes": {"view_angle": [0, 30.5, "x"], "odd key": true}, "count": 12})", "c.json");
    const JsonView view{json, "c.json"};
};

TEST_F(JsonViewTest, ReadsWhatIsThere) {
    EXPECT_EQ(view.at("count").integer(), 12);
    EXPECT_EQ(view.at("count").number(), 12.0);
    EXPECT_EQ(view.at("axes").at("view_angle").items()[1].number(0, 90), 30.5);
    EXPECT_EQ(view.at("axes").at("view_angle").items()[2].string(), "x");
    EXPECT_TRUE(view.at("axes").at("odd key").boolean());
    EXPECT_TRUE(view.has("axes"));
    EXPECT_FALSE(view.has("axis"));
    ASSERT_EQ(view.members().size(), 2u);
    EXPECT_EQ(view.members()[1].first, "count");
}

TEST_F(JsonViewTest, ComplaintsNameFilePathAndExpectation) {
    EXPECT_EQ(error_message([&] { view.at("axes").at("view_angle").items()[2].number(0, 90); }),
              "c.json: $.axes.view_angle[2]: expected a number from 0 to 90, found \"x\"");
    EXPECT_EQ(error_message([&] { view.at("axes").at("odd key").string(); }),
              "c.json: $.axes[\"odd key\"]: expected a string, found true");
    EXPECT_EQ(error_message([&] { view.at("count").integer(1, 8); }),
              "c.json: $.count: expected an integer from 1 to 8, found 12");
    EXPECT_EQ(error_message([&] { view.at("count").number(13); }),
              "c.json: $.count: expected a number of at least 13, found 12");
    EXPECT_EQ(error_message([&] { view.at("axes").at("view_angle").items()[1].integer(); }),
              "c.json: $.axes.view_angle[1]: expected an integer, found 30.5");
    EXPECT_EQ(error_message([&] { view.at("counts"); }), "c.json: $: key \"counts\" is missing");
    EXPECT_EQ(error_message([&] { view.at("count").items(); }), "c.json: $.count: expected an array, found 12");
    EXPECT_EQ(error_message([&] { view.at("count").at("x"); }), "c.json: $.count: expected an object, found 12");
}

TEST_F(JsonViewTest, IntegersOfMoreThan63BitsAreOutOfRange) {
    const Json large = parse_json("18446744073709551615", "c.json");
    EXPECT_EQ(error_message([&] { JsonView(large, "c.json").integer(0); }),
              "c.json: $: expected an integer of at least 0, found 18446744073709551615");
}

TEST_F(JsonViewTest, UnknownKeysBringASuggestion) {
    EXPECT_NO_THROW(view.require_only({"axes", "count"}));
    EXPECT_EQ(error_message([&] {
                  view.require_only({"axis", "counts", "axes"});
              }),
              "c.json: $: unknown key \"count\" (did you mean 'counts'?)");
    EXPECT_EQ(error_message([&] {
                  view.require_only({"axes", "seed"});
              }),
              "c.json: $: unknown key \"count\" (known keys: axes, seed)");
}

TEST_F(JsonViewTest, ChoicesAreListedWhenNoneIsMet) {
    const Json word = "exakt";
    EXPECT_EQ(JsonView(Json("mesh"), "c.json").choice({"exact", "mesh"}), 1u);
    EXPECT_EQ(error_message([&] {
                  JsonView(word, "c.json", "$.kind").choice({"exact", "mesh"});
              }),
              "c.json: $.kind: expected one of exact, mesh, found \"exakt\" (did you mean 'exact'?)");
}

}  // namespace
