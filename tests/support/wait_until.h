// Waits for what another thread or process does. How long that takes is the machine's affair and is not looked at: the
// limit only ends a test that would wait for ever.
//
//     ASSERT_TRUE(wait_until([&] { return ready; }));
//     ASSERT_TRUE(wait_until([&] { return editor().preview.ready(); }, [&] { ui().frame(); }));
#pragma once

#include <chrono>
#include <thread>

namespace lapfx::test {

inline constexpr std::chrono::seconds waits_at_most{240};

/// Whether `so` became true. `turn` is called each time before it is asked again.
template <class So, class Turn>
bool wait_until(const So& so, const Turn& turn) {
    const auto end = std::chrono::steady_clock::now() + waits_at_most;
    while (!so()) {
        if (std::chrono::steady_clock::now() >= end) return false;
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
        turn();
    }
    return true;
}
template <class So>
bool wait_until(const So& so) {
    return wait_until(so, [] {});
}

}  // namespace lapfx::test
