#include "app/tuning/key_titles.h"

#include <charconv>
#include <optional>

#include "app/tuning/parameters.h"
#include "lapfx/authoring/table_walk.h"
#include "lapfx/scene.h"

namespace lapfx::app {

namespace {

constexpr std::string_view in_keys = "abcdefghijklmnopqrstuvwxyz0123456789_.";

std::optional<std::size_t> number(std::string_view text) {
    std::size_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc() && end == text.data() + text.size() ? std::optional(value) : std::nullopt;
}

/// "Event" of "Events": a list is named by what is in it, several times.
std::string singular(std::string_view name) {
    return std::string(name.ends_with('s') ? name.substr(0, name.size() - 1) : name);
}

std::string title_in_scene(std::string_view key) {
    const Table* table = &scene_table();
    std::string owner;
    while (!key.empty()) {
        const std::string_view part = take_part(key);
        if (const Table* const inner = table->find(part)) {
            table = inner, owner = std::string(inner->name);
            if (inner->list == nullptr || key.empty()) continue;
            const std::optional<std::size_t> index = number(take_part(key));
            if (!index) return {};
            owner = singular(owner) + ' ' + std::to_string(*index + 1);  // people count from 1
        } else if (const Parameter* const row = key.empty() ? table->find_row(part) : nullptr) {
            return owner.empty() ? std::string(row->name) : owner + ": " + std::string(row->name);
        } else {
            return {};
        }
    }
    return owner;
}

}  // namespace

std::string title_of(std::string_view key) {
    if (const std::size_t entry = parameters().find(key); entry != no_entry) return parameters()[entry].title;
    return title_in_scene(key);
}

std::string with_titles(std::string_view text) {
    std::string made;
    while (!text.empty()) {
        std::size_t length = std::min(text.find_first_not_of(in_keys), text.size());
        std::string_view word = text.substr(0, length);
        if (word.ends_with('.')) word.remove_suffix(1);  // of the sentence
        // A word without a dot ("blood") is one of the language, though a scene may have a key of that name.
        const std::string title = word.find('.') == std::string_view::npos ? std::string() : title_of(word);
        length = title.empty() ? std::max(length, std::size_t{1}) : word.size();
        made += title.empty() ? std::string(text.substr(0, length)) : title;
        text.remove_prefix(length);
    }
    constexpr std::string_view arrow = " -> ";
    for (std::size_t at = made.find(arrow); at != std::string::npos; at = made.find(arrow, at))
        made.replace(at, arrow.size(), " \u2192 ");
    return made;
}

}  // namespace lapfx::app
