#include "organ/file.h"

extern "C" {
#include <libavutil/base64.h>
}

#include <algorithm>
#include <cctype>
#include <fstream>

#include "lapfx/authoring/file_guard.h"
#include "lapfx/authoring/utf8.h"
#include "organ/raw.h"

namespace lapfx::organ {

namespace fs = std::filesystem;

namespace {

std::string kind_of(fs::file_type type) {
    switch (type) {
        case fs::file_type::directory:
            return "is a folder";
        case fs::file_type::fifo:
            return "is a pipe";
        case fs::file_type::socket:
            return "is a socket";
        case fs::file_type::block:
        case fs::file_type::character:
            return "is a device";
        default:
            return "is not a plain file";
    }
}

constexpr std::uint32_t not_a_character = 0xfffd;

/// The text may have either byte order; half a pair becomes U+FFFD.
std::string utf8_of_utf16(std::string_view bytes, bool big_endian) {
    std::string out;
    const auto unit = [&](std::size_t at) -> std::uint32_t {
        const auto a = static_cast<std::uint8_t>(bytes[at]), b = static_cast<std::uint8_t>(bytes[at + 1]);
        return big_endian ? std::uint32_t{a} << 8 | b : std::uint32_t{b} << 8 | a;
    };
    const auto is_half = [](std::uint32_t c, std::uint32_t first) { return c >= first && c < first + 0x400; };
    for (std::size_t at = 0; at + 1 < bytes.size(); at += 2) {
        std::uint32_t c = unit(at);
        if (is_half(c, 0xd800) && at + 3 < bytes.size() && is_half(unit(at + 2), 0xdc00)) {
            at += 2;
            c = 0x10000 + ((c - 0xd800) << 10) + (unit(at) - 0xdc00);
        }
        append_utf8(out, is_half(c, 0xd800) || is_half(c, 0xdc00) ? not_a_character : c);
    }
    return out;
}

int digit(char c, int base) {
    int value = -1;
    if (c >= '0' && c <= '9') value = c - '0';
    if (c >= 'a' && c <= 'f') value = c - 'a' + 10;
    if (c >= 'A' && c <= 'F') value = c - 'A' + 10;
    return value < base ? value : -1;
}

}  // namespace

Bytes read_file(const fs::path& path, const std::string& name, const std::string& place) {
    std::error_code code;
    const fs::file_status status = fs::status(path, code);
    // Checked before opening, because opening a pipe would wait for its writer.
    if (!fs::exists(status))
        refuse(name, place, code && status.type() == fs::file_type::none ? code.message() : "no such file");
    if (!fs::is_regular_file(status)) refuse(name, place, kind_of(status.type()) + ", expected a plain file");
    const std::uintmax_t size = fs::file_size(path, code);
    if (code) refuse(name, place, code.message());
    if (size == 0) refuse(name, place, "is empty");
    if (size > maximum_file_size)
        refuse(name, place, "has " + std::to_string(size) + " bytes, more than the limit of 2 GiB");

    note_read(path);
    Bytes bytes(size);
    std::ifstream in(path, std::ios::binary);
    if (!in) refuse(name, place, "cannot be opened for reading");
    in.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size));
    if (static_cast<std::uintmax_t>(in.gcount()) != size) refuse(name, place, "cannot be read to its end");
    return bytes;
}

std::string_view text_of(const Bytes& bytes, std::string& storage) {
    std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    if (text.starts_with("\xef\xbb\xbf")) return text.substr(3);
    const bool big_endian = text.starts_with("\xfe\xff");
    if (!big_endian && !text.starts_with("\xff\xfe")) return text;
    return storage = utf8_of_utf16(text.substr(2), big_endian);
}

std::string percent_decoded(std::string_view uri) {
    std::string out;
    for (std::size_t i = 0; i < uri.size(); ++i) {
        const bool escape =
            uri[i] == '%' && i + 2 < uri.size() && digit(uri[i + 1], 16) >= 0 && digit(uri[i + 2], 16) >= 0;
        if (!escape) {
            out += uri[i];
            continue;
        }
        out += static_cast<char>(digit(uri[i + 1], 16) * 16 + digit(uri[i + 2], 16));
        i += 2;
    }
    return out;
}

bool decode_base64(std::string_view text, Bytes& out) {
    while (!text.empty() && text.back() == '=') text.remove_suffix(1);
    const bool goes_on = text.find_first_of(std::string_view("=\0", 2)) != std::string_view::npos;
    std::string letters(text);
    std::replace(letters.begin(), letters.end(), '-', '+');
    std::replace(letters.begin(), letters.end(), '_', '/');
    out.resize(letters.size() / 4 * 3 + 3);
    const int size = goes_on ? -1 : av_base64_decode(out.data(), letters.c_str(), static_cast<int>(out.size()));
    out.resize(static_cast<std::size_t>(std::max(size, 0)));
    return size >= 0;
}

}  // namespace lapfx::organ
