#include "ui/support/count_decoded.h"

#include <dlfcn.h>
#include <utf8proc.h>

#include <atomic>

namespace {

std::atomic<std::size_t> decoded{0};

}  // namespace

namespace lapfx::test {

std::size_t decoded_so_far() {
    return decoded.load(std::memory_order_relaxed);
}

}  // namespace lapfx::test

/// In place of the library's, which it calls: ui::decode() goes through here.
extern "C" utf8proc_ssize_t utf8proc_iterate(const utf8proc_uint8_t* text, utf8proc_ssize_t size,
                                             utf8proc_int32_t* codepoint) {
    static const auto iterate = reinterpret_cast<decltype(&utf8proc_iterate)>(::dlsym(RTLD_NEXT, "utf8proc_iterate"));
    decoded.fetch_add(1, std::memory_order_relaxed);
    return iterate(text, size, codepoint);
}
