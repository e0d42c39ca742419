// The layout of a record, from which Python makes the structured dtype of its table.
#pragma once
#include <nanobind/nanobind.h>

namespace tamis::python {

/// What numpy.dtype() understands: names, formats, offsets, itemsize.
class Layout {
 public:
  explicit Layout(std::size_t record_size) { layout_["itemsize"] = record_size; }
  /// `format` in NumPy's words: "u1", "f8", "(4,)i4".
  Layout& field(const char* name, const char* format, std::size_t offset) {
    names_.append(name);
    formats_.append(format);
    offsets_.append(offset);
    return *this;
  }
  nanobind::dict dict() {
    layout_["names"] = names_;
    layout_["formats"] = formats_;
    layout_["offsets"] = offsets_;
    return layout_;
  }

 private:
  nanobind::list names_, formats_, offsets_;
  nanobind::dict layout_;
};

}  // namespace tamis::python
