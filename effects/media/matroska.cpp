#include "media/matroska.h"

#include <bit>
#include <optional>

namespace lapfx::media {

namespace {

constexpr std::int64_t ebml_header = 0x1a45dfa3, segment = 0x18538067, void_element = 0xec;
constexpr std::int64_t unknown = -1;

/// A number of one to eight bytes; the zero bits before the first one say how many follow. With `whole` that first bit
/// stays in it, as in the names of elements; without, a number of ones alone is `unknown`.
std::optional<std::int64_t> take_number(std::span<const std::uint8_t>& from, bool whole) {
    if (from.empty() || from[0] == 0) return std::nullopt;
    const auto length = static_cast<std::size_t>(std::countl_zero(from[0])) + 1;
    if (from.size() < length) return std::nullopt;
    const std::uint64_t first = whole ? from[0] : from[0] & (0xffu >> length);
    std::uint64_t value = first, ones = 0xffu >> length;
    for (std::size_t i = 1; i < length; ++i) {
        value = value << 8 | from[i];
        ones = ones << 8 | 0xffu;
    }
    from = from.subspan(length);
    return !whole && value == ones ? unknown : static_cast<std::int64_t>(value);
}

}  // namespace

std::int64_t matroska_size(std::span<const std::uint8_t> head) {
    const auto* const begin = head.data();
    for (bool first = true;; first = false) {
        const auto name = take_number(head, true), size = take_number(head, false);
        if (!name || !size || *size == unknown || first != (*name == ebml_header)) return 0;
        if (*name == segment) return (head.data() - begin) + *size;
        if ((!first && *name != void_element) || static_cast<std::uint64_t>(*size) > head.size()) return 0;
        head = head.subspan(static_cast<std::size_t>(*size));
    }
}

}  // namespace lapfx::media
