// Parameters by key (`--set bleeding.speed=6`), and the check of a whole document's values.
#include <algorithm>
#include <array>
#include <charconv>
#include <optional>

#include "lapfx/authoring/letters.h"
#include "lapfx/parameter.h"
#include "preset/colors.h"
#include "preset/text.h"

namespace lapfx {

using preset::in_quotes;
using preset::join_pointer;

namespace {

[[noreturn]] void fail(std::string_view key, std::string reason) {
    throw Error(Failure::bad_input, Fault{"", preset::shown(key, 200), std::move(reason)});
}

std::vector<std::string_view> split(std::string_view text, std::string_view separators) {
    std::vector<std::string_view> parts;
    for (;;) {
        const std::size_t end = text.find_first_of(separators);
        parts.push_back(text.substr(0, end));
        if (end == std::string_view::npos) return parts;
        text.remove_prefix(end + 1);
    }
}

/// Every key that leads to a parameter of this document, "smoke.clips.0.weight".
void list_keys(const Table& table, void* owner, const std::string& prefix, std::vector<std::string>& keys) {
    for (const Parameter& row : table.rows) keys.push_back(prefix + std::string(row.key));
    for (const Table& child : table.tables) {
        const std::string inner = prefix + std::string(child.key) + '.';
        void* member = child.member(owner);
        if (!child.list) {
            list_keys(child, member, inner, keys);
        } else {
            for (std::size_t i = 0; i < child.list->size(member); ++i)
                list_keys(child, child.list->at(member, i), inner + std::to_string(i) + '.', keys);
        }
    }
}

[[noreturn]] void fail_unknown(const Table& root, void* document, std::string_view key) {
    std::string wanted(key.substr(key.starts_with('/') ? 1 : 0).substr(0, 200));
    std::replace(wanted.begin(), wanted.end(), '/', '.');
    std::vector<std::string> keys;
    list_keys(root, document, "", keys);
    std::string best;
    std::size_t least = std::string::npos;
    for (const std::string& known : keys) {
        // A key without its group means the last part.
        const std::string last = known.substr(known.rfind('.') + 1);
        const std::size_t distance = std::min(edit_distance(wanted, known), edit_distance(wanted, last) + 1);
        if (distance < least) {
            least = distance;
            best = known;
        }
    }
    fail(key, "no such parameter" + (best.empty() ? "" : "; nearest is " + best));
}

/// The element of a list that `index` names.
void* find_element(const Table& list, void* member, std::string_view index, std::string_view key) {
    std::size_t at = 0;
    const auto [end, error] = std::from_chars(index.data(), index.data() + index.size(), at);
    const std::size_t size = list.list->size(member);
    if (error == std::errc{} && end == index.data() + index.size() && at < size) return list.list->at(member, at);
    const std::string holds = size == 0 ? " is empty" : " has elements 0 to " + std::to_string(size - 1);
    fail(key, in_quotes(index) + " is not the number of an element; " + std::string(list.key) + holds);
}

std::optional<glm::dvec3> read_vector(std::string_view text) {
    const std::vector<std::string_view> parts = split(text, ",");
    if (parts.size() != 3) return {};
    glm::dvec3 value;
    for (int i = 0; i < 3; ++i) {
        std::string_view part = parts[static_cast<std::size_t>(i)];
        while (part.starts_with(' ')) part.remove_prefix(1);
        while (part.ends_with(' ')) part.remove_suffix(1);
        if (!preset::read_number(part, value[i])) return {};
    }
    return value;
}

std::optional<Value> read_value(const Parameter& row, std::string_view text) {
    switch (row.kind) {
        case Kind::number:
            if (double value; preset::read_number(text, value)) return value;
            return {};
        case Kind::integer: {
            int value = 0;
            const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
            if (error == std::errc{} && end == text.data() + text.size()) return value;
            return {};
        }
        case Kind::boolean:
            if (text == "true" || text == "false") return text == "true";
            return {};
        case Kind::choice: {
            const auto found = std::find(row.choices.begin(), row.choices.end(), text);
            if (found != row.choices.end()) return static_cast<int>(found - row.choices.begin());
            return {};
        }
        case Kind::color:
            if (const auto value = preset::read_hex_color(text)) return *value;
            [[fallthrough]];
        case Kind::vector:
            if (const auto value = read_vector(text)) return *value;
            return {};
        case Kind::text:
        case Kind::path:
            return std::string(text);
    }
    return {};
}

/// Where a value stands in a document. It becomes text only where there is a fault: a value is checked in every frame
/// in which it is dragged.
struct JsonPointer {
    const JsonPointer* parent = nullptr;
    std::string_view key = {};
    std::size_t index = 0;  ///< of an element of a list; only where `key` is empty

