// Contacts as a table.
#pragma once
#include <filesystem>
#include <span>

#include "tamis/contact.hpp"

namespace tamis::io {

/// Columns kind,v0,v1,v2,v3,toi_lower,toi_upper,u,v,status; kind is vf or ee, status certified or unresolved. Rows in
/// the order of `contacts`; numbers read back to the same doubles. Atomically. Throws FileError.
void write_contacts_csv(const std::filesystem::path& path, std::span<const Contact> contacts);

}  // namespace tamis::io
