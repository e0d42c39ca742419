// A JSON file, written by hand or by a program; messages name the place of an error.
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

/// Sorts its keys instead of keeping their order (tools/files/output/json.hpp): n keys cost n log n.
using KeyedJson = nlohmann::json;

/// A value and its place in the file, as "bodies[2].pose". Valid as long as the JsonFile. All functions but is_text,
/// has and find throw FileError if the value is of another type.
class JsonValue {
 public:
  JsonValue(const KeyedJson& json, const std::string& file, std::string place)
      : json_(&json), file_(&file), place_(std::move(place)) {}

  bool is_text() const { return json_->is_string(); }
  bool has(const char* key) const { return find(key).has_value(); }
  std::optional<JsonValue> find(const std::string& key) const;
  JsonValue member(const std::string& key) const;
  /// The keys of an object, sorted.
  std::vector<std::string> keys() const;
  /// The elements of an array. `what`: what the array should be, for messages: "a list of bodies".
  std::vector<JsonValue> items(const char* what) const;

  std::string text() const;
  Index index() const;
  Point point() const;
  /// An array of `count` numbers. `what`: what they mean, for messages: "x, y and z".
  std::vector<double> numbers(std::size_t count, const char* what) const;

  /// Refuses every other key: a misspelled key would otherwise change the answer silently.
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
  /// `name`: for messages. Throws FileError if the text is not JSON, has a key twice in one object, or nests arrays and
  /// objects deeper than 64 levels.
  JsonFile(std::string_view bytes, std::string name);
  JsonFile(const JsonFile&) = delete;
  JsonFile& operator=(const JsonFile&) = delete;

  JsonValue root() const { return {root_, name_, ""}; }

 private:
  std::string name_;
  KeyedJson root_;
};

}  // namespace tamis::io
