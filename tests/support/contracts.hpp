// Death tests of contracts (numbers/assert.hpp); skipped in builds that do not check them.
#pragma once
#include <gtest/gtest.h>

#include "numbers/assert.hpp"

namespace tamis::test {

class Contracts : public testing::Test {
 protected:
  void SetUp() override {
#ifndef TAMIS_CHECK_CONTRACTS
    GTEST_SKIP() << "built without TAMIS_CHECK_CONTRACTS";
#endif
    GTEST_FLAG_SET(death_test_style, "threadsafe");
  }
};

}  // namespace tamis::test
