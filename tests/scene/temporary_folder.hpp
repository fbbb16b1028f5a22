#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace reliefbench {

/// A test with a folder of its own, deleted afterwards.
class TemporaryFolder : public testing::Test {
protected:
    void SetUp() override {
        const testing::TestInfo* test = testing::UnitTest::GetInstance()->current_test_info();
        folder_ = std::filesystem::path(testing::TempDir()) /
                  ("reliefbench_" + std::string(test->test_suite_name()) + "_" + test->name());
        std::filesystem::remove_all(folder_);
        std::filesystem::create_directories(folder_);
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    std::filesystem::path file(const std::string& name) const { return folder_ / name; }

private:
    std::filesystem::path folder_;
};

/// The message of the exception of type `Exception` that `body` throws; a failure and "" when it throws none.
template <typename Exception, typename Body>
std::string message_of(const Body& body) {
    try {
        body();
    } catch (const Exception& error) {
        return error.what();
    }
    ADD_FAILURE() << "nothing was thrown";
    return {};
}

}  // namespace reliefbench
