#include "document/tables.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>
#include <optional>

#include "lapfx/authoring/table_walk.h"

namespace lapfx::document {

namespace {

using Json = nlohmann::json;

void copy_child(const Table& child, void* to, const void* from) {
    if (child.present != nullptr) *child.present(to) = present(child, from);
    void* target = child.member(to);
    const void* source = member_of(child, from);
    if (child.list == nullptr) return copy(child, target, source);
    const std::size_t size = child.list->size(source);
    child.list->resize(target, size);
    for (std::size_t i = 0; i < size; ++i) copy(child, child.list->at(target, i), element(child, source, i));
}

/// -1 if the text is not a whole number.
long index_from(std::string_view text) {
    long index = -1;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), index);
    return error == std::errc() && end == text.data() + text.size() ? index : -1;
}

std::string shortest(double value) {
    char text[32];
    const auto end = std::to_chars(text, text + sizeof text, value == 0 ? 0.0 : value).ptr;
    return {text, end};
}

/// A number with one digit more than a step of the slider needs. Without a step it has all its digits.
std::string rounded(double value, double step) {
    if (!std::isfinite(value) || step <= 0 || std::abs(value) >= 1e15) return shortest(value);
    const int decimals = std::clamp(static_cast<int>(std::ceil(-std::log10(step) - 1e-9)) + 1, 0, 9);
    char text[64];
    auto end = std::to_chars(text, text + sizeof text, value, std::chars_format::fixed, decimals).ptr;
    if (std::find(text, end, '.') != end) {
        while (end[-1] == '0') --end;
        if (end[-1] == '.') --end;
    }
    std::string shown(text, end);
    return shown == "-0" ? "0" : shown;
}

std::string hex(const glm::dvec3& color) {
    std::string text = "#";
    for (int i = 0; i < 3; ++i) {
        const int code = std::clamp(static_cast<int>(std::lround(color[i] * 255)), 0, 255);
        for (const int digit : {code / 16, code % 16}) text += "0123456789abcdef"[digit];
    }
    return text;
}

template <typename Number>
std::string value_text(const Parameter& row, const void* owner, bool exact, const Number& number) {
    const Value value = row.get(owner);
    switch (row.kind) {
        case Kind::number:
            return number(std::get<double>(value));
        case Kind::integer:
            return std::to_string(std::get<int>(value));
        case Kind::boolean:
            return std::get<bool>(value) ? "on" : "off";
        case Kind::choice: {
            const auto index = static_cast<std::size_t>(std::get<int>(value));
            return index < row.choices.size() ? std::string(row.choices[index]) : std::to_string(index);
        }
        case Kind::color:
            if (!exact) return hex(std::get<glm::dvec3>(value));
            [[fallthrough]];
        case Kind::vector: {
            const auto& v = std::get<glm::dvec3>(value);
            return number(v.x) + ", " + number(v.y) + ", " + number(v.z);
        }
        default: {
            const auto& text = std::get<std::string>(value);
            return text.empty() ? "none" : text;
        }
    }
}

std::string with_unit(std::string text, const Parameter& row) {
    return row.unit.empty() ? text : text + ' ' + std::string(row.unit);
}

std::optional<glm::dvec3> color_from(const Json& json) {
    if (!json.is_string()) return std::nullopt;
    const auto& text = json.get_ref<const std::string&>();
    if (text.size() != 7 || text[0] != '#') return std::nullopt;
    glm::dvec3 color(0);
    for (int i = 0; i < 3; ++i) {
        int code = 0;
        const char* at = text.data() + 1 + 2 * i;
        if (std::from_chars(at, at + 2, code, 16).ptr != at + 2) return std::nullopt;
        color[i] = code / 255.0;
    }
    return color;
}

std::optional<Value> value_from(const Parameter& row, const Json& json) {
    switch (row.kind) {
        case Kind::number:
            return json.is_number() ? std::optional<Value>(json.get<double>()) : std::nullopt;
        case Kind::integer:
            if (!json.is_number_integer() || std::abs(json.get<double>()) > 2147483647.0) return std::nullopt;
            return json.get<int>();
        case Kind::boolean:
            return json.is_boolean() ? std::optional<Value>(json.get<bool>()) : std::nullopt;
        case Kind::choice: {
            if (!json.is_string()) return std::nullopt;
            const auto found = std::find(row.choices.begin(), row.choices.end(), json.get_ref<const std::string&>());
            if (found == row.choices.end()) return std::nullopt;
            return static_cast<int>(found - row.choices.begin());
        }
        case Kind::color:
            if (const auto color = color_from(json)) return *color;
            [[fallthrough]];
        case Kind::vector: {
            const auto is_number = [](const Json& j) { return j.is_number(); };
            if (!json.is_array() || json.size() != 3 || !std::all_of(json.begin(), json.end(), is_number))
                return std::nullopt;
            return glm::dvec3(json[0].get<double>(), json[1].get<double>(), json[2].get<double>());
        }
        default:
            return json.is_string() ? std::optional<Value>(json.get<std::string>()) : std::nullopt;
    }
}

class LooseReader {
  public:
    std::vector<std::string> told;

