#include "ui/core/id.h"

#include <cstring>

namespace lapfx::ui {

namespace {

constexpr std::uint64_t odd = 0x9e3779b97f4a7c15ULL;  // 2^64 over the golden ratio

std::uint64_t mixed(std::uint64_t a) {
    a ^= a >> 32;
    a *= 0xd6e8feb86659fd93ULL;
    a ^= a >> 32;
    return a;
}

}  // namespace

std::uint64_t hash_bytes(std::uint64_t seed, std::string_view bytes) {
    std::uint64_t hash = seed * odd + bytes.size();
    const char* at = bytes.data();
    std::size_t left = bytes.size();
    for (; left >= 8; at += 8, left -= 8) {
        std::uint64_t word;
        std::memcpy(&word, at, 8);
        hash = mixed(hash ^ word) * odd;
    }
    std::uint64_t tail = 0;
    if (left > 0) std::memcpy(&tail, at, left);
    hash = mixed(hash ^ tail);
    return hash == 0 ? 1 : hash;
}

Label split_label(std::string_view text) {
    const std::size_t mark = text.find("##");
    if (mark == std::string_view::npos) return {text, text, text};
    const std::string_view shown = text.substr(0, mark);
    const bool replaced = text.substr(mark).starts_with("###");
    const std::string_view hidden = text.substr(mark + (replaced ? 3 : 2));
    return {shown, replaced ? hidden : text, shown.empty() ? hidden : shown};
}

}  // namespace lapfx::ui
