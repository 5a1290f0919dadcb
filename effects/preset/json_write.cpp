#include "preset/json_write.h"

#include <cassert>
#include <cmath>

#include "lapfx/authoring/file.h"
#include "lapfx/error.h"
#include "preset/colors.h"
#include "preset/document.h"
#include "preset/text.h"

namespace lapfx::preset {

namespace {

/// What is no JSON number becomes null, which no reader takes for a value.
std::string json_number(double value) {
    return std::isfinite(value) ? number_text(value) : "null";
}

void write_table(JsonWriter& out, const Table& table, void* owner) {
    for (const Parameter& row : table.rows) out.value(row.key, json_value(row, row.get(owner)));
    for (const Table& child : table.tables) {
        if (child.present && !*child.present(owner)) continue;
        void* member = child.member(owner);
        out.open(child.list ? '[' : '{', child.key);
        if (!child.list) write_table(out, child, member);
        for (std::size_t i = 0; child.list && i < child.list->size(member); ++i) {
            out.open('{');
            write_table(out, child, child.list->at(member, i));
            out.close();
        }
        out.close();
    }
}

}  // namespace

std::string json_string(std::string_view text) {
    constexpr char digits[] = "0123456789abcdef";
    std::string out = "\"";
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\') {
            out += {'\\', c};
        } else if (byte < 0x20 || byte == 0x7f) {
            out += {'\\', 'u', '0', '0', digits[byte >> 4], digits[byte & 15]};
        } else {
            out += c;
        }
    }
    return out + '"';
}

std::string json_value(const Parameter& row, const Value& value) {
    switch (row.kind) {
        case Kind::number:
            return json_number(std::get<double>(value));
        case Kind::integer:
            return std::to_string(std::get<int>(value));
        case Kind::boolean:
            return std::get<bool>(value) ? "true" : "false";
        case Kind::choice: {
            const auto index = static_cast<std::size_t>(std::get<int>(value));
            return index < row.choices.size() ? json_string(row.choices[index]) : "null";
        }
        case Kind::color:
            if (const auto hex = hex_color(std::get<glm::dvec3>(value))) return json_string(*hex);
            [[fallthrough]];
        case Kind::vector: {
            const auto& v = std::get<glm::dvec3>(value);
            return '[' + json_number(v.x) + ", " + json_number(v.y) + ", " + json_number(v.z) + ']';
        }
        case Kind::text:
        case Kind::path:
            return json_string(std::get<std::string>(value));
    }
    return {};
}

void JsonWriter::start_member(std::string_view key) {
    if (!open_.empty()) {
        text_ += is_empty_ ? "\n" : ",\n";
        text_.append(2 * open_.size(), ' ');
    }
    if (!key.empty()) text_ += json_string(key) + ": ";
    is_empty_ = false;
}

void JsonWriter::open(char bracket, std::string_view key) {
    start_member(key);
    text_ += bracket;
    open_ += bracket == '{' ? '}' : ']';
    is_empty_ = true;
}

void JsonWriter::close() {
    assert(!open_.empty());
    const char bracket = open_.back();
    open_.pop_back();
    if (!is_empty_) {
        text_ += '\n';
        text_.append(2 * open_.size(), ' ');
    }
    text_ += bracket;
    if (open_.empty()) text_ += '\n';
    is_empty_ = false;
}

void JsonWriter::value(std::string_view key, std::string_view json) {
    start_member(key);
    text_ += json;
}

std::string write_document(const Format& format, const void* document) {
    JsonWriter out;
    out.open('{');
    out.value("format", json_string(format.format));
    out.value("version", std::to_string(format.version));
    write_table(out, format.table(), const_cast<void*>(document));  // only addresses are taken
    out.close();
    return out.text();
}

void save_document(const Format& format, const void* document, const std::filesystem::path& path) {
    std::vector<Fault> faults = check(format.table(), document);
    for (Fault& fault : faults) fault.file = path.string();
    if (!faults.empty()) throw Error(Failure::bad_input, std::move(faults));
    write_file(path, write_document(format, document));
}

}  // namespace lapfx::preset
