#include "files/bodies/bodies_csv.hpp"

#include "files/output/contacts_csv.hpp"
#include "files/output/csv.hpp"
#include "numbers/floating_point_state.hpp"

namespace tamis::io {

BodiesCsv::BodiesCsv(const std::filesystem::path& path)
    : table_(path, fmt::format("step,body_a,body_b,{}", kContactColumns)) {}

void BodiesCsv::add(std::size_t step, std::span<const BodyContact> contacts, std::span<const std::string> names) {
  const auto name = [&](BodyId body) { return csv_cell(names[static_cast<std::size_t>(body)]); };
  for (const BodyContact& c : contacts)
    table_.row("{},{},{},{}\n", step, name(c.bodies[0]), name(c.bodies[1]), contact_cells(c));
}

void write_body_contacts_csv(const std::filesystem::path& path, std::span<const BodyContact> contacts) {
  const ComputingState state;
  CsvTable table(path, fmt::format("b0,b1,{}", kContactColumns));
  for (const BodyContact& c : contacts) table.row("{},{},{}\n", c.bodies[0], c.bodies[1], contact_cells(c));
  table.commit();
}

}  // namespace tamis::io
