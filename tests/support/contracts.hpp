// Death tests of contracts (numbers/assert.hpp); skipped in builds that do not check them.
#pragma once
#include <gtest/gtest.h>

#include "numbers/assert.hpp"

namespace tamis::test {

class Contracts : public testing::Test {
 protected:
  void SetUp() override {
#if !defined(TAMIS_CHECK_CONTRACTS) || !GTEST_HAS_DEATH_TEST
    GTEST_SKIP() << "built without TAMIS_CHECK_CONTRACTS, or for a system without processes";
#else
    GTEST_FLAG_SET(death_test_style, "threadsafe");
#endif
  }
};

#ifndef EXPECT_DEATH
#define EXPECT_DEATH EXPECT_DEATH_IF_SUPPORTED
#endif

}  // namespace tamis::test
