// Generic work on the structs behind a parameter table: copying, finding, reading what the strict reader
// refuses. Values are taken as they are, also those that no row allows: a document may be out of order while it is
// edited.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lapfx/parameter.h"

namespace lapfx::document {

void copy(const Table& table, void* to, const void* from);
void copy(const Parameter& row, void* to, const void* from);
/// A list's element goes; one is put in before `index`, a copy of `element`.
void erase(const Table& list, void* vector, std::size_t index);
void insert(const Table& list, void* vector, std::size_t index, const void* element);

/// Where a JSON pointer leads to.
struct Spot {
    const Parameter* row = nullptr;  ///< of a value; its owner is `owner`
    const Table* table = nullptr;    ///< of an object, a list ("/smoke/clips") or an element of one ("/smoke/clips/0")
    void* owner = nullptr;           ///< the struct; of a list, the vector
    void* parent = nullptr;          ///< of an object or list: the struct it is a member of; of an element: its vector
    std::size_t index = 0;           ///< of an element
    bool element = false;
    explicit operator bool() const { return owner != nullptr; }
};
/// Nothing when there is no such place. `document` is not changed.
Spot find(const Table& root, void* document, std::string_view pointer);

/// "7.5 mm/s", "light", "on", "#5d0f11", "1, 2, 3 mm"; an empty text is "none". Numbers are as fine as their slider.
std::string text_of(const Parameter& row, const void* owner);
/// To the last digit.
std::string exact_text_of(const Parameter& row, const void* owner);

/// Fills `document`, a struct with its defaults, with what can be used of this JSON: unknown keys, wrong types and
/// values out of range are left out and told, rules between values are not looked at. Never throws but for memory.
std::vector<std::string> read_what_can_be(const Table& root, void* document, std::string_view json);

}  // namespace lapfx::document