    void read(const Table& table, void* owner, const Json& json, const std::string& pointer) {
        if (!json.is_object()) return tell(pointer, "not a JSON object");
        for (const auto& [key, inner] : json.items()) {
            const std::string place = pointer + '/' + key;
            if (const Parameter* row = table.find_row(key)) {
                read_value(*row, owner, inner, place);
            } else if (const Table* child = table.find(key)) {
                read_child(*child, owner, inner, place);
            } else if (!pointer.empty() || (key != "format" && key != "version")) {
                tell(place, "unknown");
            }
        }
    }

  private:
    void tell(const std::string& place, const std::string& reason) {
        constexpr std::size_t most = 200;
        if (told.size() < most) told.push_back((place.empty() ? "/" : place) + ": " + reason);
    }

    void read_value(const Parameter& row, void* owner, const Json& json, const std::string& place) {
        const std::optional<Value> value = value_from(row, json);
        if (!value) return tell(place, "expected " + row.expected());
        // A clip in another folder is allowed here: its name is corrected when the preset is saved.
        Parameter checked = row;
        checked.contained = checked.required = false;
        if (const std::string fault = checked.check(*value); !fault.empty()) return tell(place, fault);
        checked.set(owner, *value);
    }

    void read_child(const Table& child, void* owner, const Json& json, const std::string& place) {
        void* member = child.member(owner);
        if (child.present != nullptr) *child.present(owner) = true;
        if (child.list == nullptr) return read(child, member, json, place);
        if (!json.is_array()) return tell(place, "not a JSON array");
        const std::size_t size = std::min(json.size(), child.list->maximum);
        if (size < json.size()) tell(place, "only " + std::to_string(size) + " are kept");
        child.list->resize(member, 0);
        child.list->resize(member, size);
        for (std::size_t i = 0; i < size; ++i)
            read(child, child.list->at(member, i), json[i], place + '/' + std::to_string(i));
    }
};

}  // namespace

/// This does not use Parameter::set(), which takes only what its row allows.
void copy(const Parameter& row, void* to, const void* from) {
    void* target = row.member(to);
    const void* source = row.member(const_cast<void*>(from));
    switch (row.kind) {
        case Kind::number:
            *static_cast<double*>(target) = *static_cast<const double*>(source);
            break;
        case Kind::integer:
        case Kind::choice:
            std::memcpy(target, source, sizeof(int));  // an enum over int: same bytes, but not the same type
            break;
        case Kind::boolean:
            *static_cast<bool*>(target) = *static_cast<const bool*>(source);
            break;
        case Kind::color:
        case Kind::vector:
            *static_cast<glm::dvec3*>(target) = *static_cast<const glm::dvec3*>(source);
            break;
        case Kind::text:
        case Kind::path:
            *static_cast<std::string*>(target) = *static_cast<const std::string*>(source);
            break;
    }
}

void copy(const Table& table, void* to, const void* from) {
    if (to == from) return;
    for (const Parameter& row : table.rows) copy(row, to, from);
    for (const Table& child : table.tables) copy_child(child, to, from);
}

void erase(const Table& list, void* vector, std::size_t index) {
    const std::size_t size = list.list->size(vector);
    if (index >= size) return;
    for (std::size_t i = index; i + 1 < size; ++i) copy(list, list.list->at(vector, i), list.list->at(vector, i + 1));
    list.list->resize(vector, size - 1);
}

void insert(const Table& list, void* vector, std::size_t index, const void* element) {
    const std::size_t size = list.list->size(vector);
    index = std::min(index, size);
    list.list->resize(vector, size + 1);
    for (std::size_t i = size; i > index; --i) copy(list, list.list->at(vector, i), list.list->at(vector, i - 1));
    copy(list, list.list->at(vector, index), element);
}

Spot find(const Table& root, void* document, std::string_view pointer) {
    Spot at{.table = &root, .owner = document};
    while (!pointer.empty()) {
        if (pointer.front() != '/' || at.row != nullptr) return {};
        pointer.remove_prefix(1);
        const std::string_view key = pointer.substr(0, pointer.find('/'));
        pointer.remove_prefix(key.size());
        if (at.table->list != nullptr && !at.element) {
            const long index = index_from(key);
            if (index < 0 || static_cast<std::size_t>(index) >= at.table->list->size(at.owner)) return {};
            at.parent = at.owner;
            at.index = static_cast<std::size_t>(index);
            at.owner = at.table->list->at(at.parent, at.index);
            at.element = true;
        } else if (const Parameter* row = at.table->find_row(key)) {
            at.row = row;
        } else if (const Table* child = at.table->find(key)) {
            at = {.table = child, .owner = child->member(at.owner), .parent = at.owner};
        } else {
            return {};
        }
    }
    return at;
}

std::string text_of(const Parameter& row, const void* owner) {
    return with_unit(value_text(row, owner, false, [&](double v) { return rounded(v, row.step); }), row);
}

std::string exact_text_of(const Parameter& row, const void* owner) {
    return with_unit(value_text(row, owner, true, [](double v) { return shortest(v); }), row);
}

std::vector<std::string> read_what_can_be(const Table& root, void* document, std::string_view json) {
    const Json parsed = Json::parse(json, nullptr, false);
    LooseReader reader;
    if (parsed.is_discarded())
        reader.told.emplace_back("not JSON");
    else
        reader.read(root, document, parsed, "");
    return std::move(reader.told);
}

}  // namespace lapfx::document
