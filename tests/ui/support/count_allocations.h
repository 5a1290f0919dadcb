// Counts the allocations with operator new by the thread that asks: others, such as decoders, allocate at any time.
#pragma once

#include <cstddef>

namespace lapfx::test {

/// The number since the thread started. If two readings are equal, nothing was allocated between them.
std::size_t allocations_so_far();
/// The same in bytes that were asked for.
std::size_t allocated_bytes_so_far();

}  // namespace lapfx::test
