// Finding by a few letters: "fs" and "save" both find "File: Save".
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace lapfx::ui {

/// Only so many bytes of a longer text are searched.
inline constexpr std::size_t fuzzy_text_bytes = 128;

struct FuzzyMatch {
    float score = 0;                                            ///< larger is better; only for comparing
    std::array<std::uint64_t, fuzzy_text_bytes / 64> places{};  ///< bits: the bytes of the text that were matched

    bool at(std::size_t byte) const { return byte < fuzzy_text_bytes && ((places[byte / 64] >> (byte % 64)) & 1) != 0; }
};

/// Words of `pattern` (parted by spaces) are each found in `text`, their letters in order but with gaps. Beginnings of
/// words and letters side by side count most, short texts more than long ones. Upper and lower case are one (ASCII).
/// Nothing: no match. An empty pattern matches everything alike.
std::optional<FuzzyMatch> fuzzy_match(std::string_view pattern, std::string_view text);

}  // namespace lapfx::ui
