#include "ui/value/id.h"

#define XXH_INLINE_ALL
#include <xxhash.h>

namespace lapfx::ui {

std::uint64_t hash_bytes(std::uint64_t seed, std::string_view bytes) {
    const std::uint64_t hash = XXH3_64bits_withSeed(bytes.data(), bytes.size(), seed);
    return hash == 0 ? 1 : hash;
}

Label split_label(std::string_view text) {
    std::size_t mark = 0;  // labels are short: a loop beats the call of a search
    while (mark + 1 < text.size() && !(text[mark] == '#' && text[mark + 1] == '#')) ++mark;
    if (mark + 1 >= text.size()) return {text, text, text};
    const std::string_view shown = text.substr(0, mark);
    const bool replaced = text.substr(mark).starts_with("###");
    const std::string_view hidden = text.substr(mark + (replaced ? 3 : 2));
    return {shown, replaced ? hidden : text, shown.empty() ? hidden : shown};
}

}  // namespace lapfx::ui
