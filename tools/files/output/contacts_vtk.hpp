// Contacts as points with their data, for ParaView and whatever else reads VTK's XML.
#pragma once
#include <filesystem>
#include <span>

#include "tamis/contact.hpp"
#include "tamis/step.hpp"

namespace tamis::io {

/// Each contact is a point, where its first feature is at `toi_upper`, with the arrays normal, vertices (-1: unused),
/// kind and status (their numbers in the order vf, ee, ve, vv; certified, unresolved), toi_lower, toi_upper, weights
/// (u, v). Numbers read back to the same doubles. `write_contacts_vtp` makes poly data, `write_contacts_vtu` an
/// unstructured grid. Atomically. Throw FileError.
void write_contacts_vtp(const std::filesystem::path& path, std::span<const Contact> contacts,
                        std::span<const Point> start, std::span<const Point> end);
void write_contacts_vtu(const std::filesystem::path& path, std::span<const Contact> contacts,
                        std::span<const Point> start, std::span<const Point> end);

}  // namespace tamis::io
