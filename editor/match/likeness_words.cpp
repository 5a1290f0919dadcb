// A likeness as one line for people.
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "match/likeness.h"

namespace lapfx::match {

namespace {

// An onset is right within 0.2 s where the amount is known; of two, and of two times between two levels, it is more.
constexpr double onset_error = 0.3, duration_error = 0.4;  // s
constexpr double duration_share = 0.2;                     // of the reference's rise or decay: less is not worth a word
constexpr double ratio_share = 0.005;                      // less than that is 0 %

struct Name {
    std::string_view amount;
    std::string_view little, much;  ///< what too little and too much of it is
};
constexpr Name blood_name{"blood", "small", "large"}, veil_name{"veil", "thin", "dense"};

template <typename... Values>
std::string text(const char* format, Values... values) {
    char made[128];
    std::snprintf(made, sizeof made, format, values...);
    return made;
}

/// "a, b and c".
std::string joined(const std::vector<std::string>& parts) {
    std::string all;
    for (std::size_t i = 0; i < parts.size(); ++i)
        all += (i == 0 ? "" : i + 1 == parts.size() ? " and " : ", ") + parts[i];
    return all;
}

/// "is 30 % too thin".
std::string size_text(double ratio, const Name& name) {
    constexpr double several = 2.0;  // from here on times are easier to read than percent
    const std::string much(name.much);
    if (ratio >= several) return text("is %.1f times too %s", ratio, much.c_str());
    const double percent = 100.0 * std::abs(ratio - 1.0);
    return text("is %.0f %% too %s", percent, ratio < 1.0 ? std::string(name.little).c_str() : much.c_str());
}

/// "rises 0.8 s too slowly"; empty where that is within the error.
std::string speed_text(const char* verb, const std::optional<double>& difference,
                       const std::optional<double>& reference) {
    if (!difference || !reference) return {};
    if (std::abs(*difference) <= std::max(duration_error, duration_share * *reference)) return {};
    return text("%s %.1f s too %s", verb, std::abs(*difference), *difference > 0.0 ? "slowly" : "fast");
}

std::vector<std::string> differences(const AmountLikeness& a, const Name& name) {
    const bool changes = a.preview.peak_at.has_value(), should = a.reference.peak_at.has_value();
    if (changes != should) return {changes ? "changes in the preview alone" : "does not change in the preview"};
    std::vector<std::string> parts;
    if (a.late && std::abs(*a.late) > onset_error)
        parts.push_back(text("comes %.1f s too %s", std::abs(*a.late), *a.late > 0.0 ? "late" : "early"));
    if (a.peak_ratio && std::abs(*a.peak_ratio - 1.0) >= ratio_share && a.peak_over_error > 1.0)
        parts.push_back(size_text(*a.peak_ratio, name));
    for (const std::string& speed : {speed_text("rises", a.rise_difference, a.reference.rise),
                                     speed_text("falls", a.decay_difference, a.reference.decay)})
        if (!speed.empty()) parts.push_back(speed);
    if (parts.empty())
        parts.push_back(text("differs by %.2g, %.1f times the error of measuring", *a.rms, *a.rms_over_error));
    return parts;
}

/// Of an amount that does not match.
std::string clause(const AmountLikeness& a, const Name& name) {
    const std::string amount(name.amount);
    const bool preview = a.in_preview == Presence::unmeasurable, reference = a.in_reference == Presence::unmeasurable;
    if (a.frames == 0) return amount + " is at no time measurable in both";
    if (preview || reference) {
        const char* where = !reference ? "preview" : !preview ? "reference" : "preview and of the reference";
        return amount + " is not measurable in most of the " + where;
    }
    if (a.missing_in_preview()) return amount + " is missing in the preview";
    if (a.missing_in_reference()) return amount + " is in the preview alone";
    return amount + " " + joined(differences(a, name));
}

}  // namespace

std::string in_words(const Likeness& likeness) {
    if (!likeness.overlap) return "preview and reference have no time in common";
    const bool blood = likeness.blood.matches(), veil = likeness.veil.matches();
    if (blood && veil) return "blood and veil match within the error of measuring";
    if (blood) return clause(likeness.veil, veil_name) + "; blood matches within the error of measuring";
    if (veil) return clause(likeness.blood, blood_name) + "; veil matches within the error of measuring";
    return clause(likeness.blood, blood_name) + "; " + clause(likeness.veil, veil_name);
}

}  // namespace lapfx::match
