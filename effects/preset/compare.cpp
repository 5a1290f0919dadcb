#include "lapfx/authoring/compare.h"

#include <cmath>
#include <cstring>

#include "lapfx/authoring/table_walk.h"

namespace lapfx {

namespace {

bool same(double a, double b) {
    return a == b || (std::isnan(a) && std::isnan(b));
}

/// The bits of everything that can differ in it.
unsigned all_of(const Table& table, unsigned above) {
    unsigned bits = redo::picture | above | table.redo | table.redo_length;
    for (const Parameter& row : table.rows) bits |= row.redo;
    for (const Table& child : table.tables) bits |= all_of(child, 0);
    return bits;
}

/// Whether two lists of this size are the same byte by byte: then they are equal. Long lists of plain numbers, such as
/// a scene's events, are compared many times faster so than row by row.
bool same_bytes(const Table& list, const void* a, const void* b, std::size_t size) {
    if (size < 2) return false;
    const auto* const first = static_cast<const char*>(element(list, a, 0));
    const auto stride = static_cast<std::size_t>(static_cast<const char*>(element(list, a, 1)) - first);
    return std::memcmp(first, element(list, b, 0), size * stride) == 0;
}

/// Calls differs(bits) for what differs, until it answers false; then that is the answer too.
template <class Differs>
bool look(const Table& table, const void* a, const void* b, unsigned above, Differs& differs) {
    const unsigned here = above | table.redo;
    for (const Parameter& row : table.rows)
        if (!equal(row, a, b) && !differs(here | row.redo)) return false;
    for (const Table& child : table.tables) {
        const bool is_there = present(child, a);
        if (is_there != present(child, b)) {
            if (!differs(all_of(child, here))) return false;
            continue;
        }
        if (!is_there) continue;
        const void *left = member_of(child, a), *right = member_of(child, b);
        if (child.list == nullptr) {
            if (!look(child, left, right, here, differs)) return false;
            continue;
        }
        const std::size_t size = child.list->size(left);
        if (size != child.list->size(right)) {
            if (!differs(all_of(child, here))) return false;
            continue;
        }
        if (same_bytes(child, left, right, size)) continue;
        for (std::size_t i = 0; i < size; ++i)
            if (!look(child, element(child, left, i), element(child, right, i), here, differs)) return false;
    }
    return true;
}

}  // namespace

bool equal(const Parameter& row, const void* a, const void* b) {
    const void *left = row.member(const_cast<void*>(a)), *right = row.member(const_cast<void*>(b));
    switch (row.kind) {
        case Kind::number:
            return same(*static_cast<const double*>(left), *static_cast<const double*>(right));
        case Kind::integer:
        case Kind::choice:  // an enum over int: same bytes, but not the same type
            return std::memcmp(left, right, sizeof(int)) == 0;
        case Kind::boolean:
            return *static_cast<const bool*>(left) == *static_cast<const bool*>(right);
        case Kind::color:
        case Kind::vector: {
            const auto &u = *static_cast<const glm::dvec3*>(left), &v = *static_cast<const glm::dvec3*>(right);
            return same(u.x, v.x) && same(u.y, v.y) && same(u.z, v.z);
        }
        case Kind::text:
        case Kind::path:
            return *static_cast<const std::string*>(left) == *static_cast<const std::string*>(right);
    }
    return false;
}

bool equal(const Table& table, const void* a, const void* b) {
    const auto stop = [](unsigned) { return false; };
    return look(table, a, b, 0, stop);
}

unsigned difference(const Table& table, const void* a, const void* b) {
    unsigned bits = 0;
    const auto gather = [&](unsigned more) {
        bits |= more;
        return true;
    };
    look(table, a, b, 0, gather);
    return bits;
}

}  // namespace lapfx
