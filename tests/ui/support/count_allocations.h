// Counts what goes through operator new in this program, on all threads.
#pragma once

#include <cstddef>

namespace lapfx::test {

/// Since the program started. Two readings that are equal: nothing was allocated between them.
std::size_t allocations_so_far();
/// The same in bytes that were asked for.
std::size_t allocated_bytes_so_far();

}  // namespace lapfx::test
