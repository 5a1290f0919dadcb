// What differs between two structs of a parameter table, row by row: equality, and what has to be done again. Nothing
// is allocated. Values are compared as they are, also those that no row allows. Pure; any thread.
//
//     if (difference(preset_table(), &shown, &wanted) & redo::clips) open_clips(wanted);
#pragma once

#include "lapfx/parameter.h"

namespace lapfx {

/// Whether one value is equal. -0 equals 0; two NaN are equal.
bool equal(const Parameter& row, const void* a, const void* b);
/// Whether all rows, lists and parts are equal.
bool equal(const Table& table, const void* a, const void* b);
/// The redo bits of everything that differs; 0 when all is equal.
unsigned difference(const Table& table, const void* a, const void* b);

}  // namespace lapfx
