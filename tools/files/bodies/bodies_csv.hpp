// Contacts of bodies as a table, step by step.
#pragma once
#include <filesystem>
#include <span>
#include <string>

#include "files/output/csv_table.hpp"
#include "tamis/world.hpp"

namespace tamis::io {

/// Columns step,body_a,body_b, then those of write_contacts_csv. Atomically. All throw FileError.
class BodiesCsv {
 public:
  explicit BodiesCsv(const std::filesystem::path& path);

  /// `step`: counted from 1. `names`: of the bodies, by their numbers.
  void add(std::size_t step, std::span<const BodyContact> contacts, std::span<const std::string> names);
  /// The whole table stands, or none of it.
  void commit() { table_.commit(); }

 private:
  CsvTable table_;
};

/// The contacts of one step: columns b0,b1 (the bodies' numbers), then those of write_contacts_csv. Atomically. Throws
/// FileError.
void write_body_contacts_csv(const std::filesystem::path& path, std::span<const BodyContact> contacts);

}  // namespace tamis::io
