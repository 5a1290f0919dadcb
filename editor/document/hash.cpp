#include "document/hash.h"

#define XXH_INLINE_ALL
#include <xxhash.h>

namespace lapfx::document {

std::uint64_t hash_of(std::string_view bytes) {
    return XXH3_64bits(bytes.data(), bytes.size());
}

std::string hex_of(std::uint64_t hash) {
    std::string text;
    for (int shift = 60; shift >= 0; shift -= 4)
        text += "0123456789abcdef"[(hash >> static_cast<unsigned>(shift)) & 15U];
    return text;
}

}  // namespace lapfx::document
