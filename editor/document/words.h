// What differs between two states of a document, parameter by parameter, in words; made from the parameter tables.
//
//     for (const Difference& d : differences(before.preset, after.preset))
//         std::cout << d.name << ": " << change_text(d) << '\n';   // "Bleeding: Speed: 4 to 8.3 mm/s"
//     history.push_back(title_of(step));                           // "Speed: 4 to 8.3 mm/s", "Randomise: 12 rows"
//
// Elements of lists are matched by what they hold: one that was taken out of the middle is one difference, not a change
// of all that follow.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "document/document.h"

namespace lapfx::document {

struct Difference {
    enum class Kind {
        value,    ///< of one parameter
        part,     ///< an object that may be left out is there, or no more: a clip's own keying
        added,    ///< an element of a list
        removed,  ///< an element of a list
        moved,    ///< a list holds the same in another order
    };
    Kind kind = Kind::value;
    bool scene = false;               ///< of the scene, else of the preset
    std::string before_at, after_at;  ///< JSON pointers in each; of what is not there: where it would be
    std::string name;                 ///< "Bleeding: Speed", "Clip 2 (haze.mp4): Weight"
    std::string item;                 ///< the element it is in, "Clip 2 (haze.mp4)"; empty: in none
    std::string row;                  ///< "Speed"; of elements what they are called
    std::string before, after;        ///< "4 mm/s"; empty: not there
    std::string unit;
};

/// In the order of the tables.
std::vector<Difference> differences(const Preset& before, const Preset& after);
std::vector<Difference> differences(const Scene& before, const Scene& after);
std::vector<Difference> differences(const Content& before, const Content& after);

/// "4 to 8.3 mm/s", "added", "removed".
std::string change_text(const Difference& difference);

/// What a step of this name did, beside its name: "4 to 8.3 mm/s", "Time 0.8 to 1.2 s", "3 parameters"; empty when
/// nothing can be seen of it.
std::string change_of(std::string_view name, const Content& before, const Content& after);
/// "Speed: 4 to 8.3 mm/s", "Move event: cauterise, Time 0.8 to 1.2 s".
std::string title_of(const Step& step);

/// Makes `after` as `before` is, in this difference between them alone. Gives whether both are still as they were when
/// it was found.
bool take_back(Preset& after, const Preset& before, const Difference& difference);

}  // namespace lapfx::document
