// Contacts as a table.
#pragma once
#include <filesystem>
#include <span>

#include "tamis/contact.hpp"

namespace tamis::io {

/// Columns kind,v0,v1,v2,v3,toi_lower,toi_upper,u,v,status,nx,ny,nz; kind is vf, ee, ve or vv, status certified or
/// unresolved, n the normal. Rows in the order of `contacts`; numbers read back to the same doubles. Atomically. Throws
/// FileError.
void write_contacts_csv(const std::filesystem::path& path, std::span<const Contact> contacts);

}  // namespace tamis::io
