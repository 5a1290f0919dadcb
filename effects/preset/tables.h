// Building blocks of the parameter tables, and the tables that the effects' folders provide.
//
//     constexpr Parameter rows[] = {
//         number<&BleedingParameters::speed>("speed", "Speed", {0.0, 60.0, 0.1, "mm/s"}, "How fast ..."),
//     };
//
// The type of the member decides the accessor; a helper that does not fit the member does not compile.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "lapfx/parameter.h"

namespace lapfx::preset {

struct Range {
    double minimum;
    double maximum;
    double step;
    std::string_view unit = {};
    Scale scale = Scale::linear;
};

template <class>
struct MemberPointer;
template <class O, class T>
struct MemberPointer<T O::*> {
    using Owner = O;
    using Type = T;
};
template <auto Member>
using OwnerOf = typename MemberPointer<decltype(Member)>::Owner;
template <auto Member>
using TypeOf = typename MemberPointer<decltype(Member)>::Type;

template <auto Member>
void* address_of(void* owner) {
    return &(static_cast<OwnerOf<Member>*>(owner)->*Member);
}

template <auto Member, class Expected>
constexpr Parameter row(Kind kind, std::string_view key, std::string_view name, Range range, std::string_view help) {
    static_assert(std::is_same_v<TypeOf<Member>, Expected>, "this kind of row does not fit the member's type");
    return {.key = key,
            .name = name,
            .kind = kind,
            .minimum = range.minimum,
            .maximum = range.maximum,
            .step = range.step,
            .unit = range.unit,
            .scale = range.scale,
            .choices = {},
            .help = help,
            .member = address_of<Member>};
}

template <auto Member>
constexpr Parameter number(std::string_view key, std::string_view name, Range range, std::string_view help) {
    return row<Member, double>(Kind::number, key, name, range, help);
}
template <auto Member>
constexpr Parameter integer(std::string_view key, std::string_view name, Range range, std::string_view help) {
    return row<Member, int>(Kind::integer, key, name, range, help);
}
template <auto Member>
constexpr Parameter boolean(std::string_view key, std::string_view name, std::string_view help) {
    return row<Member, bool>(Kind::boolean, key, name, {0, 1, 1}, help);
}
template <auto Member>
constexpr Parameter color(std::string_view key, std::string_view name, std::string_view help) {
    return row<Member, glm::dvec3>(Kind::color, key, name, {0, 1, 1.0 / 255}, help);
}
template <auto Member>
constexpr Parameter vector(std::string_view key, std::string_view name, Range range, std::string_view help) {
    return row<Member, glm::dvec3>(Kind::vector, key, name, range, help);
}
template <auto Member>
constexpr Parameter text(std::string_view key, std::string_view name, double longest, std::string_view help) {
    return row<Member, std::string>(Kind::text, key, name, {0, longest, 0}, help);
}
template <auto Member>
constexpr Parameter path(std::string_view key, std::string_view name, std::string_view help) {
    return row<Member, std::string>(Kind::path, key, name, {0, 1000, 0}, help);
}
/// `names` in the order of the enumerators, which count from 0.
template <auto Member>
constexpr Parameter choice(std::string_view key, std::string_view name, std::span<const std::string_view> names,
                           std::string_view help) {
    static_assert(std::is_same_v<std::underlying_type_t<TypeOf<Member>>, int>);
    Parameter made = row<Member, TypeOf<Member>>(Kind::choice, key, name, {0, double(names.size()) - 1, 1}, help);
    made.choices = names;
    return made;
}

/// The keys of a list's rows (lapfx/rows.h), for choice().
template <const auto& rows>
inline constexpr auto keys_of = [] {
    std::array<std::string_view, std::size(rows)> keys{};
    for (std::size_t i = 0; i < keys.size(); ++i) keys[i] = rows[i].key;
    return keys;
}();

/// Puts "cauterise: heat that ... smokes. cut: ..." of a list's rows.
constexpr void put_rows(const auto& put, const auto& rows) {
    bool first = true;
    for (const auto& row : rows) {
        if (!std::exchange(first, false)) put(" ");
        for (const std::string_view part : {row.key, std::string_view(": "), row.help, std::string_view(".")})
            put(part);
    }
}
/// Puts "plume or haze" of a list's rows.
constexpr void put_keys(const auto& put, const auto& rows) {
    for (std::size_t i = 0; i < std::size(rows); ++i) {
        if (i > 0) put(i + 1 < std::size(rows) ? ", " : " or ");
        put(rows[i].key);
    }
}

/// A text of parts, for help that tells the rows of a list: `write` calls its argument with each part.
template <auto write>
struct Text {
    static constexpr std::size_t length = [] {
        std::size_t sum = 0;
        write([&](std::string_view part) { sum += part.size(); });
        return sum;
    }();
    static constexpr std::array<char, length> letters = [] {
        std::array<char, length> text{};
        std::size_t at = 0;
        write([&](std::string_view part) {
            for (const char letter : part) text[at++] = letter;
        });
        return text;
    }();
};
template <auto write>
inline constexpr std::string_view text_of{Text<write>::letters.data(), Text<write>::length};

constexpr Parameter required(Parameter made) {
    made.required = true;
    return made;
}
constexpr Parameter contained(Parameter made) {
    made.contained = true;
    return made;
}
constexpr Parameter same_as(std::string_view key, Parameter made) {
    made.same_as = key;
    return made;
}

/// Adds `bits` of redo to a row or a table; drawing is always one of them.
template <class Made>
constexpr Made again(unsigned bits, Made made) {
    made.redo |= bits;
    return made;
}

/// Adds `bits` for a list that gets longer or shorter.
constexpr Table again_for_length(unsigned bits, Table made) {
    made.redo_length |= bits;
    return made;
}

/// For rules: empty when value < bound, otherwise the reason, which names the row of the bound.
std::string below(double value, std::string_view bound_key, double bound);
/// The same for value <= bound.
std::string not_above(double value, std::string_view bound_key, double bound);

/// The parts of an object of a document.
struct Content {
    std::span<const Parameter> rows;
    std::span<const Table> tables = {};
    std::span<const Rule> rules = {};
};

template <auto Member>
constexpr Table table(std::string_view key, std::string_view name, std::string_view help, Content content) {
    return {.key = key,
            .name = name,
            .help = help,
            .rows = content.rows,
            .tables = content.tables,
            .rules = content.rules,
            .member = address_of<Member>};
}

/// A struct that may be left out; the bool `Present` of the same owner says whether it is there.
template <auto Present>
constexpr Table optional(Table made) {
    made.present = [](void* owner) { return static_cast<bool*>(address_of<Present>(owner)); };
    return made;
}

template <class T, std::size_t Maximum>
inline constexpr Table::List list_of{
    .size = [](const void* list) { return static_cast<const std::vector<T>*>(list)->size(); },
    .at = [](void* list, std::size_t index) -> void* { return &(*static_cast<std::vector<T>*>(list))[index]; },
    .resize = [](void* list, std::size_t size) { static_cast<std::vector<T>*>(list)->resize(size); },
    .maximum = Maximum,
};

/// A std::vector of structs, of at most `Maximum` elements.
template <auto Member, std::size_t Maximum>
constexpr Table list(std::string_view key, std::string_view name, std::string_view help, Content content) {
    Table made = table<Member>(key, name, help, content);
    made.list = &list_of<typename TypeOf<Member>::value_type, Maximum>;
    return made;
}

constexpr Table ordered(const OrderRule& rule, Table made) {
    made.order = &rule;
    return made;
}

/// The groups of a preset: each is built in the folder of its effect.
Table bleeding_table();
Table vessels_table();
Table cautery_table();
Table smoke_table();

}  // namespace lapfx::preset
