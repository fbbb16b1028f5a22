#include "store/device_share.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace reliefbench {
namespace {

DeviceShare share_of(const char* run) {
    return device_share(Json::parse(run));
}

TEST(DeviceShare, IsOfAllExecutionsOfTheRun) {
    EXPECT_EQ(share_of(R"({"environment": {"shared_device": false}})"), DeviceShare::never);
    EXPECT_EQ(share_of(R"({"environment": {"shared_device": true}})"), DeviceShare::always);
    EXPECT_EQ(share_of(R"({"environment": {"shared_device": false},
                           "resumed": [{"environment": {"shared_device": true}}]})"),
              DeviceShare::partly);
    EXPECT_EQ(share_of(R"({"environment": {"shared_device": true},
                           "resumed": [{"environment": {"shared_device": false}}]})"),
              DeviceShare::partly);
}

TEST(DeviceShare, RunsOfEarlierVersionsAreUnknown) {
    EXPECT_EQ(share_of(R"({"environment": {"cores": 2}})"), DeviceShare::unknown);
    EXPECT_EQ(share_of(R"({})"), DeviceShare::unknown);
    EXPECT_EQ(share_of(R"({"environment": {}, "resumed": [{"environment": {"shared_device": false}}]})"),
              DeviceShare::unknown);
    EXPECT_EQ(share_of(R"({"environment": {}, "resumed": [{"environment": {"shared_device": true}}]})"),
              DeviceShare::partly);
    EXPECT_EQ(share_of(R"({"environment": 3, "resumed": "x", "merged": {"a": null}})"), DeviceShare::unknown);
}

TEST(DeviceShare, PartsOfAMergedRunCount) {
    EXPECT_EQ(share_of(R"({"environment": {"shared_device": false}, "merged": [
                           {"environment": {"shared_device": false}}, {"environment": {"shared_device": true}}]})"),
              DeviceShare::partly);
    EXPECT_EQ(share_of(R"({"environment": {"shared_device": false}, "merged": [
                           {"environment": {"shared_device": false},
                            "resumed": [{"environment": {"shared_device": true}}]}]})"),
              DeviceShare::partly);
}

TEST(DeviceShare, OnlyWhatWasSharedIsTold) {
    EXPECT_EQ(describe(DeviceShare::never, "the times"), "");
    EXPECT_EQ(describe(DeviceShare::unknown, "the times"), "");
    EXPECT_THAT(describe(DeviceShare::always, "the times"), testing::StartsWith("the times were made with"));
    EXPECT_THAT(describe(DeviceShare::partly, "the times"), testing::StartsWith("the times were partly made with"));
}

}  // namespace
}  // namespace reliefbench
