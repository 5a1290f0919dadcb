#include "match/compare/likeness_words.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "match/compare/joined.h"

namespace lapfx::match {

namespace {

// An onset is right within 0.2 s where the amount is known; of two, and of two times between two levels, it is more.
constexpr double onset_error = 0.3, duration_error = 0.4;  // s
constexpr double duration_share = 0.2;                     // of the reference's rise or decay: less is not worth a word
constexpr double ratio_share = 0.005;                      // less than that is 0 %
constexpr double plain_match = 0.25;                       // of the area: from here on a match says how far apart it is
constexpr double plain_late = 1.0;                         // s, the same of when it comes
constexpr double plain_alone = 1.0 / 3.0;                  // of the other's peak, up to which only that one is seen
constexpr double plain_peak_match = 0.03;                  // of the view, the same of the peaks, and
constexpr double plain_peak_ratio = 0.67;                  // of the higher peak, of amounts that both show

/// How an amount is spoken of, and what makes it.
struct Words {
    std::string_view amount;
    std::string_view little, much;  ///< what too little and too much of it is
    /// Parameters of the preset; empty: none does it. How fast haze rises, its event says (`duration`).
    std::string_view size, rise, fall;
    bool (*makes)(const ToolContact& event);
    std::string_view silenced;  ///< what a silenced event has none of
    double ToolContact::*loudness;
};
constexpr Words blood_words{.amount = "blood",
                            .little = "small",
                            .much = "large",
                            .size = "bleeding.max_extent",
                            .rise = "bleeding.speed",
                            .fall = "",
                            .makes = [](const ToolContact& event) { return divides(event.action); },
                            .silenced = "strength",
                            .loudness = &ToolContact::strength};
constexpr Words veil_words{.amount = "veil",
                           .little = "thin",
                           .much = "dense",
                           .size = "smoke.haze.accumulation",
                           .rise = "",
                           .fall = "smoke.haze.ventilation",
                           .makes = [](const ToolContact& event) { return event.hot(); },
                           .silenced = "power",
                           .loudness = &ToolContact::power};

template <typename... Values>
std::string text(const char* format, Values... values) {
    char made[128];
    std::snprintf(made, sizeof made, format, values...);
    return made;
}

/// "30 % too thin".
std::string size_text(double ratio, const Words& words) {
    constexpr double several = 2.0;  // from here on times are easier to read than percent
    const std::string much(words.much);
    if (ratio >= several) return text("%.1f times too %s", ratio, much.c_str());
    const double percent = 100.0 * std::abs(ratio - 1.0);
    return text("%.0f %% too %s", percent, ratio < 1.0 ? std::string(words.little).c_str() : much.c_str());
}

/// How far apart an amount is though the error of measuring would explain that; empty where it is near.
std::string rough_match(const AmountLikeness& amount, const Words& words) {
    if (!amount.matches()) return {};
    if (amount.area_ratio && std::abs(*amount.area_ratio - 1.0) > plain_match)
        return "it is measured " + size_text(*amount.area_ratio, words);
    const double preview = amount.preview.peak.value_or(0.0), reference = amount.reference.peak.value_or(0.0);
    if (std::abs(preview - reference) <= plain_peak_match) return {};
    if (amount.area_ratio && std::min(preview, reference) > plain_peak_ratio * std::max(preview, reference)) return {};
    return text("its peak is %.0f %% of the view, in the reference %.0f %%", 100.0 * preview, 100.0 * reference);
}

/// "rises 0.8 s too slowly"; empty where that is within the error.
std::string speed_text(const char* verb, const std::optional<double>& difference,
                       const std::optional<double>& reference) {
    if (!difference || !reference) return {};
    if (std::abs(*difference) <= std::max(duration_error, duration_share * *reference)) return {};
    return text("%s %.1f s too %s", verb, std::abs(*difference), *difference > 0.0 ? "slowly" : "fast");
}

/// One amount in clauses.
class Telling {
  public:
    Telling(const AmountLikeness& amount, const Words& words, std::span<const ToolContact> events)
        : a_(amount), words_(words), events_(events) {}

