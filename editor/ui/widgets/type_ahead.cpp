#include "ui/widgets/type_ahead.h"

#include <algorithm>

#include "ui/value/letters.h"
#include "ui/value/utf8.h"

namespace lapfx::ui {

bool begins_with(std::string_view text, std::string_view start) {
    return same_letters(text.substr(0, start.size()), start);
}

void TypeAhead::add(char32_t letter, double now) {
    if (!open(now)) typed_.clear();
    at_ = now;
    if (typed_.size() < longest) append(typed_, letter);
}

std::size_t TypeAhead::repeated() const {
    const std::size_t letter = decode(typed_).bytes;
    for (std::size_t at = letter; at < typed_.size(); at += letter)
        if (typed_.compare(at, letter, typed_, 0, letter) != 0) return 0;
    return letter;
}

}  // namespace lapfx::ui
