// The layout of a record, from which Python makes the structured dtype of its table.
#pragma once
#include <nanobind/nanobind.h>

#include <array>
#include <cstddef>
#include <string>
#include <type_traits>

namespace tamis::python {

template <class T>
inline constexpr std::size_t kColumns = 0;  ///< numbers in a field that is an array; 0: it is one number
template <class T, std::size_t n>
inline constexpr std::size_t kColumns<std::array<T, n>> = n;

/// In NumPy's words: "u1", "(4,)i4".
template <class T>
std::string format_of() {
  if constexpr (kColumns < T >> 0)
    return std::string("(")
        .append(std::to_string(kColumns<T>))
        .append(",)")
        .append(format_of<typename T::value_type>());
  else if constexpr (std::is_same_v<T, bool>)
    return "?";
  else
    return std::string(std::is_floating_point_v<T> ? "f"
                       : std::is_signed_v<T>       ? "i"
                                                   : "u")
        .append(std::to_string(sizeof(T)));
}

/// What numpy.dtype() understands: names, formats, offsets, itemsize.
template <class Record>
class Layout {
 public:
  /// `Part`: the record, or what it derives from.
  template <class T, class Part>
  Layout& field(const char* name, T Part::*member) {
    static const Record record{};
    const auto* place = reinterpret_cast<const char*>(&(record.*member));
    names_.append(name);
    formats_.append(format_of<T>());
    offsets_.append(place - reinterpret_cast<const char*>(&record));
    return *this;
  }
  nanobind::dict dict() const {
    nanobind::dict layout;
    layout["names"] = names_;
    layout["formats"] = formats_;
    layout["offsets"] = offsets_;
    layout["itemsize"] = sizeof(Record);
    return layout;
  }

 private:
  nanobind::list names_, formats_, offsets_;
};

}  // namespace tamis::python