    std::vector<Clause> run() {
        if (a_.seen_apart())
            say(std::string("is ") + (*a_.bias > 0.0 ? "more" : "less") +
                    text(" in the preview, but how much cannot be told: the error of measuring is %.0f %% of the view",
                         100.0 * *a_.error),
                Said::seen_apart, std::string(words_.size));
        else if (a_.cannot_tell())
            say("cannot tell whether " + std::string(words_.amount) +
                    text(" matches: the error of measuring is %.0f %% of the view", 100.0 * *a_.error) +
                    (*a_.error > most_error ? "" : ", more than either shows"),
                Said::cannot_tell);
        else if (a_.matches())
            tell_match();
        else if (!tell_unmeasurable() && !tell_presence())
            tell_differences();
        return std::move(clauses_);
    }

  private:
    void say(std::string text, Said what, std::string key = {}) {
        clauses_.push_back({.amount = words_.amount, .text = std::move(text), .what = what, .key = std::move(key)});
    }
    /// Curves may be within the error of measuring of each other though a viewer sees an amount in one alone, or sees
    /// it begin much earlier. Of what is about none (told_peak) a viewer sees nothing.
    void tell_match() {
        const double in_preview = a_.preview.peak.value_or(0.0), in_reference = a_.reference.peak.value_or(0.0);
        const std::string seen_alone = " alone, though by no more than the error of measuring";
        if (a_.in_preview == Presence::shown && a_.in_reference == Presence::none && in_preview > told_peak &&
            in_reference < plain_alone * in_preview)
            return say("is seen in the preview" + seen_alone, Said::surplus, silencing_key());
        if (a_.in_reference == Presence::shown && a_.in_preview == Presence::none && in_reference > told_peak &&
            in_preview < plain_alone * in_reference)
            return say("is seen in the reference" + seen_alone, Said::missing, event_key(a_.reference, true));
        const bool late = a_.late && std::abs(*a_.late) > plain_late;
        if (late) tell_late();
        if (const std::string apart = rough_match(a_, words_); !apart.empty())
            say("matches within the error of measuring, which is large: " + apart, Said::rough_match);
        else if (late)
            say("matches within the error of measuring otherwise", Said::rough_match);
        else
            say("matches within the error of measuring", Said::match);
    }
    void tell_late() {
        say(text("comes %.1f s too %s", std::abs(*a_.late), *a_.late > 0.0 ? "late" : "early"), Said::timing,
            event_key(a_.preview, false));
    }
    bool tell_unmeasurable() {
        const bool preview = a_.in_preview == Presence::unmeasurable,
                   reference = a_.in_reference == Presence::unmeasurable;
        if (a_.frames == 0) {
            say("is at no time measurable in both", Said::unmeasurable);
        } else if (preview || reference) {
            const char* where = !reference ? "preview" : !preview ? "reference" : "preview and in the reference";
            say(std::string("is too rarely measurable in the ") + where, Said::unmeasurable);
        }
        return !clauses_.empty();
    }
    bool tell_presence() {
        if (a_.lost_in_error()) return false;
        const bool changes = a_.preview.peak_at.has_value(), should = a_.reference.peak_at.has_value();
        if (a_.missing_in_preview())
            say("is missing in the preview", Said::missing, event_key(a_.reference, true));
        else if (a_.missing_in_reference())
            say("is in the preview alone", Said::surplus, silencing_key());
        else if (changes && !should)
            say("changes in the preview alone", Said::surplus, silencing_key());
        else if (should && !changes)
            say("does not change in the preview", Said::missing, event_key(a_.reference, true));
        return !clauses_.empty();
    }
    void tell_differences() {
        if (a_.late && std::abs(*a_.late) > onset_error) tell_late();
        if (a_.peak_ratio && std::abs(*a_.peak_ratio - 1.0) >= ratio_share && a_.peak_over_error > 1.0)
            say("is " + size_text(*a_.peak_ratio, words_), Said::size, std::string(words_.size));
        if (std::string rises = speed_text("rises", a_.rise_difference, a_.reference.rise); !rises.empty())
            say(std::move(rises), Said::rise,
                words_.rise.empty() ? key_of(nearest(a_.preview), "duration") : std::string(words_.rise));
        if (std::string falls = speed_text("falls", a_.decay_difference, a_.reference.decay); !falls.empty())
            say(std::move(falls), Said::fall, std::string(words_.fall));
        if (clauses_.empty())
            say(text("differs by %.2g, %.1f times the error of measuring", *a_.rms, *a_.rms_over_error), Said::course,
                std::string(words_.size));
    }

