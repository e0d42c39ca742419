#include "files/json_file.hpp"

#include <algorithm>
#include <limits>
#include <set>

#include "files/error.hpp"

namespace tamis::io {
namespace {

constexpr std::size_t kDeepest = 64;

/// Reads the text before the parser and refuses two things that the parser accepts silently: a key twice in one object
/// (the last value would win), and nesting of any depth. (A callback of the parser takes time that grows with the
/// square of the number of objects.)
class Strict final : public nlohmann::json_sax<KeyedJson> {
 public:
  explicit Strict(const std::string& name) : name_(name) {}

  bool null() override { return true; }
  bool boolean(bool) override { return true; }
  bool number_integer(number_integer_t) override { return true; }
  bool number_unsigned(number_unsigned_t) override { return true; }
  bool number_float(number_float_t, const string_t&) override { return true; }
  bool string(string_t&) override { return true; }
  bool binary(binary_t&) override { return true; }
  bool start_object(std::size_t) override { return enter(); }
  bool end_object() override { return leave(); }
  bool start_array(std::size_t) override { return enter(); }
  bool end_array() override { return leave(); }
  bool key(string_t& key) override {
    if (!keys_.back().insert(key).second)
      throw FileError(name_, "", fmt::format("the key {} stands twice in one object: remove one", in_quotes(key)));
    return true;
  }
  /// Silent: the parser meets the same error and throws it.
  bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception&) override { return false; }

 private:
  bool enter() {
    if (keys_.size() == kDeepest)
      throw FileError(name_, "", fmt::format("nests deeper than {} levels: write it flatter", kDeepest));
    keys_.emplace_back();
    return true;
  }
  bool leave() {
    keys_.pop_back();
    return true;
  }

  const std::string& name_;
  std::vector<std::set<std::string>> keys_;  ///< of each object or array that is open
};

/// The line that holds the byte, counted from 1.
std::string line_of(std::string_view bytes, std::size_t byte) {
  const std::string_view before = bytes.substr(0, std::min(byte, bytes.size()));
  return fmt::format("line {}", 1 + std::count(before.begin(), before.end(), '\n'));
}

}  // namespace

JsonFile::JsonFile(std::string_view bytes, std::string name) : name_(std::move(name)) {
  try {
    Strict strict(name_);
    KeyedJson::sax_parse(bytes, &strict);
    root_ = KeyedJson::parse(bytes);
  } catch (const KeyedJson::parse_error& error) {
    throw FileError(name_, line_of(bytes, error.byte), "is not JSON from here on: correct it");
  } catch (const KeyedJson::out_of_range&) {
    throw FileError(name_, "", "holds a number beyond all doubles: correct it");
  }
}

std::optional<JsonValue> JsonValue::find(const std::string& key) const {
  if (!json_->is_object() || !json_->contains(key)) return std::nullopt;
  return JsonValue((*json_)[key], *file_, place_of(key));
}

JsonValue JsonValue::member(const std::string& key) const {
  if (const auto found = find(key)) return *found;
  throw FileError(*file_, place_of(key), "is missing: add it");
}

std::vector<std::string> JsonValue::keys() const {
  if (!json_->is_object()) fail("is not an object: write {...}");
  std::vector<std::string> keys;
  for (const auto& [key, value] : json_->items()) keys.push_back(key);
  return keys;
}

std::vector<JsonValue> JsonValue::items(const char* what) const {
  if (!json_->is_array()) fail(fmt::format("is not an array: give {}", what));
  std::vector<JsonValue> items;
  for (const KeyedJson& item : *json_) items.emplace_back(item, *file_, fmt::format("{}[{}]", place_, items.size()));
  return items;
}

std::string JsonValue::text() const {
  if (!json_->is_string()) fail("is not text: write it in quotes");
  return json_->get<std::string>();
}

Index JsonValue::index() const {
  if (!json_->is_number_unsigned() ||
      json_->get<std::uint64_t>() > static_cast<std::uint64_t>(std::numeric_limits<Index>::max()))
    fail("is not an index of a vertex: give a whole number, the first vertex being 0");
  return json_->get<Index>();
}

std::vector<double> JsonValue::numbers(std::size_t count, const char* what) const {
  if (!json_->is_array() || json_->size() != count)
    fail(fmt::format("is not an array of {} numbers: give {}", count == 3 ? "three" : std::to_string(count), what));
  std::vector<double> numbers;
  for (const KeyedJson& number : *json_) {
    if (!number.is_number()) fail(fmt::format("holds something that is not a number: give {}", what));
    numbers.push_back(number.get<double>());
  }
  return numbers;
}

Point JsonValue::point() const {
  const std::vector<double> numbers = this->numbers(3, "x, y and z");
  return {numbers[0], numbers[1], numbers[2]};
}

void JsonValue::allow_only(std::initializer_list<std::string_view> allowed) const {
  for (const std::string& key : keys())
    if (std::find(allowed.begin(), allowed.end(), key) == allowed.end())
      fail(fmt::format("there is no key {}: the keys are {}", in_quotes(key), fmt::join(allowed, ", ")));
}

void JsonValue::fail(std::string_view what) const { throw FileError(*file_, place_, what); }

}  // namespace tamis::io
