// The strict reader: JSON tree to struct along a table, collecting every fault.
#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "lapfx/error.h"
#include "preset/colors.h"
#include "preset/document.h"
#include "preset/text.h"

namespace lapfx::preset {

namespace {

/// Thrown when the list of faults is full.
struct TooManyFaults {};

class Reader {
  public:
    Reader(const Format& format, const std::string& name) : format_(format), name_(name) {}

    void read(const Json& json, void* document) {
        try {
            if (json.type != Json::Type::object) {
                add("", json.shown() + "; expected an object with \"format\": " + in_quotes(format_.format));
            } else if (check_format(json)) {
                read_object(format_.table(), &json, document, "");
            }
        } catch (const TooManyFaults&) {
            faults_.push_back(
                {name_, "", "more than " + std::to_string(most_faults) + " faults; the rest is not listed"});
        }
        if (!faults_.empty()) throw Error(Failure::bad_input, std::move(faults_));
    }

  private:
    const Format& format_;
    const std::string& name_;
    std::vector<Fault> faults_;

    void add(std::string pointer, std::string reason) {
        if (faults_.size() == most_faults) throw TooManyFaults{};
        faults_.push_back({name_, std::move(pointer), std::move(reason)});
    }

    bool check_format(const Json& json);
    bool check_version(const Json& json);
    void check_keys(const Table& table, const Json& object, const std::string& pointer);
    void read_row(const Parameter& row, const Json* value, void* owner, const std::string& pointer);
    void read_rows(const Table& table, const Json* object, void* owner, const std::string& pointer);
    void read_object(const Table& table, const Json* object, void* owner, const std::string& pointer);
    void read_list(const Table& table, const Json& list, void* member, const std::string& pointer);
};

/// False when the document is of another kind: its other faults would only confuse.
bool Reader::check_format(const Json& json) {
    const Json* found = json.find("format");
    if (!found) {
        add("/format", "missing; expected " + in_quotes(format_.format));
    } else if (found->type != Json::Type::text || found->text != format_.format) {
        add("/format", found->shown() + " is not " + in_quotes(format_.format));
        return false;
    }
    return check_version(json);
}

bool Reader::check_version(const Json& json) {
    const std::string newest = std::to_string(format_.version);
    const Json* found = json.find("version");
    if (!found) {
        add("/version", "missing; expected a whole number from 1 to " + newest);
    } else if (found->type != Json::Type::number || found->number != std::floor(found->number) || found->number < 1) {
        add("/version", found->shown() + " is not a whole number from 1 to " + newest);
    } else if (found->number > format_.version) {
        add("/version", "version " + found->shown() + " is newer than this program reads (" + newest + ')');
        return false;
    }
    return true;
}

void Reader::check_keys(const Table& table, const Json& object, const std::string& pointer) {
    std::vector<std::string_view> known;
    if (pointer.empty()) known = {"format", "version"};
    for (const Parameter& row : table.rows) known.push_back(row.key);
    for (const Table& child : table.tables) known.push_back(child.key);

    std::set<std::string_view> seen;
    for (const std::string& key : object.keys) {
        if (!seen.insert(key).second) {
            add(join_pointer(pointer, key), "this key is there twice");
        } else if (std::find(known.begin(), known.end(), key) == known.end()) {
            const std::string_view best = nearest(key, known);
            add(join_pointer(pointer, key),
                best.empty() ? "unknown key; no keys are allowed here" : "unknown key; nearest is " + in_quotes(best));
        }
    }
}

std::optional<glm::dvec3> read_vector(const Json& json) {
    if (json.type != Json::Type::list || json.items.size() != 3) return {};
    glm::dvec3 value;
    for (int i = 0; i < 3; ++i) {
        const Json& item = json.items[static_cast<std::size_t>(i)];
        if (item.type != Json::Type::number) return {};
        value[i] = item.number;
    }
    return value;
}

/// The value in the row's type; nothing when the JSON type does not fit.
std::optional<Value> read_value(const Parameter& row, const Json& json) {
    const bool is_number = json.type == Json::Type::number;
    const bool is_text = json.type == Json::Type::text;
    switch (row.kind) {
        case Kind::number:
            if (is_number) return json.number;
            return {};
        case Kind::integer:
            // 3.0 is a whole number (JSON Schema says so too); what does not fit an int is out of every
            // range.
            if (is_number && json.number == std::floor(json.number) && std::abs(json.number) <= 2147483647.0)
                return static_cast<int>(json.number);
            return {};
        case Kind::boolean:
            if (json.type == Json::Type::boolean) return json.boolean;
            return {};
        case Kind::choice: {
            const auto found = std::find(row.choices.begin(), row.choices.end(), json.text);
            if (is_text && found != row.choices.end()) return static_cast<int>(found - row.choices.begin());
            return {};
        }
        case Kind::color:
            if (is_text)
                if (const auto value = read_hex_color(json.text)) return *value;
            [[fallthrough]];
        case Kind::vector:
            if (const auto value = read_vector(json)) return *value;
            return {};
        case Kind::text:
        case Kind::path:
            if (is_text) return json.text;
            return {};
    }
    return {};
}

void Reader::read_row(const Parameter& row, const Json* json, void* owner, const std::string& pointer) {
    if (!json) {
        if (row.required) add(join_pointer(pointer, row.key), "missing; expected " + row.expected());
        return;
    }
    const std::optional<Value> value = read_value(row, *json);
    if (!value) {
        std::string reason = json->shown() + " is not " + row.expected();
        if (row.kind == Kind::choice && json->type == Json::Type::text)
            reason += "; nearest is " + in_quotes(nearest(json->text, row.choices));
        add(join_pointer(pointer, row.key), std::move(reason));
    } else if (std::string reason = row.check(*value); !reason.empty()) {
        add(join_pointer(pointer, row.key), std::move(reason));
    } else {
        row.set(owner, *value);
    }
}

void Reader::read_rows(const Table& table, const Json* object, void* owner, const std::string& pointer) {
    const std::size_t before = faults_.size();
    const auto find = [&](std::string_view key) { return object ? object->find(key) : nullptr; };
    for (const Parameter& row : table.rows) read_row(row, find(row.key), owner, pointer);
    if (faults_.size() != before) return;  // a rule between values says nothing useful when one of them was refused
    for (const Parameter& row : table.rows)
        if (!row.same_as.empty() && !find(row.key)) row.set(owner, table.find_row(row.same_as)->get(owner));
    for (const Rule& rule : table.rules)
        if (std::string reason = rule.check(owner); !reason.empty())
            add(join_pointer(pointer, rule.key), std::move(reason));
}

/// `object` null: the key is absent. Its rows are visited all the same, since one of them may be required.
void Reader::read_object(const Table& table, const Json* object, void* owner, const std::string& pointer) {
    if (object && object->type != Json::Type::object) {
        add(pointer, object->shown() + " is not an object");
        return;
    }
    if (object) check_keys(table, *object, pointer);
    read_rows(table, object, owner, pointer);
    for (const Table& child : table.tables) {
        const Json* value = object ? object->find(child.key) : nullptr;
        const std::string inner = join_pointer(pointer, child.key);
        void* member = child.member(owner);
        if (child.present) *child.present(owner) = value != nullptr;
        if (!child.list) {
            read_object(child, value, member, inner);
        } else if (value) {
            read_list(child, *value, member, inner);
        }
    }
}

void Reader::read_list(const Table& table, const Json& list, void* member, const std::string& pointer) {
    if (list.type != Json::Type::list) {
        add(pointer, list.shown() + " is not an array");
        return;
    }
    if (list.items.size() > table.list->maximum) {
        add(pointer, too_many(list.items.size(), table.list->maximum));
        return;
    }
    table.list->resize(member, list.items.size());
    const std::size_t before = faults_.size();
    for (std::size_t i = 0; i < list.items.size(); ++i)
        read_object(table, &list.items[i], table.list->at(member, i), join_pointer(pointer, std::to_string(i)));
    if (table.order == nullptr || faults_.size() != before) return;
    for (std::size_t i = 1; i < list.items.size(); ++i)
        if (std::string reason = table.order->check(table.list->at(member, i - 1), table.list->at(member, i));
            !reason.empty())
            add(join_pointer(join_pointer(pointer, std::to_string(i)), table.order->key), std::move(reason));
}

}  // namespace

void read_document(const Format& format, const Json& json, const std::string& name, void* document) {
    Reader(format, name).read(json, document);
}

}  // namespace lapfx::preset
