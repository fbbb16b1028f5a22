#include "manifest/search_advice.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace reliefbench {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

Parameter integer(const std::string& name, int maximum) {
    Parameter parameter;
    parameter.name = name;
    parameter.default_value = std::int64_t{1};
    parameter.minimum = 1;
    parameter.maximum = maximum;
    return parameter;
}

/// A search that `most` caps, and beside it `least` where the boolean `adaptive` is set; `finest` has nothing to do
/// with it.
Manifest manifest() {
    Manifest manifest;
    Parameter adaptive;
    adaptive.name = "adaptive";
    adaptive.type = ParameterType::boolean;
    adaptive.default_value = false;
    Parameter least = integer("least", 64);
    least.only_with = {{"adaptive", {true}}};
    manifest.parameters = {integer("most", 4096), adaptive, least, integer("finest", 14)};
    manifest.search_cap = {"most", "least"};
    return manifest;
}

ParameterValues values(std::int64_t most, std::int64_t least, bool adaptive) {
    return {{"most", most}, {"least", least}, {"adaptive", adaptive}, {"finest", std::int64_t{2}}};
}

TEST(SearchAdvice, NamesTheCapsInEffectWithTheirValuesAndMaxima) {
    EXPECT_EQ(advise_longer_search(manifest(), values(64, 8, false)), "raise most (now 64, at most 4096)");
    EXPECT_EQ(advise_longer_search(manifest(), values(64, 8, true)),
              "raise most (now 64, at most 4096) or least (now 8, at most 64)");
    EXPECT_EQ(advise_longer_search(manifest(), values(4096, 8, true)), "raise least (now 8, at most 64)");
}

TEST(SearchAdvice, RaisesNothingThatIsAtItsMaximum) {
    const std::string one = advise_longer_search(manifest(), values(4096, 64, false));
    EXPECT_THAT(one, AllOf(StartsWith("most = 4096, which caps it, is at its maximum"), Not(HasSubstr("raise"))));
    EXPECT_THAT(advise_longer_search(manifest(), values(4096, 64, true)),
                AllOf(StartsWith("most = 4096 with least = 64, which caps it"), Not(HasSubstr("raise"))));
}

// A manifest of 0.1.0 names none: its number of samples, or else what there is.
TEST(SearchAdvice, WithoutANamedCapSaysWhatItCannotKnow) {
    Manifest old = manifest();
    old.search_cap.clear();
    EXPECT_THAT(advise_longer_search(old, values(64, 8, false)),
                AllOf(HasSubstr("names no parameter as its \"search_cap\""), HasSubstr("most (now 64, at most 4096)"),
                      HasSubstr("finest (now 2, at most 14)"), Not(HasSubstr("least"))));
    old.sample_count = "most";
    EXPECT_EQ(advise_longer_search(old, values(64, 8, false)), "raise most (now 64, at most 4096)");
    old.sample_count.reset();
    old.parameters.clear();
    EXPECT_THAT(advise_longer_search(old, {}), HasSubstr("the cap stands in its shaders"));
}

TEST(SearchAdvice, ForLoopsThatTheDeviceEndsItIsTheOtherWayRound) {
    EXPECT_EQ(advise_shorter_search(manifest(), values(4096, 8, false)),
              "give each loop an end of its own that is sooner, or lower most (now 4096) if it is what caps them");
    Manifest capless = manifest();
    capless.search_cap.clear();
    EXPECT_EQ(advise_shorter_search(capless, values(4096, 8, false)),
              "give each loop an end of its own that is sooner");
}

}  // namespace
}  // namespace reliefbench
