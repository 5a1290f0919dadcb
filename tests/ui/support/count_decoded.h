// Counts the code points that the text code of this program decodes, on all threads: what work on a text costs.
#pragma once

#include <cstddef>

namespace lapfx::test {

/// The number since the program started.
std::size_t decoded_so_far();

}  // namespace lapfx::test
