// A detector that lets other Python threads run while it works, and stops when Python wants it to.
#pragma once
#include <filesystem>
#include <memory>
#include <vector>

#include "python/src/arrays.hpp"
#include "python/src/asker.hpp"
#include "python/src/contact_array.hpp"
#include "tamis/detector.hpp"

namespace tamis::python {

/// One question at a time: a second one is refused, from another thread or from the filter.
class Questions {
 public:
  Questions(const Mesh& mesh, const Asking& asking);

  nb::object contacts(const Rows& start, const Rows& end, const QueryOptions& q);
  nb::tuple earliest(const Rows& start, const Rows& end, const QueryOptions& q);
  bool is_free(const Rows& start, const Rows& end, const QueryOptions& q);
  nb::object contacts_on_path(const Path& path, double tolerance, const QueryOptions& q);
  nb::tuple earliest_on_path(const Path& path, double tolerance, const QueryOptions& q);
  bool is_free_on_path(const Path& path, double tolerance, const QueryOptions& q);

  nb::tuple safe_step(const Rows& start, const Rows& end, double keep, const QueryOptions& q);
  nb::tuple truncate(const Rows& start, const Rows& end, double keep, const QueryOptions& q, bool as_float32);

  nb::object pairs_within(const Rows& at, double distance);
  nb::object intersections(const Rows& at);
  bool has_intersection(const Rows& at);

  nb::dict statistics();

  /// As looking.hpp has it.
  void write_step(const std::filesystem::path& path, const ContactBytes& contacts, const Rows& start, const Rows& end,
                  const QueryOptions& q);
  void write_path(const std::filesystem::path& to, const ContactBytes& contacts, const Path& path, double tolerance,
                  const QueryOptions& q);

  int traverse(visitproc visit, void* arg) const { return asker_.traverse(visit, arg); }
  void clear() { asker_.clear(); }

 private:
  Asker asker_;
  Detector detector_;
  std::shared_ptr<SpareContacts> spare_ = std::make_shared<SpareContacts>();
};

}  // namespace tamis::python
