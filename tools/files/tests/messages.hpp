// What a call throws.
#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "files/error.hpp"

namespace tamis::test {

/// The message of the FileError that `call` throws, after the rules of every message: one line that starts with the
/// file's name and ends in advice. Empty, and a failure of the test, if nothing is thrown.
template <class Call>
std::string file_error(const std::string& file, const Call& call) {
  try {
    call();
  } catch (const io::FileError& error) {
    const std::string message = error.what();
    EXPECT_TRUE(message.starts_with(file + ": ")) << message;
    EXPECT_EQ(std::count(message.begin(), message.end(), '\n'), 0) << message;
    EXPECT_NE(message.rfind(": "), file.size()) << "no advice: " << message;
    return message;
  }
  ADD_FAILURE() << file << ": nothing was thrown";
  return {};
}

inline bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace tamis::test
