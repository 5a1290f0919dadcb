#include "ui/shell/commands.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "ui/value/closed_list.h"
#include "ui/value/letters.h"
#include "ui/widgets/menu.h"

namespace lapfx::ui {

namespace {

constexpr std::size_t most_recent = 8;

/// Whether a command may have the key. Keys that move the focus, confirm or cancel everywhere are not free.
enum class Binding : std::uint8_t { yes, with_ctrl_or_alt, no };

/// All keys except those whose name is the character on them.
constexpr struct {
    Key key;
    std::string_view name;
    Binding binding = Binding::yes;
} keys[] = {
    {Key::space, "Space"},
    {Key::escape, "Esc", Binding::no},
    {Key::enter, "Enter", Binding::with_ctrl_or_alt},
    {Key::tab, "Tab", Binding::no},
    {Key::insert, "Insert"},
    {Key::del, "Delete"},
    {Key::backspace, "Backspace"},
    {Key::left, "Left"},
    {Key::right, "Right"},
    {Key::up, "Up"},
    {Key::down, "Down"},
    {Key::page_up, "PageUp"},
    {Key::page_down, "PageDown"},
    {Key::home, "Home"},
    {Key::end, "End"},
    {Key::menu, "Menu", Binding::no},
    {Key::f1, "F1"},
    {Key::f2, "F2"},
    {Key::f3, "F3"},
    {Key::f4, "F4"},
    {Key::f5, "F5"},
    {Key::f6, "F6", Binding::no},
    {Key::f7, "F7"},
    {Key::f8, "F8"},
    {Key::f9, "F9"},
    {Key::f10, "F10"},
    {Key::f11, "F11"},
    {Key::f12, "F12"},
};
consteval bool is_listed(Key key) {
    return key == Key::none ||
           std::any_of(std::begin(keys), std::end(keys), [&](const auto& k) { return k.key == key; });
}
template <std::size_t... values>
consteval bool all_listed(std::index_sequence<values...>) {
    return ((!is_enumerator<static_cast<Key>(values)>() || is_listed(static_cast<Key>(values))) && ...);
}
static_assert(all_listed(std::make_index_sequence<512>()));

constexpr struct {
    Mods mod;
    std::string_view name;
} mod_names[] = {
    {Mods::command, "Ctrl"}, {Mods::alt, "Alt"}, {Mods::shift, "Shift"}};  // a chord's text has them in this order

/// Keys whose name is the character on them.
constexpr std::string_view written = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZ',-./;=[]`\\";

Key key_named(std::string_view name) {
    for (const auto& each : keys) {
        if (same_letters(name, each.name)) return each.key;
    }
    const bool known = name.size() == 1 && written.find(static_cast<char>(key_of(name[0]))) != std::string_view::npos;
    return known ? key_of(name[0]) : Key::none;
}

}  // namespace

std::string text_of(const Chord& chord) {
    if (!chord) return {};
    std::string text;
    for (const auto& [mod, name] : mod_names) {
        if (has(chord.mods, mod)) text.append(name) += '+';
    }
    for (const auto& each : keys) {
        if (each.key == chord.key) return text.append(each.name);
    }
    const char name = static_cast<char>(chord.key);
    if (static_cast<int>(chord.key) >= 128 || written.find(name) == std::string_view::npos) return {};
    return text + name;
}

std::optional<Chord> chord_from(std::string_view text) {
    Chord chord;
    for (std::size_t plus = text.find('+'); plus != std::string_view::npos; plus = text.find('+')) {
        const std::string_view word = text.substr(0, plus);
        const auto* one = std::find_if(std::begin(mod_names), std::end(mod_names),
                                       [&](const auto& each) { return same_letters(word, each.name); });
        if (one == std::end(mod_names)) return std::nullopt;
        chord.mods = chord.mods | one->mod;
        text.remove_prefix(plus + 1);
    }
    chord.key = key_named(text);
    if (!chord) return std::nullopt;
    return chord;
}

bool bindable(const Chord& chord) {
    if (!chord) return false;
    const auto* key =
        std::find_if(std::begin(keys), std::end(keys), [&](const auto& each) { return each.key == chord.key; });
    const Binding binding = key == std::end(keys) ? Binding::yes : key->binding;
    const bool plain = !has(chord.mods, Mods::command) && !has(chord.mods, Mods::alt);
    return binding == Binding::yes || (binding == Binding::with_ctrl_or_alt && !plain);
}

void CommandTable::add(Command command) {
    if (command.id.empty() || command.title.empty() || !command.run)
        throw std::invalid_argument("command \"" + command.id + "\": no id, title or run");
    if (contains(command.id)) throw std::invalid_argument("command \"" + command.id + "\" exists already");
    if (command.chord) {
        if (!bindable(command.chord))
            throw std::invalid_argument("command \"" + command.id + "\": " + text_of(command.chord) +
                                        " cannot be bound");
        if (const auto other = bound_to(command.chord))
            throw std::invalid_argument("command \"" + command.id + "\": " + text_of(command.chord) +
                                        " is taken by \"" + entries_[*other].command.id + "\"");
    }
    indices_.emplace(command.id, entries_.size());
    Entry entry{.command = std::move(command), .chord = {}, .full_title = {}, .chord_text = {}};
    const Command& added = entry.command;
    entry.full_title = added.group.empty() ? added.title : added.group + ": " + added.title;
    entries_.push_back(std::move(entry));
    set_chord(entries_.size() - 1, entries_.back().command.chord);
}

std::size_t CommandTable::index_of(std::string_view id) const {
    const auto at = indices_.find(id);
    if (at == indices_.end()) throw std::out_of_range("no command \"" + std::string(id) + "\"");
    return at->second;
}

bool CommandTable::enabled(std::size_t index) const {
    const Command& command = entries_[index].command;
    return !command.enabled || command.enabled();
}

bool CommandTable::checked(std::size_t index) const {
    const Command& command = entries_[index].command;
    return command.checked && command.checked();
}

std::string_view CommandTable::tip(Ui& ui, std::size_t index) const {
    const Command& command = entries_[index].command;
    if (command.missing.empty() || enabled(index)) return command.tip;
    return command.tip.empty() ? std::string_view(command.missing)
                               : ui.join({command.tip, "\nNot now: ", command.missing});
}

bool CommandTable::run(std::size_t index) {
    if (!enabled(index)) return false;
    const auto what = entries_[index].command.run;  // may add commands, which moves the table
    what();
    return true;
}

bool CommandTable::press(Key key, Mods mods) {
    const Chord chord{key, mods};
    auto index = bound_to(chord);
    for (std::size_t i = 0; i < entries_.size() && !index; ++i)
        if (const Chord& other = entries_[i].command.other; other && other == chord) index = i;
    if (!index || run(*index)) return index.has_value();
    if (on_refused) on_refused(entries_[*index].command);
    return false;
}

std::optional<std::size_t> CommandTable::bound_to(const Chord& chord) const {
    if (!chord) return std::nullopt;
    for (std::size_t i = 0; i < entries_.size(); ++i) {
        if (entries_[i].chord == chord) return i;
    }
    return std::nullopt;
}

void CommandTable::set_chord(std::size_t index, const Chord& chord) {
    entries_[index].chord = chord;
    entries_[index].chord_text = text_of(chord);
    ++version_;
}

std::optional<std::size_t> CommandTable::bind(std::size_t index, const Chord& chord, bool take) {
    auto other = bound_to(chord);
    if (other == index) other.reset();
    if (other && !take) return other;
    if (other) set_chord(*other, {});
    set_chord(index, chord);
    return other;
}

void CommandTable::reset_all() {
    for (std::size_t i = 0; i < entries_.size(); ++i) set_chord(i, entries_[i].command.chord);
}

std::string CommandTable::to_json() const {
    nlohmann::ordered_json json = nlohmann::ordered_json::object();
    for (std::size_t i = 0; i < entries_.size(); ++i) {
        if (rebound(i)) json[entries_[i].command.id] = entries_[i].chord_text;
    }
    for (const auto& [id, text] : unknown_) json[id] = text;
    return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

std::vector<std::string> CommandTable::from_json(std::string_view text) {
    const auto json = nlohmann::ordered_json::parse(text, nullptr, false);
    if (!json.is_object()) return {"the file of key bindings is not a JSON object"};
    std::vector<std::string> faults;
    std::vector<std::pair<std::size_t, Chord>> wanted;
    unknown_.clear();
    for (const auto& [id, value] : json.items()) {
        if (!value.is_string()) {
            faults.push_back(id + ": not text");
            continue;
        }
        const auto& name = value.get_ref<const std::string&>();
        const auto chord = name.empty() ? Chord{} : chord_from(name).value_or(Chord{});
        if (!contains(id)) {
            unknown_[id] = name;
        } else if (!name.empty() && !bindable(chord)) {
            faults.push_back(id + ": \"" + name + "\" is not a key that can be bound");
        } else {
            wanted.emplace_back(index_of(id), chord);
        }
    }
    reset_all();
    for (const auto& [index, chord] : wanted) set_chord(index, {});  // two may have changed places
    for (const auto& [index, chord] : wanted) {
        const auto other = bind(index, chord);
        if (other) faults.push_back(full_title(index) + ": " + text_of(chord) + " is taken by " + full_title(*other));
    }
    return faults;
}

void CommandTable::note_recent(std::size_t index) {
    std::erase(recent_, index);
    recent_.insert(recent_.begin(), index);
    if (recent_.size() > most_recent) recent_.pop_back();
}

bool command_item(Ui& ui, CommandTable& table, std::string_view id) {
    const std::size_t index = table.index_of(id);
    const Command& command = table[index];
    const bool chosen = menu_item(ui, command.title,
                                  {.icon = command.icon,
                                   .shortcut = table.chord_text(index),
                                   .tip = table.tip(ui, index),
                                   .enabled = table.enabled(index),
                                   .checked = table.checked(index)});
    return chosen && table.run(index);
}

bool command_button(Ui& ui, CommandTable& table, std::string_view id, bool only_icon) {
    const std::size_t index = table.index_of(id);
    const Command& command = table[index];
    const std::string& keys = table.chord_text(index);
    const std::string_view told = table.tip(ui, index);
    const std::string_view what = told.empty() ? std::string_view(command.title) : told;
    const std::string_view tip = keys.empty() ? ui.copy(what) : ui.join({what, " (", keys, ")"});
    ButtonOptions options{.icon = command.icon, .tip = tip, .quiet = only_icon};
    ui.push_disabled(!table.enabled(index));
    bool clicked = false;
    if (command.checked) {
        bool on = table.checked(index);
        clicked = toggle(ui, command.title, on, options).changed;
    } else {
        clicked =
            only_icon ? icon_button(ui, command.icon, command.title, options) : button(ui, command.title, options);
    }
    ui.pop_disabled();
    return clicked && table.run(index);
}

}  // namespace lapfx::ui
