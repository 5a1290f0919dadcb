// What differs between two states of a document, parameter by parameter, in words; made from the parameter tables.
//
//     for (const Difference& d : differences(before.preset, after.preset))
//         std::cout << d.name << ": " << change_text(d) << '\n';   // "Bleeding: Speed: 4 to 8.3 mm/s"
//     history.push_back(title_of(step));                           // "Speed: 4 to 8.3 mm/s", "Randomise: 12 rows"
//
// Elements of lists are matched by their values: removing one from the middle is one difference, not a change of all
// elements after it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "document/document.h"

namespace lapfx::document {

struct Difference {
    enum class Kind {
        value,    ///< the value of one parameter
        part,     ///< an object that may be left out was added or removed: a clip's own keying
        added,    ///< a list has a new element
        removed,  ///< a list has lost an element
        moved,    ///< a list has the same elements in another order
    };
    Kind kind = Kind::value;
    bool scene = false;               ///< it is in the scene, else in the preset
    std::string before_at, after_at;  ///< JSON pointers in each; for an element that one lacks, where it would be
    std::string name;                 ///< "Bleeding: Speed", "Clip 2 (haze.mp4): Weight"
    std::string item;                 ///< the element it is in, "Clip 2 (haze.mp4)"; empty: it is not in a list
    std::string row;                  ///< "Speed"; for an element its kind, "Clip"
    std::string before, after;        ///< "4 mm/s"; empty: it does not exist there
    std::string unit;
};

/// All differences in the order of the tables.
std::vector<Difference> differences(const Preset& before, const Preset& after);
std::vector<Difference> differences(const Scene& before, const Scene& after);
std::vector<Difference> differences(const Content& before, const Content& after);

/// "4 to 8.3 mm/s", "added", "removed".
std::string change_text(const Difference& difference);

/// A fault for a person who edits and sees no file: "smoke clip 4, gone.mp4: no such file" in place of a pointer.
std::string fault_text(const Fault& fault, const Preset& preset);

/// What a step did, as far as its name does not say it: "4 to 8.3 mm/s", "Time 0.8 to 1.2 s", "3 values". Empty
/// when there is no visible difference.
std::string change_of(std::string_view name, const Content& before, const Content& after);
/// "Speed: 4 to 8.3 mm/s", "Move event: cauterise, Time 0.8 to 1.2 s".
std::string title_of(const Step& step);

/// Undoes this one difference in `after`, so that `after` is there as `before` is. Returns false, and changes nothing,
/// if the two no longer have the places that the difference names, or the list is full.
bool take_back(Preset& after, const Preset& before, const Difference& difference);

}  // namespace lapfx::document
