#include "document/delta.h"

#include <algorithm>
#include <cassert>
#include <cstring>

#include "document/tables.h"
#include "lapfx/authoring/table_walk.h"

namespace lapfx::document {

namespace {

// --- values as bytes -------------------------------------------------------------------------------------------------
// A value is written as its bytes. A text or a list begins with its size. The order is that of the table.

std::size_t size_of(Kind kind) {
    switch (kind) {
        case Kind::number:
            return sizeof(double);
        case Kind::integer:
        case Kind::choice:  // an enum over int: same bytes, but not the same type
            return sizeof(int);
        case Kind::boolean:
            return sizeof(bool);
        case Kind::color:
        case Kind::vector:
            return sizeof(glm::dvec3);
        case Kind::text:
        case Kind::path:
            break;
    }
    return 0;
}

const void* value_of(const Parameter& row, const void* owner) {
    return row.member(const_cast<void*>(owner));  // only an address is taken, nothing is written
}

bool is_text(const Parameter& row) {
    return row.kind == Kind::text || row.kind == Kind::path;
}

void write_size(std::size_t size, std::string& bytes) {
    bytes.append(reinterpret_cast<const char*>(&size), sizeof size);
}

void write(const Parameter& row, const void* owner, std::string& bytes) {
    const void* value = value_of(row, owner);
    if (!is_text(row)) {
        bytes.append(static_cast<const char*>(value), size_of(row.kind));
        return;
    }
    const auto& text = *static_cast<const std::string*>(value);
    write_size(text.size(), bytes);
    bytes += text;
}

/// Writes an object or an element with everything in it, also the parts that are switched off.
void write(const Table& table, const void* owner, std::string& bytes) {
    for (const Parameter& row : table.rows) write(row, owner, bytes);
    for (const Table& child : table.tables) {
        if (child.present != nullptr) bytes += static_cast<char>(present(child, owner));
        const void* member = member_of(child, owner);
        if (child.list == nullptr) {
            write(child, member, bytes);
            continue;
        }
        write_size(child.list->size(member), bytes);
        for (std::size_t i = 0; i < child.list->size(member); ++i) write(child, element(child, member, i), bytes);
    }
}

/// Reads the values in the order in which they were written.
class Reader {
  public:
    explicit Reader(std::string_view bytes) : left_(bytes) {}

    std::size_t size() {
        std::size_t size = 0;
        std::memcpy(&size, take(sizeof size).data(), sizeof size);
        return size;
    }
    bool flag() { return take(1).front() != 0; }
    void read(const Parameter& row, void* owner) {
        void* value = row.member(owner);
        if (is_text(row))
            *static_cast<std::string*>(value) = take(size());
        else
            std::memcpy(value, take(size_of(row.kind)).data(), size_of(row.kind));
    }
    void read(const Table& table, void* owner) {
        for (const Parameter& row : table.rows) read(row, owner);
        for (const Table& child : table.tables) {
            if (child.present != nullptr) *child.present(owner) = flag();
            void* member = child.member(owner);
            if (child.list == nullptr) {
                read(child, member);
                continue;
            }
            child.list->resize(member, size());
            for (std::size_t i = 0; i < child.list->size(member); ++i) read(child, child.list->at(member, i));
        }
    }

  private:
    std::string_view take(std::size_t count) {
        assert(count <= left_.size());
        const std::string_view taken = left_.substr(0, count);
        left_.remove_prefix(count);
        return taken;
    }

