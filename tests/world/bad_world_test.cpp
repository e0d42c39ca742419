// What a world refuses, and with which sentence.
#include <gtest/gtest.h>

#include "world/random_world.hpp"

namespace tamis::test {
namespace {}
}  // namespace tamis::test
