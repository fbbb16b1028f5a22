#include "core/attempt.hpp"

#include "core/error.hpp"

#include <gtest/gtest.h>

#include <new>
#include <stdexcept>

namespace reliefbench {
namespace {

TEST(Attempt, WhatGoesWellHasNoReason) {
    bool done = false;
    EXPECT_EQ(failure_of([&] { done = true; }), "");
    EXPECT_TRUE(done);
    EXPECT_TRUE(fits_in_memory([] {}));
}

TEST(Attempt, AnErrorsMessageIsTheReason) {
    EXPECT_EQ(failure_of([] { fail("the disk is full"); }), "the disk is full");
    EXPECT_THROW(fits_in_memory([] { fail("the disk is full"); }), Error) << "only memory is its matter";
}

TEST(Attempt, AnAllocationThatFailsIsAReason) {
    EXPECT_EQ(failure_of([] { throw std::bad_alloc(); }), memory_used_up);
    EXPECT_FALSE(fits_in_memory([] { throw std::bad_alloc(); }));
}

TEST(Attempt, ABugIsNone) {
    EXPECT_THROW(failure_of([] { throw std::logic_error("a bug"); }), std::logic_error);
}

}  // namespace
}  // namespace reliefbench
