// Hashes of short texts, for ids and caches.
#pragma once

#include <cstdint>
#include <cstring>
#include <string_view>

namespace lapfx::ui {

/// One step of mixing; different values stay different.
inline std::uint64_t mixed(std::uint64_t value) {
    value *= 0x9e3779b97f4a7c15;  // 2^64 over the golden ratio
    return value ^ (value >> 32);
}

/// Not for keeping: depends on the byte order of the machine.
inline std::uint64_t hash_of(std::string_view text, std::uint64_t seed) {
    const auto word = [](const char* from, auto type) {
        std::memcpy(&type, from, sizeof(type));
        return std::uint64_t{type};
    };
    const char* from = text.data();
    const std::size_t size = text.size();
    std::uint64_t hash = mixed(seed ^ (std::uint64_t{size} << 40));
    for (std::size_t at = 0; at + 8 <= size; at += 8) hash = mixed(hash ^ word(from + at, std::uint64_t{}));
    // What is left is read with overlap rather than byte by byte: the size is part of the hash, so nothing is mistaken.
    if (size >= 8) {
        hash = mixed(hash ^ word(from + size - 8, std::uint64_t{}));
    } else if (size >= 4) {
        hash = mixed(hash ^ (word(from, std::uint32_t{}) | word(from + size - 4, std::uint32_t{}) << 32));
    } else if (size > 0) {
        hash = mixed(hash ^ (word(from, std::uint8_t{}) | word(from + size / 2, std::uint8_t{}) << 8 |
                             word(from + size - 1, std::uint8_t{}) << 16));
    }
    return mixed(hash);
}

}  // namespace lapfx::ui
