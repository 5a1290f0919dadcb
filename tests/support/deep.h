// `tests/run --deep` (LAPFX_DEEP=1): every file and frame of the third-party test data, where the normal run takes a
// sample.
#pragma once

#include <cstdlib>

namespace lapfx::test {

inline bool is_deep() {
    const char* value = std::getenv("LAPFX_DEEP");
    return value != nullptr && *value != '\0';
}

/// How many files or frames one is looked at of: `normally`, or all of them, which is one of `deeply`.
inline int one_in(int normally, int deeply = 1) {
    return is_deep() ? deeply : normally;
}

}  // namespace lapfx::test