    std::string_view left_;
};

// --- equal to the last bit -------------------------------------------------------------------------------------------
// This differs from equal() of authoring/compare.h, for which -0 equals 0 and the values of a part that is switched off
// do not count.

bool identical(const Parameter& row, const void* a, const void* b) {
    const void *left = value_of(row, a), *right = value_of(row, b);
    if (is_text(row)) return *static_cast<const std::string*>(left) == *static_cast<const std::string*>(right);
    return std::memcmp(left, right, size_of(row.kind)) == 0;
}

bool identical(const Table& table, const void* a, const void* b) {
    for (const Parameter& row : table.rows)
        if (!identical(row, a, b)) return false;
    for (const Table& child : table.tables) {
        if (present(child, a) != present(child, b)) return false;
        const void *left = member_of(child, a), *right = member_of(child, b);
        if (child.list == nullptr) {
            if (!identical(child, left, right)) return false;
            continue;
        }
        const std::size_t size = child.list->size(left);
        if (size != child.list->size(right)) return false;
        for (std::size_t i = 0; i < size; ++i)
            if (!identical(child, element(child, left, i), element(child, right, i))) return false;
    }
    return true;
}

/// The bytes of elements [first, first + count) of a list. Their number comes first.
std::string written(const Table& list, const void* vector, std::size_t first, std::size_t count) {
    std::string bytes;
    write_size(count, bytes);
    for (std::size_t i = first; i < first + count; ++i) write(list, element(list, vector, i), bytes);
    bytes.shrink_to_fit();
    return bytes;
}

/// Replaces `replaced` elements from `first` on by those in `bytes`.
void put_elements(const Table& list, void* vector, std::size_t first, std::size_t replaced, Reader bytes) {
    const std::size_t count = bytes.size(), before = list.list->size(vector), after = before - replaced + count;
    const std::size_t behind = before - first - replaced;  // elements that stay, but move
    if (after > before) list.list->resize(vector, after);
    for (std::size_t k = 0; k < behind; ++k) {
        const std::size_t i = after > before ? behind - 1 - k : k;  // none is overwritten before it has moved
        copy(list, list.list->at(vector, first + count + i), list.list->at(vector, first + replaced + i));
    }
    if (after < before) list.list->resize(vector, after);
    for (std::size_t i = first; i < first + count; ++i) bytes.read(list, list.list->at(vector, i));
}

}  // namespace

void Delta::compare(const Table& table, const void* before, const void* after, const std::string& place) {
    for (const Parameter& row : table.rows) {
        if (identical(row, before, after)) continue;
        Change& change =
            changes_.emplace_back(Change{.place = place + '/' + std::string(row.key), .before = {}, .after = {}});
        write(row, before, change.before);
        write(row, after, change.after);
    }
    for (const Table& child : table.tables) {
        const std::string below = place + '/' + std::string(child.key);
        if (const bool was = present(child, before), is = present(child, after); was != is)
            changes_.push_back({.what = Change::What::presence,
                                .place = below,
                                .before = std::string(1, static_cast<char>(was)),
                                .after = std::string(1, static_cast<char>(is))});
        const void *left = member_of(child, before), *right = member_of(child, after);
        if (child.list != nullptr)
            compare_list(child, left, right, below);
        else
            compare(child, left, right, below);
    }
    if (place.empty()) changes_.shrink_to_fit();  // the whole document is compared
}

/// Lists of the same length are compared element by element. Otherwise the change is all between the elements that are
/// equal at the front and those that are equal at the end.
void Delta::compare_list(const Table& list, const void* before, const void* after, const std::string& place) {
    const std::size_t n = list.list->size(before), m = list.list->size(after);
    const auto equal = [&](std::size_t i, std::size_t j) {
        return identical(list, element(list, before, i), element(list, after, j));
    };
    if (n == m) {
        for (std::size_t i = 0; i < n; ++i)
            if (!equal(i, i))
                compare(list, element(list, before, i), element(list, after, i), place + '/' + std::to_string(i));
        return;
    }
    const std::size_t shorter = std::min(n, m);
    std::size_t front = 0, end = 0;
    while (front < shorter && equal(front, front)) ++front;
    while (end < shorter - front && equal(n - 1 - end, m - 1 - end)) ++end;
    changes_.push_back({.what = Change::What::elements,
                        .place = place,
                        .first = front,
                        .before = written(list, before, front, n - front - end),
                        .after = written(list, after, front, m - front - end)});
}

/// The order of the changes does not matter: when a list gets longer or shorter, no change has a place inside it.
void Delta::put(void* document, std::string Change::*state) const {
    for (const Change& change : changes_) {
        const Spot spot = find(*table_, document, change.place);
        assert(spot);
        Reader bytes(change.*state);
        if (change.what == Change::What::value) {
            bytes.read(*spot.row, spot.owner);
        } else if (change.what == Change::What::presence) {
            *spot.table->present(spot.parent) = bytes.flag();
        } else {
            const std::string& there = state == &Change::after ? change.before : change.after;
            put_elements(*spot.table, spot.owner, change.first, Reader(there).size(), bytes);
        }
    }
}

bool Delta::changes(std::string_view place) const {
    return std::any_of(changes_.begin(), changes_.end(), [&](const Change& c) { return c.place == place; });
}

void Delta::replace(std::string_view place, const std::string& from, const std::string& to) {
    std::string old_text, new_text;
    for (const auto& [text, bytes] : {std::pair(&from, &old_text), std::pair(&to, &new_text)}) {
        write_size(text->size(), *bytes);
        *bytes += *text;
    }
    for (Change& change : changes_) {
        if (change.place != place) continue;
        for (std::string* bytes : {&change.before, &change.after})
            if (*bytes == old_text) *bytes = new_text;
    }
    std::erase_if(changes_, [](const Change& change) { return change.before == change.after; });
}

std::size_t Delta::memory() const {
    const std::size_t inside = std::string().capacity();
    std::size_t bytes = changes_.capacity() * sizeof(Change) + folders_.capacity() * sizeof(std::filesystem::path);
    for (const Change& change : changes_)
        for (const std::string* text : {&change.place, &change.before, &change.after})
            if (text->capacity() > inside) bytes += text->capacity() + 1;
    for (const std::filesystem::path& folder : folders_) bytes += folder.native().size();
    return bytes;
}

}  // namespace lapfx::document
