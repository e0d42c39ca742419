// Tests and users ask for instruction sets by name: every one that is built has a name.
#include <gtest/gtest.h>

#include <sstream>
#include <string>

#include "support/kernels_here.hpp"

namespace tamis {
namespace {

// Bug: an instruction set without a name, which every test would skip as if the machine lacked it.
TEST(InstructionSets, ThatAreBuiltHaveNames) {
  std::istringstream built(TAMIS_ISAS);
  for (std::string name; std::getline(built, name, ',');) EXPECT_NO_THROW((void)isa_from_name(name));
}

// Bugs: kernels under another one's name; a new set that `best` does not know.
TEST(InstructionSets, AreThoseAskedForAndBestIsTheWidest) {
  Isa widest = Isa::best;
  for (const Isa isa : test::every_isa())
    if (const Kernels* here = test::kernels_here(isa)) {
      EXPECT_EQ(here->isa, isa);
      widest = isa;
    }
  EXPECT_EQ(kernels(Isa::best).isa, widest);
}

}  // namespace
}  // namespace tamis
