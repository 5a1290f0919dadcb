// Generic work on the structs behind a parameter table: copying them, finding places in them, and reading files that
// the strict reader refuses. Values are taken as they are, also those that no row allows: a document may break rules
// while it is edited.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lapfx/parameter.h"

namespace lapfx::document {

void copy(const Table& table, void* to, const void* from);
void copy(const Parameter& row, void* to, const void* from);
/// erase() removes an element of a list. insert() puts a copy of `element` in before `index`.
void erase(const Table& list, void* vector, std::size_t index);
void insert(const Table& list, void* vector, std::size_t index, const void* element);

/// Where a JSON pointer leads to.
struct Spot {
    const Parameter* row = nullptr;  ///< if it is a value: its row
    const Table* table = nullptr;    ///< if it is an object, a list ("/smoke/clips") or an element ("/smoke/clips/0")
    void* owner = nullptr;           ///< a value's or object's struct, the element, or a list's vector
    void* parent = nullptr;          ///< the struct that an object or list is a member of; an element's vector
    std::size_t index = 0;           ///< the index of an element
    bool element = false;
    explicit operator bool() const { return owner != nullptr; }
};
/// Gives an empty Spot when there is no such place. `document` is not changed.
Spot find(const Table& root, void* document, std::string_view pointer);

/// "7.5 mm/s", "light", "on", "#5d0f11", "1, 2, 3 mm"; an empty text is "none". Numbers have one digit more than a step
/// of their slider needs.
std::string text_of(const Parameter& row, const void* owner);
/// The same with all digits of numbers.
std::string exact_text_of(const Parameter& row, const void* owner);

/// Fills `document`, a struct with its defaults, with the values of this JSON that can be used. Unknown keys, wrong
/// types and values out of range are left out, and the result has a line for each. Rules between values are not
/// checked. Throws nothing, except when memory runs out.
std::vector<std::string> read_what_can_be(const Table& root, void* document, std::string_view json);

}  // namespace lapfx::document
