#include "ui/shell/fuzzy.h"

#include <algorithm>

#include "ui/value/letters.h"

namespace lapfx::ui {

namespace {

constexpr std::size_t most_letters = 32;  // one word of a pattern has no more
constexpr float letter = 1, word_start = 8, side_by_side = 9, gap = -2, per_byte = -0.02F;
constexpr float impossible = -1e9F;

bool lower_case(char c) {
    return c >= 'a' && c <= 'z';
}
bool wordy(char c) {
    return lower_case(lower(c)) || (c >= '0' && c <= '9') || static_cast<unsigned char>(c) >= 128;
}
bool starts_word(std::string_view text, std::size_t at) {
    if (at == 0) return true;
    const bool hump = lower_case(text[at - 1]) && !lower_case(text[at]) && wordy(text[at]);
    return (wordy(text[at]) && !wordy(text[at - 1])) || hump;
}

/// For each letter of the word and each byte of the text: the score of the best match of the letters so far that has
/// this letter at this byte, and the byte of the letter before it.
struct Table {
    float best[most_letters][fuzzy_text_bytes];
    std::uint8_t from[most_letters][fuzzy_text_bytes];
};

void fill_row(Table& table, std::string_view word, std::string_view text, std::size_t i) {
    float before = impossible;  // the best score of the row above with at least one byte between
    std::size_t before_at = 0;
    for (std::size_t j = 0; j < text.size(); ++j) {
        if (i > 0 && j >= 2 && table.best[i - 1][j - 2] > before) before = table.best[i - 1][j - 2], before_at = j - 2;
        table.best[i][j] = impossible;
        if (lower(text[j]) != lower(word[i])) continue;
        const float value = letter + (starts_word(text, j) ? word_start : 0.0F);
        if (i == 0) {
            table.best[i][j] = value;
            continue;
        }
        const float beside = j >= 1 ? table.best[i - 1][j - 1] + side_by_side : impossible;
        table.best[i][j] = value + std::max(beside, before + gap);
        table.from[i][j] = static_cast<std::uint8_t>(beside >= before + gap ? j - 1 : before_at);
    }
}

bool match_word(std::string_view word, std::string_view text, FuzzyMatch& match) {
    word = word.substr(0, most_letters);
    Table table;
    for (std::size_t i = 0; i < word.size(); ++i) fill_row(table, word, text, i);
    const float* last = table.best[word.size() - 1];
    const std::size_t best = static_cast<std::size_t>(std::max_element(last, last + text.size()) - last);
    if (text.empty() || last[best] < impossible / 2) return false;
    match.score += last[best];
    std::size_t at = best;
    for (std::size_t i = word.size(); i-- > 0; at = i > 0 ? table.from[i][at] : at)
        match.places[at / 64] |= std::uint64_t{1} << (at % 64);
    return true;
}

}  // namespace

std::optional<FuzzyMatch> fuzzy_match(std::string_view pattern, std::string_view text) {
    FuzzyMatch match;
    const std::string_view looked_at = text.substr(0, fuzzy_text_bytes);
    bool any = false;
    while (!pattern.empty()) {
        const std::size_t end = std::min(pattern.find(' '), pattern.size());
        const std::string_view word = pattern.substr(0, end);
        pattern.remove_prefix(std::min(end + 1, pattern.size()));
        if (word.empty()) continue;
        if (!match_word(word, looked_at, match)) return std::nullopt;
        any = true;
    }
    if (any) match.score += per_byte * static_cast<float>(text.size());
    return match;
}

}  // namespace lapfx::ui
