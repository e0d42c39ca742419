#include "files/output/contacts_csv.hpp"

#include "files/output/csv_table.hpp"
#include "numbers/floating_point_state.hpp"

namespace tamis::io {

std::string contact_cells(const Contact& c) {
  return fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{}", name_of(c.kind), c.vertices[0], c.vertices[1],
                     c.vertices[2], c.vertices[3], c.toi_lower, c.toi_upper, c.u, c.v,
                     c.certainty == Certainty::certified ? "certified" : "unresolved", c.normal[0], c.normal[1],
                     c.normal[2]);
}

void write_contacts_csv(const std::filesystem::path& path, std::span<const Contact> contacts) {
  const ComputingState state;
  CsvTable table(path, kContactColumns);
  for (const Contact& c : contacts) table.row("{}\n", contact_cells(c));
  table.commit();
}

}  // namespace tamis::io
