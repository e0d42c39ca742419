#include "io/output/contacts_csv.hpp"

#include "io/output/csv_table.hpp"

namespace tamis::io {

void write_contacts_csv(const std::filesystem::path& path, std::span<const Contact> contacts) {
  CsvTable table(path, "kind,v0,v1,v2,v3,toi_lower,toi_upper,u,v,status,nx,ny,nz");
  for (const Contact& c : contacts)
    table.row("{},{},{},{},{},{},{},{},{},{},{},{},{}\n", name_of(c.kind), c.vertices[0], c.vertices[1], c.vertices[2],
              c.vertices[3], c.toi_lower, c.toi_upper, c.u, c.v,
              c.certainty == Certainty::certified ? "certified" : "unresolved", c.normal[0], c.normal[1], c.normal[2]);
  table.commit();
}

}  // namespace tamis::io
