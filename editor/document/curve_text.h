// A curve over time as text: what is copied into a spreadsheet or a mail, and pasted from there.
//
//     clipboard.set(curve_text(scene.curves.emission));                                        // "0\t1\n2.5\t0.4\n"
//     scene.curves.emission = parse_curve_text(clipboard.get(), *curve_table("emission"));     // throws Error
//
// A point a line: its time in s and its value, told apart by tabs, spaces, a comma or a semicolon. Lines without any
// figure are passed over. Any thread.
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

/// Throws Error (bad_input) with a fault for each line that is not allowed by the table.
std::vector<CurvePoint> parse_curve_text(std::string_view text, const Table& table);

}  // namespace lapfx::document
