// The parameter table: one row per tunable value, and everything else is made from the rows: JSON reading and
// writing, validation, the schema files, `--set KEY=VALUE`, `--help`, rows of the editor, the reference page.
//
//     for (const lapfx::Parameter& row : lapfx::preset_table().find("bleeding")->rows)
//         std::cout << row.key << ' ' << row.unit << '\n';
//
// A parameter is one member of a plain struct (preset.h, scene.h; its initialiser is the default) and one row
// in the table of that struct. Tables are immutable and may be read from any thread.
#pragma once

#include <glm/glm.hpp>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "lapfx/api.h"
#include "lapfx/error.h"

namespace lapfx {

/// What a value is: its C++ type in the struct, and its JSON type.
enum class Kind {
    number,   ///< double; JSON number
    integer,  ///< int; JSON integer
    boolean,  ///< bool; JSON boolean
    choice,   ///< an enum class over int; JSON string, one of `choices`
    color,    ///< glm::dvec3, sRGB, each 0..1; JSON "#rrggbb" or [r, g, b]
    vector,   ///< glm::dvec3, each within minimum..maximum; JSON [x, y, z]
    text,     ///< std::string, UTF-8, one line, at most `maximum` characters; JSON string
    path,     ///< std::string, name of a plain local file, at most `maximum` characters; JSON string
};

/// How a slider divides its range.
enum class Scale { linear, logarithmic };

/// A value on its own, for generic code (undo, `--set`). A choice is an int: the index into `choices`.
using Value = std::variant<double, int, bool, glm::dvec3, std::string>;

/// What has to be done again, besides drawing, when a value changes: bits of Parameter::redo. A row declares them once.
/// Code that keeps results computed from values asks which bits differ.
namespace redo {
enum : unsigned {
    picture = 1U << 0,       ///< drawing; every row has it
    organ = 1U << 1,         ///< loading organ and tool
    clips = 1U << 2,         ///< opening clips, and planning what is played of each
    amounts = 1U << 3,       ///< computing amounts over time
    fronts = 1U << 4,        ///< computing the ways of blood over the organ
    bleed = 1U << 5,         ///< computing bleed values
    blood_sums = 1U << 6,    ///< summing area and volume of blood
    keyed_frame = 1U << 7,   ///< keying a frame of a clip
    clearing = 1U << 8,      ///< finding what suction and irrigation reach
    heat = 1U << 9,          ///< heat under the tool, and what it cuts and closes
    tip_places = 1U << 10,   ///< dividing the ways of the tool's tip into places
    metal_clips = 1U << 11,  ///< placing metal clips, and finding what they hold
    densities = 1U << 12,    ///< finding vessels and fat
    emission = 1U << 13,     ///< finding how much smoke each burn makes
    haze = 1U << 14,         ///< computing haze over time
    smoke = 1U << 15,        ///< preparing how smoke is drawn
};
}

/// One row: everything about one parameter.
struct LAPFX_API Parameter {
    std::string_view key;   ///< JSON key, snake_case
    std::string_view name;  ///< human name, as the UI shows it
    Kind kind = Kind::number;
    double minimum = 0;  ///< inclusive; number, integer, and each component of a vector or color
    double maximum = 0;  ///< inclusive; for text and path the greatest length
    double step = 0;     ///< what one notch of a slider changes
    std::string_view unit = {};
    Scale scale = Scale::linear;
    std::span<const std::string_view> choices = {};
    std::string_view help;                   ///< one or two sentences, with the paper's term where there is one
    void* (*member)(void* owner) = nullptr;  ///< address of the value inside its struct
    bool required = false;                   ///< the key must be there: it has no sensible default
    std::string_view same_as = {};           ///< a missing key takes the value of this row of the same table
    bool contained = false;                  ///< path: stays inside the document's folder
    unsigned redo = redo::picture;           ///< what has to be done again when it changes

    Value get(const void* owner) const;
    /// The value must be of this row's type and within its range (assert): check() what comes from outside.
    void set(void* owner, const Value& value) const;
    /// Empty when `value` is allowed; otherwise the reason: "-3 is below the minimum 0 mm/s (allowed: 0 to 60 mm/s)".
    /// NaN and infinity are never allowed.
    std::string check(const Value& value) const;
    /// The same for the value that `owner` holds. Allocates nothing when the value is allowed.
    std::string check_in(const void* owner) const;
    /// What is allowed, as a noun: "a number from 0 to 60 mm/s".
    std::string expected() const;
};

/// A rule between the values of one struct: luma_low is below luma_high.
struct Rule {
    std::string_view key;                     ///< the row that is blamed
    std::string (*check)(const void* owner);  ///< empty, or what is wrong
};

/// A rule between an element of a list and the one before: times ascend.
struct OrderRule {
    std::string_view key;                                           ///< the row of the later element that is blamed
    std::string (*check)(const void* before, const void* element);  ///< empty, or what is wrong
};

/// A struct of parameters: a JSON object, or (with `list`) an array of such objects.
struct LAPFX_API Table {
    std::string_view key;   ///< JSON key in the parent, empty for the root
    std::string_view name;  ///< human name
    std::string_view help;
    std::span<const Parameter> rows;
    std::span<const Table> tables = {};      ///< nested objects, in the order they are written
    std::span<const Rule> rules = {};        ///< checked once every row is allowed by itself
    void* (*member)(void* owner) = nullptr;  ///< address of the struct (or std::vector of it) in the parent's struct

    struct List {
        std::size_t (*size)(const void* list);
        void* (*at)(void* list, std::size_t index);
        void (*resize)(void* list, std::size_t size);
        std::size_t maximum;  ///< most elements allowed
    };
    const List* list = nullptr;        ///< set when `member` is a std::vector
    const OrderRule* order = nullptr;  ///< of a list; checked once its elements are allowed by themselves
    /// Set for an object that may be left out: a bool in the parent's struct that says whether the object exists. Where
    /// it does not, its values mean nothing and are neither written nor checked.
    bool* (*present)(void* owner) = nullptr;
    unsigned redo = 0;  ///< bits for a change of anything in it
    unsigned redo_length =
        0;  ///< bits for a list that gets longer or shorter, and for an object that is added or removed

    const Parameter* find_row(std::string_view row_key) const;
    const Table* find(std::string_view table_key) const;
};

/// A parameter inside a document: where `bleeding.speed` or `smoke.clips.0.weight` leads to.
struct FoundParameter {
    const Parameter* row = nullptr;
    void* owner = nullptr;
    std::string pointer;  ///< JSON pointer, "/bleeding/speed"
    bool* present =
        nullptr;  ///< for a row whose object may be left out: whether it exists; set it when you set a value
};

/// Follows a key; '.' and '/' both separate, a leading '/' is allowed.
/// Throws Error (bad_input) with the nearest known key.
LAPFX_API FoundParameter find_parameter(const Table& root, void* document, std::string_view key);

/// Sets one value from text, as `--set KEY=VALUE` does: "4.5", "true", "light", "#5d0f11", "1,2,3". Throws Error
/// (bad_input), and leaves the document as it was, when the key is unknown or the value is not allowed. Rules between
/// values are not checked, because a series of calls may break one for a moment: call check() at the end.
LAPFX_API void set_parameter(const Table& root, void* document, std::string_view key, std::string_view value);

/// Every fault in the values of a document: ranges, and rules between values. Places are pointers.
LAPFX_API std::vector<Fault> check(const Table& root, const void* document);

}  // namespace lapfx
