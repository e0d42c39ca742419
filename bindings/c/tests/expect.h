/* The smallest test tools: a condition that fails is named, and the program's exit code says so. */
#ifndef TAMIS_TESTS_C_EXPECT_H
#define TAMIS_TESTS_C_EXPECT_H
#include <stdio.h>
#include <string.h>

static int expect_failures = 0;

#define EXPECT(condition)                                                     \
  do {                                                                        \
    if (!(condition)) {                                                       \
      fprintf(stderr, "%s:%d: not so: %s\n", __FILE__, __LINE__, #condition); \
      ++expect_failures;                                                      \
    }                                                                         \
  } while (0)

#define EXPECT_SAYS(message, part)                                                                  \
  do {                                                                                              \
    const char* expect_message = (message);                                                         \
    if (!strstr(expect_message, part)) {                                                            \
      fprintf(stderr, "%s:%d: '%s' does not say '%s'\n", __FILE__, __LINE__, expect_message, part); \
      ++expect_failures;                                                                            \
    }                                                                                               \
  } while (0)

#endif
