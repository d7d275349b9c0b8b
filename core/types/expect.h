#pragma once

#include <cstdio>
#include <cstdlib>

/// For bugs of our own only: logs the broken promise and aborts. Bad data from outside never reaches it;
/// that is a Result (at a door) or a Rejected message (from the sea).
#define LL_EXPECT(condition)                                                               \
  do {                                                                                     \
    if (!(condition)) {                                                                    \
      std::fprintf(stderr, "%s:%d: broken promise: %s\n", __FILE__, __LINE__, #condition); \
      std::abort();                                                                        \
    }                                                                                      \
  } while (false)
