// How often this program's tests allocate.
#pragma once

#include <cstddef>

namespace lapfx::test {

/// Counted up by every operator new of the calling thread (effects_test.cpp).
extern thread_local std::size_t allocations;

}  // namespace lapfx::test
