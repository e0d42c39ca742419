// A world says what a detector says of all its bodies as one mesh.
#pragma once
#include "worlds/random_world.hpp"

namespace tamis::test {

/// All contacts, in the same order; how many.
std::size_t expect_same_contacts(TestWorld& world, const PathOptions& options = {});
/// `earliest` and `is_free`, by all contacts.
void expect_same_first(TestWorld& world, const PathOptions& options = {});

}  // namespace tamis::test
