// Contacts as a table.
#pragma once
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "tamis/contact.hpp"

namespace tamis::io {

/// kind is vf, ee, ve or vv, status certified or unresolved, n the normal.
inline constexpr std::string_view kContactColumns = "kind,v0,v1,v2,v3,toi_lower,toi_upper,u,v,status,nx,ny,nz";
/// The cells of one row; numbers read back to the same doubles.
std::string contact_cells(const Contact& contact);

/// Columns kContactColumns; rows in the order of `contacts`. Atomically. Throws FileError.
void write_contacts_csv(const std::filesystem::path& path, std::span<const Contact> contacts);

}  // namespace tamis::io
