#include "organ/off.h"

#include <algorithm>
#include <cctype>
#include <cstring>

#include "lapfx/authoring/letters.h"
#include "organ/openmesh_reader.h"

namespace lapfx::organ {

namespace {

/// "nan" and "inf" stop a number reader, and the rest would be read as something else. Instead they become a large
/// number, whose triangles mend() leaves out.
void replace_words_for_not_finite(std::string& text) {
    const auto letter = [&](std::size_t i) {
        return i < text.size() && std::isalpha(static_cast<unsigned char>(text[i]));
    };
    for (std::size_t i = 0; i + 2 < text.size(); ++i) {
        if (letter(i - 1)) continue;
        const auto is = [&](const char* word) {
            const std::size_t length = std::strlen(word);
            if (i + length > text.size() || letter(i + length)) return false;
            return std::equal(word, word + length, text.begin() + static_cast<std::ptrdiff_t>(i),
                              [](char a, char b) { return a == lower(b); });
        };
        for (const char* word : {"nan", "inf", "infinity"})
            if (is(word)) text.replace(i, std::strlen(word), "1e30");
    }
}

}  // namespace

RawOrgan read_off(const std::string& file, const Bytes& bytes) {
    std::string storage, text(text_of(bytes, storage));
    if (text.find('\0') != std::string::npos) refuse(file, "", "is not a text OFF");
    replace_words_for_not_finite(text);
    text += '\n';
    Soup soup;
    if (!read_off_with_openmesh(text, soup)) refuse(file, "", "truncated or malformed OFF");
    RawOrgan organ;
    add_parts(soup, {}, organ);
    return organ;
}

}  // namespace lapfx::organ
