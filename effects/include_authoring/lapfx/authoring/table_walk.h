// From a struct to the parts that its table (lapfx/parameter.h) says it has, without changing them. Pure; any thread.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string_view>

#include "lapfx/parameter.h"

namespace lapfx {

/// The object or list that `table` describes, in its parent's struct.
inline const void* member_of(const Table& table, const void* owner) {
    return table.member(const_cast<void*>(owner));  // only an address is taken, nothing is written
}

/// Whether the object exists: only some may be left out.
inline bool present(const Table& table, const void* owner) {
    return table.present == nullptr || *table.present(const_cast<void*>(owner));
}

/// `vector`: the list.
inline const void* element(const Table& list, const void* vector, std::size_t index) {
    return list.list->at(const_cast<void*>(vector), index);
}

/// Takes the first part of a key off it: gives "bleeding" of "bleeding.speed" and leaves "speed". Of a key of one part
/// nothing is left.
inline std::string_view take_part(std::string_view& key, char separator = '.') {
    const std::string_view part = key.substr(0, key.find(separator));
    key.remove_prefix(std::min(part.size() + 1, key.size()));
    return part;
}

/// The value that a key such as "bleeding.speed" leads to. Throws Error (bad_input) with the nearest known key.
inline Value value_at(const Table& root, const void* document, std::string_view key) {
    const FoundParameter found = find_parameter(root, const_cast<void*>(document), key);  // only an address is taken
    return found.row->get(found.owner);
}

}  // namespace lapfx
