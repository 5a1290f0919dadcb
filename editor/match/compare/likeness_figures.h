// The figures of a likeness by name: one table for texts, files, limits and help.
//
//     for (const match::Figure& figure : match::figures())
//         if (const std::optional<double> value = figure.of(compared)) std::cout << figure.name << ": " << *value <<
//         '\n';
//
// Pure functions, any thread; nothing throws.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "match/compare/color_likeness.h"
#include "match/compare/likeness.h"

namespace lapfx::match {

/// Of a preview and a reference.
struct Compared {
    Likeness amounts;
    ColorLikeness colors;
};

/// How a figure grows with what is wrong.
enum class Farness : std::uint8_t {
    size,   ///< its size: 0 is alike
    ratio,  ///< the larger of it and of 1 over it: 1 is alike
};

struct Figure {
    std::string name;       ///< "veil_rms"
    std::string_view unit;  ///< "s"; empty: a share of the view, or a ratio
    std::string_view help;  ///< "root mean square of the difference over time"
    Farness farness;
    /// Where it is: in one of the amounts, or in the colours; the others are null.
    AmountLikeness Likeness::*amount = nullptr;
    std::optional<double> AmountLikeness::*of_amount = nullptr;
    std::optional<double> ColorLikeness::*of_colors = nullptr;

    /// Nothing: not known.
    std::optional<double> of(const Compared& compared) const;
    /// What a limit is held against: never less for what is farther, and as large for too little as for too much. A
    /// ratio of 0 is infinitely far.
    double far(double value) const;
};

/// Of blood, of veil, then of colours.
std::span<const Figure> figures();
/// Null: there is none of that name.
const Figure* figure_named(std::string_view name);

}  // namespace lapfx::match
