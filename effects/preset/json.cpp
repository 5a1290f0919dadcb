#include "preset/json.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "lapfx/authoring/utf8.h"
#include "lapfx/error.h"
#include "preset/text.h"

namespace lapfx::preset {

namespace {

[[noreturn]] void fail(std::string_view text, const std::string& name, std::size_t at, std::string reason) {
    const std::string_view before = text.substr(0, at);
    const auto line = std::count(before.begin(), before.end(), '\n') + 1;
    const std::size_t column = count_characters(before.substr(before.rfind('\n') + 1)) + 1;
    throw Error(Failure::bad_input,
                Fault{name, std::to_string(line) + ':' + std::to_string(column), std::move(reason)});
}

/// Builds the tree from the parser's events. Our own, because the library's tree drops duplicate keys
/// silently and knows no limits.
class TreeBuilder : public nlohmann::json_sax<nlohmann::json> {
  public:
    Json root;
    std::string failure;                               ///< set when an event returned false
    std::size_t failure_position = std::string::npos;  ///< npos: not known

    bool null() override { return add({}) != nullptr; }
    bool boolean(bool value) override { return add({.type = Json::Type::boolean, .boolean = value}) != nullptr; }
    bool number_integer(number_integer_t value) override { return add_number(static_cast<double>(value)); }
    bool number_unsigned(number_unsigned_t value) override { return add_number(static_cast<double>(value)); }
    bool number_float(number_float_t value, const string_t&) override { return add_number(value); }
    bool string(string_t& value) override {
        Json* made = add({.type = Json::Type::text});
        if (made) made->text = std::move(value);
        return made != nullptr;
    }
    bool binary(binary_t&) override { return false; }  // never in JSON text
    bool start_object(std::size_t) override { return open(Json::Type::object); }
    bool key(string_t& value) override {
        open_.back()->keys.push_back(std::move(value));
        return true;
    }
    bool end_object() override { return close(); }
    bool start_array(std::size_t) override { return open(Json::Type::list); }
    bool end_array() override { return close(); }
    bool parse_error(std::size_t position, const std::string&, const nlohmann::json::exception& error) override {
        failure_position = position;
        failure = error.what();
        // "[json.exception.parse_error.101] parse error at line 1, column 2: REASON": we place it
        // ourselves.
        if (const auto start = failure.find("] "); start != std::string::npos) failure.erase(0, start + 2);
        if (failure.starts_with("parse error at"))
            if (const auto start = failure.find(": "); start != std::string::npos) failure.erase(0, start + 2);
        failure = shown(failure, 200);
        return false;
    }

  private:
    std::vector<Json*> open_;  ///< objects and lists around the next value; an open one is its parent's last item
    std::size_t values_ = 0;

    Json* add(Json value) {
        if (++values_ > most_values) {
            failure = "more than " + std::to_string(most_values) + " values";
            return nullptr;
        }
        if (open_.empty()) return &(root = std::move(value));
        return &open_.back()->items.emplace_back(std::move(value));
    }
    bool add_number(double value) { return add({.type = Json::Type::number, .number = value}) != nullptr; }
    bool open(Json::Type type) {
        if (open_.size() == deepest_level) {
            failure = "nested deeper than " + std::to_string(deepest_level) + " levels";
            return false;
        }
        Json* made = add({.type = type});
        if (made) open_.push_back(made);
        return made != nullptr;
    }
    bool close() {
        open_.pop_back();
        return true;
    }
};

}  // namespace

const Json* Json::find(std::string_view key) const {
    const auto found = std::find(keys.begin(), keys.end(), key);
    return found == keys.end() ? nullptr : &items[static_cast<std::size_t>(found - keys.begin())];
}

std::string Json::shown() const {
    switch (type) {
        case Type::null:
            return "null";
        case Type::boolean:
            return boolean ? "true" : "false";
        case Type::number:
            return number_text(number);
        case Type::text:
            return in_quotes(text);
        case Type::list:
            return "an array of " + std::to_string(items.size());
        case Type::object:
            return "an object";
    }
    return {};
}

Json parse_json(std::string_view text, const std::string& name) {
    if (text.size() > longest_document)
        throw Error(Failure::bad_input, Fault{name, "",
                                              std::to_string(text.size()) + " bytes; at most " +
                                                  std::to_string(longest_document) + " are read"});
    // Half of the bytes of western text are zero in UTF-16; usually a mark of two bytes comes first.
    const bool utf16 = text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff") ||
                       (text.size() > 1 && (text[0] == '\0') != (text[1] == '\0'));
    if (utf16) throw Error(Failure::bad_input, Fault{name, "", "is UTF-16 text; JSON is read as UTF-8"});
    // The parser takes a zero byte for the end of the text and would ignore what follows.
    if (const auto zero = text.find('\0'); zero != std::string_view::npos) fail(text, name, zero, "a zero byte");
    TreeBuilder builder;
    if (nlohmann::json::sax_parse(text.begin(), text.end(), &builder)) return std::move(builder.root);
    if (builder.failure_position == std::string::npos)
        throw Error(Failure::bad_input, Fault{name, "", builder.failure});
    // The position counts the character that was wrong, or the end of the text, as read.
    const std::size_t at = std::min(text.size(), std::max<std::size_t>(builder.failure_position, 1) - 1);
    fail(text, name, at, builder.failure);
}

}  // namespace lapfx::preset
