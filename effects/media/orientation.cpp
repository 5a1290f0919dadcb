#include "media/orientation.h"

#include <algorithm>
#include <string_view>

namespace lapfx::media {

namespace {

constexpr int upright = 1;
constexpr int most_chunks = 100'000;  // a broken file may have any number
constexpr std::size_t header = 8;     // bytes of a chunk before its data, and of a TIFF before its tags

bool has(const std::vector<std::uint8_t>& bytes, std::size_t at, std::string_view text) {
    return bytes.size() >= at + text.size() &&
           std::equal(text.begin(), text.end(), bytes.begin() + static_cast<std::ptrdiff_t>(at),
                      [](char a, std::uint8_t b) { return static_cast<std::uint8_t>(a) == b; });
}

/// `count` bytes of a number, the caller has checked that they are there.
std::int64_t number(const std::vector<std::uint8_t>& bytes, std::size_t at, std::size_t count, bool big_endian) {
    std::int64_t value = 0;
    for (std::size_t i = 0; i < count; ++i) value = value << 8 | bytes[at + (big_endian ? i : count - 1 - i)];
    return value;
}

/// Of the first directory of a TIFF that begins at `start` of the file.
int of_tiff(const ReadAt& file, std::int64_t start) {
    constexpr std::size_t tag_bytes = 12, most_tags = 4096;
    constexpr std::int64_t tag = 0x0112, of_short = 3;
    const std::vector<std::uint8_t> head = file(start, header);
    const bool big = has(head, 0, "MM");
    if (head.size() < header || (!big && !has(head, 0, "II")) || number(head, 2, 2, big) != 42) return upright;
    const std::int64_t first = start + number(head, 4, 4, big);
    const std::vector<std::uint8_t> count = file(first, 2);
    if (count.size() < 2) return upright;
    const std::size_t tags = std::min(static_cast<std::size_t>(number(count, 0, 2, big)), most_tags);
    const std::vector<std::uint8_t> all = file(first + 2, tags * tag_bytes);
    for (std::size_t at = 0; at + tag_bytes <= all.size(); at += tag_bytes) {
        if (number(all, at, 2, big) != tag || number(all, at + 2, 2, big) != of_short) continue;
        const auto found = static_cast<int>(number(all, at + 8, 2, big));
        return found >= 1 && found <= 8 ? found : upright;
    }
    return upright;
}

/// Where the data of the first chunk of this name begin: of a PNG, whose chunks have their size before their name, or
/// of a WebP, where it follows; -1: there is none.
std::int64_t find_chunk(const ReadAt& file, std::string_view name, bool png) {
    constexpr std::int64_t checksum = 4;
    std::int64_t at = png ? 8 : 12;
    for (int i = 0; i < most_chunks; ++i) {
        const std::vector<std::uint8_t> head = file(at, header);
        if (head.size() < header) break;
        if (has(head, png ? 4 : 0, name)) return at + static_cast<std::int64_t>(header);
        const std::int64_t size = number(head, png ? 0 : 4, 4, png);
        at += static_cast<std::int64_t>(header) + size + (png ? checksum : size % 2);
    }
    return -1;
}

}  // namespace

int exif_orientation(const ReadAt& file) {
    constexpr std::string_view exif("Exif\0\0", 6);  // as in a JPEG: some programs write it in other files, too
    const std::vector<std::uint8_t> head = file(0, 12);
    if (has(head, 0, "II") || has(head, 0, "MM")) return of_tiff(file, 0);
    const bool png = has(head, 0, "\x89PNG"), webp = has(head, 0, "RIFF") && has(head, 8, "WEBP");
    if (!png && !webp) return upright;
    const std::int64_t data = find_chunk(file, png ? "eXIf" : "EXIF", png);
    if (data < 0) return upright;
    return of_tiff(file, data + (has(file(data, exif.size()), 0, exif) ? static_cast<std::int64_t>(exif.size()) : 0));
}

}  // namespace lapfx::media
