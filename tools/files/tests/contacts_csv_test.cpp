#include "files/output/contacts_csv.hpp"

#include <gtest/gtest.h>

#include "support/temporary_folder.hpp"

namespace tamis::io {
namespace {

Contact contact(PairKind kind, Certainty certainty, double toi) {
  return {kind, certainty, {4, 1, 3, 2}, toi, toi + 0x1p-52, 1.0 / 3, 0, {0, 0.1, -1}};
}

// Bug: other columns than documented, numbers rounded to six digits.
TEST(ContactsCsv, NumbersReadBackToTheSameDoubles) {
  const test::TemporaryFolder folder;
  const std::vector<Contact> contacts{contact(PairKind::vertex_face, Certainty::certified, 0.1),
                                      contact(PairKind::edge_edge, Certainty::unresolved, 0)};
  write_contacts_csv(folder.path() / "c.csv", contacts);
  EXPECT_EQ(test::bytes_of_file(folder.path() / "c.csv"),
            "kind,v0,v1,v2,v3,toi_lower,toi_upper,u,v,status,nx,ny,nz\n"
            "vf,4,1,3,2,0.1,0.10000000000000023,0.3333333333333333,0,certified,0,0.1,-1\n"
            "ee,4,1,3,2,0,2.220446049250313e-16,0.3333333333333333,0,unresolved,0,0.1,-1\n");
}

// Bug: rows get lost where one chunk ends and the next begins.
TEST(ContactsCsv, WritesManyRows) {
  const test::TemporaryFolder folder;
  const std::vector<Contact> contacts(5000, contact(PairKind::vertex_face, Certainty::certified, 0.25));
  write_contacts_csv(folder.path() / "c.csv", contacts);
  const std::string text = test::bytes_of_file(folder.path() / "c.csv");
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 5001);
}

}  // namespace
}  // namespace tamis::io
