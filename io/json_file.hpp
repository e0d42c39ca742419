// A JSON file, by hand or by program: what is wrong in it is said with its place.
#pragma once
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tamis/mesh.hpp"
#include "tamis/step.hpp"

namespace tamis::io {

/// Without the order of its keys (io/output/json.hpp), so that many of them cost no more than their number times its
/// logarithm.
using KeyedJson = nlohmann::json;

/// A value and where it stands, as "bodies[2].pose". Valid as long as the JsonFile. What is asked of it throws
/// FileError where the value is something else.
class JsonValue {
 public:
  JsonValue(const KeyedJson& json, const std::string& file, std::string place)
      : json_(&json), file_(&file), place_(std::move(place)) {}

  bool is_text() const { return json_->is_string(); }
  bool has(const char* key) const { return find(key).has_value(); }
  std::optional<JsonValue> find(const std::string& key) const;
  JsonValue member(const std::string& key) const;
  /// Of an object, in the order of their names.
  std::vector<std::string> keys() const;
  /// Of an array. `what` it should be, in words: "a list of bodies".
  std::vector<JsonValue> items(const char* what) const;

  std::string text() const;
  Index index() const;
  Point point() const;
  /// So many numbers; `what` they are, in words: "x, y and z".
  std::vector<double> numbers(std::size_t count, const char* what) const;

  /// Refuses every other key: one that is spelled wrongly would change the answer without a word.
  void allow_only(std::initializer_list<std::string_view> keys) const;
  [[noreturn]] void fail(std::string_view what) const;

 private:
  std::string place_of(const std::string& key) const { return place_.empty() ? key : place_ + "." + key; }

  const KeyedJson* json_;
  const std::string* file_;
  std::string place_;
};

class JsonFile {
 public:
  /// `name`: for messages. Throws FileError: no JSON, a key twice in one object, arrays and objects nested deeper than
  /// 64 levels.
  JsonFile(std::string_view bytes, std::string name);
  JsonFile(const JsonFile&) = delete;
  JsonFile& operator=(const JsonFile&) = delete;

  JsonValue root() const { return {root_, name_, ""}; }

 private:
  std::string name_;
  KeyedJson root_;
};

}  // namespace tamis::io
