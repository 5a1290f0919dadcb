// The size of an image from its header alone: a file of a few bytes can claim a gigapixel, so it is looked at first.
// OpenCV, which decodes, does not give the size beforehand; stb_image does not know WebP, nor every JPEG that OpenCV
// decodes.
#include "media/image.h"

#include <string_view>

namespace lapfx::media {

namespace {

using File = std::span<const std::uint8_t>;

bool starts(File file, std::size_t at, std::string_view text) {
    if (file.size() < at + text.size()) return false;
    return std::equal(text.begin(), text.end(), file.begin() + static_cast<std::ptrdiff_t>(at),
                      [](char a, std::uint8_t b) { return static_cast<std::uint8_t>(a) == b; });
}

/// `count` bytes at `at`, least significant first; the caller has checked the length.
std::int64_t little(File file, std::size_t at, int count) {
    std::int64_t value = 0;
    for (int i = count - 1; i >= 0; --i) value = value << 8 | file[at + static_cast<std::size_t>(i)];
    return value;
}

std::int64_t big(File file, std::size_t at, int count) {
    std::int64_t value = 0;
    for (int i = 0; i < count; ++i) value = value << 8 | file[at + static_cast<std::size_t>(i)];
    return value;
}

/// Walks the JPEG segments to the first "start of frame".
bool jpeg_size(File file, ImageSize& size) {
    std::size_t at = 2;
    while (at + 9 < file.size()) {
        if (file[at] != 0xff) return false;
        const std::uint8_t marker = file[at + 1];
        if (marker == 0xff) {  // fill byte
            ++at;
            continue;
        }
        const bool frame = marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc;
        if (frame) {
            size = {big(file, at + 7, 2), big(file, at + 5, 2)};
            return true;
        }
        const bool bare = marker == 0x01 || (marker >= 0xd0 && marker <= 0xd8);
        at += bare ? 2 : 2 + static_cast<std::size_t>(big(file, at + 2, 2));
    }
    return false;
}

bool webp_size(File file, ImageSize& size) {
    if (file.size() < 30) return false;
    if (starts(file, 12, "VP8X")) {
        size = {little(file, 24, 3) + 1, little(file, 27, 3) + 1};
        return true;
    }
    if (starts(file, 12, "VP8L")) {
        const std::int64_t bits = little(file, 21, 4);
        size = {(bits & 0x3fff) + 1, (bits >> 14 & 0x3fff) + 1};
        return true;
    }
    if (starts(file, 12, "VP8 ")) {
        size = {little(file, 26, 2) & 0x3fff, little(file, 28, 2) & 0x3fff};
        return true;
    }
    return false;
}

}  // namespace

/// Its chunk acTL comes before the first picture.
bool is_animated_png(File file) {
    if (!starts(file, 0, "\x89PNG\r\n\x1a\n")) return false;
    constexpr std::size_t beside_data = 12;  // bytes of a chunk
    for (std::size_t at = 8; at + beside_data <= file.size() && !starts(file, at + 4, "IDAT");) {
        if (starts(file, at + 4, "acTL")) return true;
        at += beside_data + static_cast<std::size_t>(big(file, at, 4));
    }
    return false;
}

bool is_animated_webp(File file) {
    constexpr std::size_t flags = 20;
    constexpr unsigned animation = 2;
    return starts(file, 0, "RIFF") && starts(file, 8, "WEBPVP8X") && file.size() > flags &&
           (file[flags] & animation) != 0;
}

bool image_size(File file, ImageSize& size) {
    if (starts(file, 0, "\x89PNG\r\n\x1a\n") && file.size() >= 33) {
        // Apple's CgBI chunk comes before IHDR.
        const std::size_t at = starts(file, 12, "CgBI") && file.size() >= 40 ? 32 : 16;
        size = {big(file, at, 4), big(file, at + 4, 4)};
        return true;
    }
    if (starts(file, 0, "\xff\xd8\xff")) return jpeg_size(file, size);
    if (starts(file, 0, "RIFF") && starts(file, 8, "WEBP")) return webp_size(file, size);
    if (starts(file, 0, "BM") && file.size() >= 26) {
        const bool old_header = little(file, 14, 4) == 12;
        size.width = old_header ? little(file, 18, 2) : little(file, 18, 4);
        size.height = old_header ? little(file, 20, 2) : little(file, 22, 4);
        // A negative height means that the rows run from the top.
        if (size.height > 0x7fffffff) size.height = (std::int64_t{1} << 32) - size.height;
        return true;
    }
    return false;
}

}  // namespace lapfx::media