    std::string text() const {
        if (parent == nullptr) return "";
        return join_pointer(parent->text(), key.empty() ? std::to_string(index) : std::string(key));
    }
};

void check_table(const Table& table, void* owner, const JsonPointer& place, std::vector<Fault>& faults) {
    const auto add = [&](const JsonPointer& at, std::string reason) {
        if (!reason.empty()) faults.push_back({"", at.text(), std::move(reason)});
    };
    const std::size_t before = faults.size();
    for (const Parameter& row : table.rows) add({&place, row.key}, row.check_in(owner));
    if (faults.size() == before)  // a rule says nothing useful about values that are not allowed
        for (const Rule& rule : table.rules) add({&place, rule.key}, rule.check(owner));
    for (const Table& child : table.tables) {
        if (child.present && !*child.present(owner)) continue;
        const JsonPointer inner{&place, child.key};
        void* member = child.member(owner);
        if (!child.list) {
            check_table(child, member, inner, faults);
            continue;
        }
        const std::size_t size = child.list->size(member);
        if (size > child.list->maximum) add(inner, preset::too_many(size, child.list->maximum));
        const std::size_t looked_at = std::min(size, child.list->maximum), before_list = faults.size();
        for (std::size_t i = 0; i < looked_at; ++i)
            check_table(child, child.list->at(member, i), {.parent = &inner, .index = i}, faults);
        if (child.order == nullptr || faults.size() != before_list) continue;
        for (std::size_t i = 1; i < looked_at; ++i) {
            const JsonPointer element{.parent = &inner, .index = i};
            add({&element, child.order->key},
                child.order->check(child.list->at(member, i - 1), child.list->at(member, i)));
        }
    }
}

}  // namespace

FoundParameter find_parameter(const Table& root, void* document, std::string_view key) {
    std::vector<std::string_view> parts = split(key.substr(key.starts_with('/') ? 1 : 0), "./");
    const Table* table = &root;
    void* owner = document;
    bool* present = nullptr;
    std::string pointer;
    for (std::size_t i = 0; i + 1 < parts.size(); ++i) {
        table = table->find(parts[i]);
        if (!table) fail_unknown(root, document, key);
        present = table->present ? table->present(owner) : nullptr;
        owner = table->member(owner);
        pointer = join_pointer(pointer, parts[i]);
        if (!table->list) continue;
        if (++i + 1 == parts.size()) fail_unknown(root, document, key);
        owner = find_element(*table, owner, parts[i], key);
        pointer = join_pointer(pointer, parts[i]);
    }
    const Parameter* row = table->find_row(parts.back());
    if (!row) fail_unknown(root, document, key);
    return {row, owner, join_pointer(pointer, row->key), present};
}

void set_parameter(const Table& root, void* document, std::string_view key, std::string_view value) {
    const FoundParameter place = find_parameter(root, document, key);
    const std::optional<Value> read = read_value(*place.row, value);
    if (!read) fail(key, in_quotes(value) + " is not " + place.row->expected());
    if (std::string reason = place.row->check(*read); !reason.empty()) fail(key, std::move(reason));
    place.row->set(place.owner, *read);
    if (place.present) *place.present = true;
}

std::vector<Fault> check(const Table& root, const void* document) {
    std::vector<Fault> faults;
    check_table(root, const_cast<void*>(document), {}, faults);  // only addresses are taken
    return faults;
}

}  // namespace lapfx
