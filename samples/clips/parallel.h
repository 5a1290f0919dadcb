// Splits work into slabs, one thread each. Every slab writes only its own samples and reads only data that no slab
// writes, so the result does not depend on the number of threads.
#pragma once

#include <algorithm>
#include <thread>
#include <vector>

namespace clips {

/// How many threads for_slabs uses; set once at the start of the program.
inline int thread_count = 1;

/// Calls body(begin, end) for consecutive slabs that cover [0, count).
template <class Body>
void for_slabs(int count, const Body& body) {
    const int slabs = std::min(thread_count, count);
    if (slabs <= 1) return body(0, count);
    std::vector<std::jthread> threads;
    for (int s = 1; s < slabs; ++s) threads.emplace_back([&, s] { body(count * s / slabs, count * (s + 1) / slabs); });
    body(0, count / slabs);
}

}  // namespace clips
