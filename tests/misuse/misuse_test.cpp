// Every argument and every option of the public functions, as their headers declare them, is refused by a sentence of
// Tamis where it is wrong. Bugs: a list of pairs whose step had a negative number of rows read beyond the end; options
// that nobody looks at.
#include <gtest/gtest.h>

#include "misuse/wrong_values.hpp"
#include "tamis/error.hpp"

namespace tamis::test {
namespace {

/// The same options with one of them wrong.
template <class Struct, class Field>
void add_field(std::vector<Wrong<Struct>>& found, const std::string& name, Field Struct::*field) {
  for (auto& [what, value] : wrong_values(Type<Field>())) {
    Struct options;
    options.*field = value;
    found.push_back({name + " " + what, options});
  }
}

void expect_refused(const std::string& what, const std::function<void()>& call) {
  try {
    call();
    ADD_FAILURE() << what << " was taken";
  } catch (const Error& error) {
    const std::string says = error.what();
    EXPECT_NE(says.find(": "), std::string::npos) << what << ": " << says;
  } catch (const std::exception& error) {
    ADD_FAILURE() << what << ": no sentence of Tamis, but " << error.what();
  }
}

/// `call(wrong, right)` for each wrong value of a type.
template <class T, class Call>
void try_all(const std::string& what, const Call& call) {
  for (auto& [name, value] : wrong_values(Type<T>())) {
    Right right;
    expect_refused(what + " " + name, [&, &wrong = value] { call(wrong, right); });
  }
}

}  // namespace

#include "misuse/calls.inc"

}  // namespace tamis::test