    /// That begins nearest to where the amount does; of an amount without a beginning, to its peak, else the first.
    std::optional<std::size_t> nearest(const Episode& episode) const {
        const std::optional<double> begins = episode.onset ? episode.onset : episode.peak_at;
        std::optional<std::size_t> found;
        const auto far = [&](std::size_t i) { return begins ? std::abs(events_[i].time - *begins) : events_[i].time; };
        for (std::size_t i = 0; i < events_.size(); ++i)
            if (words_.makes(events_[i]) && (!found || far(i) < far(*found))) found = i;
        return found;
    }
    static std::string key_of(const std::optional<std::size_t>& event, std::string_view row) {
        return event ? "events." + std::to_string(*event) + "." + std::string(row) : std::string();
    }
    /// `missing`: an event that is silenced is to be heard before it is to be moved.
    std::string event_key(const Episode& episode, bool missing) const {
        const std::optional<std::size_t> event = nearest(episode);
        const bool silent = event && missing && events_[*event].*words_.loudness <= 0.0;
        return key_of(event, silent ? words_.silenced : "time");
    }
    std::string silencing_key() const { return key_of(nearest(a_.preview), words_.silenced); }

    const AmountLikeness& a_;
    const Words& words_;
    std::span<const ToolContact> events_;
    std::vector<Clause> clauses_;
};

/// What one amount's clauses say, "veil comes 1.2 s too late and is 30 % too thin".
std::string sentence_of(const std::vector<Clause>& all, std::string_view amount) {
    std::vector<std::string> parts;
    for (const Clause& clause : all)
        if (clause.amount == amount) parts.push_back(parts.empty() ? clause.sentence() : clause.text);
    return joined(parts);
}

/// Lower is told first: what differs or is nowhere measurable, then what nobody can tell, then what matches.
int rank(const std::vector<Clause>& clauses) {
    const Said first = clauses.front().what;
    return first == Said::match || first == Said::rough_match ? 2 : first == Said::cannot_tell ? 1 : 0;
}

}  // namespace

std::vector<Clause> clauses(const Likeness& likeness, std::span<const ToolContact> events) {
    if (!likeness.overlap)
        return {{.text = "preview and reference have no time in common", .what = Said::no_time, .key = {}}};
    std::vector<Clause> all = Telling(likeness.blood, blood_words, events).run();
    std::vector<Clause> of_veil = Telling(likeness.veil, veil_words, events).run();
    const bool veil_first = rank(of_veil) < rank(all);
    all.insert(veil_first ? all.begin() : all.end(), std::make_move_iterator(of_veil.begin()),
               std::make_move_iterator(of_veil.end()));
    return all;
}

std::string in_words(const Likeness& likeness) {
    const std::vector<Clause> all = clauses(likeness);
    if (all.size() == 1) return all.front().sentence();
    if (std::ranges::all_of(all, [](const Clause& clause) { return clause.what == Said::match; }))
        return "blood and veil match within the error of measuring";
    return sentence_of(all, all.front().amount) + "; " + sentence_of(all, all.back().amount);
}

}  // namespace lapfx::match
