// From a struct to the parts that its table (lapfx/parameter.h) says it has, without changing them. Pure; any thread.
#pragma once

#include <cstddef>

#include "lapfx/parameter.h"

namespace lapfx {

/// The object or list that `table` describes, in its parent's struct.
inline const void* member_of(const Table& table, const void* owner) {
    return table.member(const_cast<void*>(owner));  // only the address is taken
}

/// Whether the object exists: only some may be left out.
inline bool present(const Table& table, const void* owner) {
    return table.present == nullptr || *table.present(const_cast<void*>(owner));
}

/// `vector`: the list.
inline const void* element(const Table& list, const void* vector, std::size_t index) {
    return list.list->at(const_cast<void*>(vector), index);
}

}  // namespace lapfx
