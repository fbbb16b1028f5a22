#include "manifest/parameter.hpp"

#include "core/error.hpp"
#include "manifest/parameter_json.hpp"

#include <gmock/gmock.h>

namespace reliefbench {
namespace {

using testing::HasSubstr;

Parameter integer_parameter() {
    return {"steps", ParameterType::integer, std::int64_t{8}, 1, 64, {}, "Steps.", {}, {}};
}

Parameter real_parameter() {
    return {"bias", ParameterType::real, 0.0, -0.5, 0.5, {}, "Bias.", {}, {}};
}

Parameter choice_parameter() {
    return {"leaf", ParameterType::choice, std::string("linear"), 0, 0, {"linear", "exact"}, "Leaf.", {}, {}};
}

TEST(Parameter, ValuesAreWrittenAsShortAsTheyReadBack) {
    EXPECT_EQ(to_string(ParameterValue(std::int64_t{64})), "64");
    EXPECT_EQ(to_string(ParameterValue(0.1)), "0.1");
    EXPECT_EQ(to_string(ParameterValue(2.0)), "2");
    EXPECT_EQ(to_string(ParameterValue(1.0 / 3)), "0.3333333333333333");
    EXPECT_EQ(to_string(ParameterValue(true)), "true");
    EXPECT_EQ(to_string(ParameterValue(std::string("exact"))), "exact");
}

TEST(Parameter, TextIsReadAsTheParametersType) {
    EXPECT_EQ(parse_parameter_value(integer_parameter(), "64"), ParameterValue(std::int64_t{64}));
    EXPECT_EQ(parse_parameter_value(real_parameter(), "1"), ParameterValue(1.0));
    EXPECT_EQ(parse_parameter_value(choice_parameter(), "exact"), ParameterValue(std::string("exact")));
    const Parameter boolean{"on", ParameterType::boolean, false, 0, 0, {}, "On.", {}, {}};
    EXPECT_EQ(parse_parameter_value(boolean, "true"), ParameterValue(true));
    EXPECT_EQ(parse_parameter_value(boolean, "false"), ParameterValue(false));
    for (const char* text : {"", "8.5", "8 ", "eight", "99999999999999999999"}) {
        EXPECT_THROW(parse_parameter_value(integer_parameter(), text), Error) << text;
    }
    for (const char* text : {"", "nan", "inf", "0.1x"}) {
        EXPECT_THROW(parse_parameter_value(real_parameter(), text), Error) << text;
    }
    EXPECT_THROW(parse_parameter_value(boolean, "1"), Error);
}

TEST(Parameter, RangesIncludeBothEnds) {
    EXPECT_EQ(check_parameter_value(integer_parameter(), std::int64_t{1}), "");
    EXPECT_EQ(check_parameter_value(integer_parameter(), std::int64_t{64}), "");
    EXPECT_EQ(check_parameter_value(integer_parameter(), std::int64_t{65}),
              "steps cannot be 65: it is an integer from 1 to 64");
    EXPECT_EQ(check_parameter_value(integer_parameter(), std::int64_t{0}),
              "steps cannot be 0: it is an integer from 1 to 64");
    EXPECT_EQ(check_parameter_value(real_parameter(), -0.5), "");
    EXPECT_EQ(check_parameter_value(real_parameter(), 0.51), "bias cannot be 0.51: it is a number from -0.5 to 0.5");
}

TEST(Parameter, AnotherTypeIsRefused) {
    EXPECT_NE(check_parameter_value(integer_parameter(), true), "");
    EXPECT_NE(check_parameter_value(integer_parameter(), 8.0), "");
    EXPECT_NE(check_parameter_value(real_parameter(), std::string("0")), "");
    EXPECT_NE(check_parameter_value(choice_parameter(), std::int64_t{0}), "");
}

TEST(Parameter, AnUnknownChoiceSuggestsTheNearest) {
    EXPECT_THAT(check_parameter_value(choice_parameter(), std::string("exat")),
                HasSubstr("one of linear, exact (did you mean 'exact'?)"));
}

TEST(Parameter, JsonNumbersTakeTheParametersType) {
    EXPECT_EQ(parameter_value_from_json(real_parameter(), Json(0)), ParameterValue(0.0));
    EXPECT_EQ(parameter_value_from_json(integer_parameter(), Json(16.0)), ParameterValue(std::int64_t{16}));
    EXPECT_EQ(parameter_value_from_json(integer_parameter(), Json(16.5)), ParameterValue(16.5));
    EXPECT_EQ(parameter_value_from_json(integer_parameter(), Json::array()), std::nullopt);
    // 2⁶⁴ − 1 must not turn into −1.
    const Json beyond = std::numeric_limits<std::uint64_t>::max();
    EXPECT_NE(check_parameter_value(integer_parameter(), *parameter_value_from_json(integer_parameter(), beyond)), "");
}

}  // namespace
}  // namespace reliefbench
