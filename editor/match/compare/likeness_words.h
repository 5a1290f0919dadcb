// The line in words (likeness.h) in its parts, each with what mends it: a panel shows them as links.
//
//     for (const match::Clause& clause : match::clauses(likeness, scene.events))
//         if (link(clause.sentence())) go_to(clause.key);   // "veil is 30 % too thin": smoke.haze.accumulation
//
// Pure functions, any thread; nothing throws.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lapfx/tool.h"
#include "match/compare/likeness.h"

namespace lapfx::match {

/// What a clause tells.
enum class Said : std::uint8_t {
    timing,        ///< it comes too late or too early
    size,          ///< it is too much or too little
    rise,          ///< it rises too slowly or too fast
    fall,          ///< it falls too slowly or too fast
    missing,       ///< it is, or changes, in the reference alone
    surplus,       ///< it is, or changes, in the preview alone
    course,        ///< its course differs otherwise
    unmeasurable,  ///< nothing is known
    cannot_tell,   ///< what it differs by is within an error so large that nothing is known
    seen_apart,    ///< it is more or less, but by how much nobody can tell
    match,         ///< it does not differ
    rough_match,   ///< what it differs by is within an error that is large
    no_time,       ///< preview and reference have no time in common
};

struct Clause {
    std::string_view amount = {};  ///< "blood" or "veil"; empty where it is of both
    std::string text = {};         ///< "is 30 % too thin"
    Said what = Said::match;
    /// Of the preset's parameter that mends it, or of the scene's: "smoke.haze.accumulation", "events.2.time". Empty:
    /// there is none.
    std::string key = {};

    /// "veil is 30 % too thin", "cannot tell whether veil matches: ..."
    std::string sentence() const {
        return amount.empty() || what == Said::cannot_tell ? text : std::string(amount) + ' ' + text;
    }
};

/// What differs first, then what nobody can tell, what matches last, as in_words(). Without the scene's events no key
/// names one. An event is the nearest of those that make the amount, hot ones and those that divide tissue: to where
/// the preview's amount begins, or to where the reference's does, which is missing in the preview. A silenced one needs
/// power or strength.
std::vector<Clause> clauses(const Likeness& likeness, std::span<const ToolContact> events = {});

}  // namespace lapfx::match
