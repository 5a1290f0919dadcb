// A curve over time as text, for copying it into a spreadsheet or a mail and pasting it from there.
//
//     clipboard.set(curve_text(scene.curves.emission));                                        // "0\t1\n2.5\t0.4\n"
//     scene.curves.emission = parse_curve_text(clipboard.get(), *curve_table("emission"));     // throws Error
//
// Each line is one point: its time in s and its value, separated by tabs, spaces, a comma or a semicolon. Lines without
// any digit are skipped. Any thread.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lapfx/curves.h"
#include "lapfx/parameter.h"

namespace lapfx::document {

/// The rows and rules of scene.curves.KEY; null: there is none.
const Table* curve_table(std::string_view key);

std::string curve_text(std::span<const CurvePoint> points);

/// Throws Error (bad_input) with a fault for each line that the table does not allow.
std::vector<CurvePoint> parse_curve_text(std::string_view text, const Table& table);

}  // namespace lapfx::document
