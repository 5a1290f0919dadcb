// The JSON Schema (draft-07) of a document, for editors and validators outside lapfx.
#include "preset/document.h"
#include "preset/json_write.h"
#include "preset/text.h"

namespace lapfx::preset {

namespace {

std::string describe(const Parameter& row) {
    std::string out(row.name);
    if (!row.unit.empty()) out += " (" + std::string(row.unit) + ')';
    out += ". " + std::string(row.help);
    if (!row.same_as.empty()) out += " Default: as \"" + std::string(row.same_as) + "\".";
    return out;
}

void write_range(JsonWriter& out, const Parameter& row) {
    out.value("minimum", number_text(row.minimum));
    out.value("maximum", number_text(row.maximum));
}

/// An array of three numbers in the row's range.
void write_triple(JsonWriter& out, const Parameter& row) {
    out.value("type", "\"array\"");
    out.value("minItems", "3");
    out.value("maxItems", "3");
    out.open('{', "items");
    out.value("type", "\"number\"");
    write_range(out, row);
    out.close();
}

void write_color(JsonWriter& out, const Parameter& row) {
    out.open('[', "oneOf");
    out.open('{');
    out.value("type", "\"string\"");
    out.value("pattern", json_string("^#[0-9a-fA-F]{6}$"));
    out.close();
    out.open('{');
    write_triple(out, row);
    out.close();
    out.close();
}

void write_type(JsonWriter& out, const Parameter& row) {
    switch (row.kind) {
        case Kind::number:
            out.value("type", "\"number\"");
            write_range(out, row);
            break;
        case Kind::integer:
            out.value("type", "\"integer\"");
            write_range(out, row);
            break;
        case Kind::boolean:
            out.value("type", "\"boolean\"");
            break;
        case Kind::choice:
            out.value("type", "\"string\"");
            out.open('[', "enum");
            for (const std::string_view name : row.choices) out.value({}, json_string(name));
            out.close();
            break;
        case Kind::color:
            write_color(out, row);
            break;
        case Kind::vector:
            write_triple(out, row);
            break;
        case Kind::path:
            out.value("type", "\"string\"");
            if (row.required) out.value("minLength", "1");
            out.value("maxLength", number_text(row.maximum));
            break;
        case Kind::text:
            out.value("type", "\"string\"");
            out.value("maxLength", number_text(row.maximum));
            break;
    }
}

void write_row(JsonWriter& out, const Parameter& row, const void* owner) {
    out.open('{', row.key);
    write_type(out, row);
    if (!row.required && row.same_as.empty()) out.value("default", json_value(row, row.get(owner)));
    out.value("description", json_string(describe(row)));
    out.close();
}

/// Something in the object must be given, so the object must be there. An absent list is just empty.
bool is_required(const Table& table) {
    for (const Parameter& row : table.rows)
        if (row.required) return true;
    for (const Table& child : table.tables)
        if (!child.list && is_required(child)) return true;
    return false;
}

void write_table(JsonWriter& out, const Table& table, void* owner);

void write_child(JsonWriter& out, const Table& child, void* member) {
    out.open('{', child.key);
    if (!child.list) {
        write_table(out, child, member);
    } else {
        out.value("type", "\"array\"");
        out.value("description", json_string(std::string(child.name) + ". " + std::string(child.help)));
        out.value("maxItems", std::to_string(child.list->maximum));
        child.list->resize(member, 1);  // a new element has the defaults
        out.open('{', "items");
        write_table(out, child, child.list->at(member, 0));
        out.close();
    }
    out.close();
}

/// The keywords of an object; the root has "format" and "version" too.
void write_members(JsonWriter& out, const Table& table, void* owner, const Format* root) {
    out.value("additionalProperties", "false");
    out.open('[', "required");
    if (root) out.value({}, "\"format\"");
    if (root) out.value({}, "\"version\"");
    for (const Parameter& row : table.rows)
        if (row.required) out.value({}, json_string(row.key));
    for (const Table& child : table.tables)
        if (!child.list && is_required(child)) out.value({}, json_string(child.key));
    out.close();
    out.open('{', "properties");
    if (root) {
        out.open('{', "format");
        out.value("const", json_string(root->format));
        out.close();
        out.open('{', "version");
        out.value("type", "\"integer\"");
        out.value("minimum", "1");
        out.value("maximum", std::to_string(root->version));
        out.close();
    }
    for (const Parameter& row : table.rows) write_row(out, row, owner);
    for (const Table& child : table.tables) write_child(out, child, child.member(owner));
    out.close();
}

void write_table(JsonWriter& out, const Table& table, void* owner) {
    out.value("type", "\"object\"");
    out.value("description", json_string(std::string(table.name) + ". " + std::string(table.help)));
    write_members(out, table, owner, nullptr);
}

}  // namespace

std::string write_schema(const Format& format, void* defaults) {
    JsonWriter out;
    out.open('{');
    out.value("$schema", "\"http://json-schema.org/draft-07/schema#\"");
    out.value("title", json_string(format.title));
    out.value("description", json_string(format.help));
    out.value("type", "\"object\"");
    write_members(out, format.table(), defaults, &format);
    out.close();
    return out.text();
}

}  // namespace lapfx::preset
