// One row: reading, writing and checking a value. What a whole document does with the rows: document.h.
#include "lapfx/parameter.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstring>

#include "lapfx/authoring/utf8.h"
#include "preset/text.h"

namespace lapfx {

using preset::in_quotes;
using preset::number_text;

namespace {

std::string with_unit(double value, const Parameter& row) {
    return number_text(value) + (row.unit.empty() ? "" : ' ' + std::string(row.unit));
}

std::string range_text(const Parameter& row) {
    return number_text(row.minimum) + " to " + with_unit(row.maximum, row);
}

/// `what` names a component of a vector, or is empty.
std::string check_number(double value, const Parameter& row, std::string_view what = {}) {
    if (value >= row.minimum && value <= row.maximum) return {};  // the usual case allocates nothing
    const std::string prefix = what.empty() ? "" : std::string(what) + " = ";
    const std::string allowed = " (allowed: " + range_text(row) + ')';
    if (!std::isfinite(value)) return prefix + number_text(value) + " is not a finite number" + allowed;
    if (value < row.minimum)
        return prefix + number_text(value) + " is below the minimum " + with_unit(row.minimum, row) + allowed;
    return prefix + number_text(value) + " is above the maximum " + with_unit(row.maximum, row) + allowed;
}

std::string check_vector(const glm::dvec3& value, const Parameter& row) {
    static constexpr const char* components[] = {"x", "y", "z"};
    static constexpr const char* channels[] = {"red", "green", "blue"};
    for (int i = 0; i < 3; ++i) {
        std::string reason = check_number(value[i], row, (row.kind == Kind::color ? channels : components)[i]);
        if (!reason.empty()) return reason;
    }
    return {};
}

std::string check_text(const std::string& value, const Parameter& row) {
    if (!is_utf8(value)) return in_quotes(value) + " is not valid UTF-8";
    const auto is_control = [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; };
    if (std::any_of(value.begin(), value.end(), is_control))
        return in_quotes(value) + " contains a control character or a line break";
    if (const std::size_t length = count_characters(value); double(length) > row.maximum)
        return std::to_string(length) + " characters; at most " + number_text(row.maximum) + " are allowed";
    return {};
}

/// File names come from strangers and end up in file dialogs and FFmpeg: nothing may leave the folder of a
/// preset, and nothing may be taken for a URL or a protocol ("concat:a|b", "subfile,,start,0,end,9,,:a").
std::string check_path(const std::string& value, const Parameter& row) {
    if (value.empty()) return row.required ? "empty; expected " + row.expected() : "";
    if (std::string reason = check_text(value, row); !reason.empty()) return reason;
    const auto fault = [&](const char* what) { return in_quotes(value) + what + "; expected " + row.expected(); };
    const std::string_view first = std::string_view(value).substr(0, value.find('/'));
    if (first.find(':') != std::string_view::npos || value.starts_with("subfile,") ||
        (row.contained && value.find(':') != std::string::npos))
        return fault(" is a URL or a protocol");
    if (value.find('\\') != std::string::npos) return in_quotes(value) + " contains a backslash; folders end in '/'";
    if (value.back() == '/') return fault(" is a folder");
    if (!row.contained) return {};
    if (value.front() == '/') return fault(" is an absolute path");
    if (value == ".." || value.starts_with("../") || value.ends_with("/..") || value.find("/../") != std::string::npos)
        return fault(" is outside the folder");
    return {};
}

std::string choices_text(const Parameter& row) {
    std::string out;
    for (const std::string_view name : row.choices) out += (out.empty() ? "" : ", ") + in_quotes(name);
    return out;
}

template <class T>
std::string expect_type(const Value& value, const Parameter& row, std::string (*check)(const T&, const Parameter&)) {
    const T* held = std::get_if<T>(&value);
    return held ? check(*held, row) : "a value of the wrong type; expected " + row.expected();
}

}  // namespace

std::string Parameter::expected() const {
    switch (kind) {
        case Kind::number:
            return "a number from " + range_text(*this);
        case Kind::integer:
            return "a whole number from " + range_text(*this);
        case Kind::boolean:
            return "true or false";
        case Kind::choice:
            return "one of " + choices_text(*this);
        case Kind::color:
            return "\"#rrggbb\" or [red, green, blue], each " + range_text(*this);
        case Kind::vector:
            return "[x, y, z], each " + range_text(*this);
        case Kind::text:
            return "a string of at most " + number_text(maximum) + " characters";
        case Kind::path:
            return contained ? "the name of a file in the folder of the preset" : "the name of a local file";
    }
    return {};
}

std::string Parameter::check(const Value& value) const {
    switch (kind) {
        case Kind::number:
            return expect_type<double>(value, *this,
                                       [](const double& v, const Parameter& row) { return check_number(v, row); });
        case Kind::integer:
        case Kind::choice:
            return expect_type<int>(value, *this,
                                    [](const int& v, const Parameter& row) { return check_number(v, row); });
        case Kind::boolean:
            return expect_type<bool>(value, *this, [](const bool&, const Parameter&) { return std::string(); });
        case Kind::color:
        case Kind::vector:
            return expect_type<glm::dvec3>(value, *this, check_vector);
        case Kind::text:
            return expect_type<std::string>(value, *this, check_text);
        case Kind::path:
            return expect_type<std::string>(value, *this, check_path);
    }
    return {};
}

std::string Parameter::check_in(const void* owner) const {
    if (kind != Kind::text && kind != Kind::path) return check(get(owner));
    const void* value = member(const_cast<void*>(owner));  // only the address is taken
    return (kind == Kind::text ? check_text : check_path)(*static_cast<const std::string*>(value), *this);
}

Value Parameter::get(const void* owner) const {
    const void* value = member(const_cast<void*>(owner));  // only the address is taken
    switch (kind) {
        case Kind::number:
            return *static_cast<const double*>(value);
        case Kind::integer:
            return *static_cast<const int*>(value);
        case Kind::boolean:
            return *static_cast<const bool*>(value);
        case Kind::choice: {
            int index;  // an enum over int: same bytes, but not the same type
            std::memcpy(&index, value, sizeof index);
            return index;
        }
        case Kind::color:
        case Kind::vector:
            return *static_cast<const glm::dvec3*>(value);
        case Kind::text:
        case Kind::path:
            return *static_cast<const std::string*>(value);
    }
    return {};
}

void Parameter::set(void* owner, const Value& value) const {
    assert(check(value).empty());
    void* target = member(owner);
    switch (kind) {
        case Kind::number:
            *static_cast<double*>(target) = std::get<double>(value);
            break;
        case Kind::integer:
            *static_cast<int*>(target) = std::get<int>(value);
            break;
        case Kind::boolean:
            *static_cast<bool*>(target) = std::get<bool>(value);
            break;
        case Kind::choice:
            std::memcpy(target, &std::get<int>(value), sizeof(int));
            break;
        case Kind::color:
        case Kind::vector:
            *static_cast<glm::dvec3*>(target) = std::get<glm::dvec3>(value);
            break;
        case Kind::text:
        case Kind::path:
            *static_cast<std::string*>(target) = std::get<std::string>(value);
            break;
    }
}

const Parameter* Table::find_row(std::string_view row_key) const {
    const auto found = std::find_if(rows.begin(), rows.end(), [&](const auto& row) { return row.key == row_key; });
    return found == rows.end() ? nullptr : &*found;
}

const Table* Table::find(std::string_view table_key) const {
    const auto found = std::find_if(tables.begin(), tables.end(), [&](const auto& t) { return t.key == table_key; });
    return found == tables.end() ? nullptr : &*found;
}

}  // namespace lapfx
