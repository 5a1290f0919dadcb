#include "ui/widgets/editing.h"

#include <optional>

#include "ui/core/node.h"
#include "ui/widgets/field.h"
#include "ui/widgets/menu.h"

namespace lapfx::ui {

namespace {

constexpr std::string_view menu_kind = "text menu ";
constexpr double blink = 0.53;             // s that the caret is visible, and then as long hidden
constexpr double blinks_for = 20 * blink;  // s after the last input; after that the machine may sleep

struct KeyCommand {
    Key key;
    TextCommand plain, with_shift, with_command, with_both;
};
constexpr KeyCommand key_commands[] = {
    {Key::left, TextCommand::left, TextCommand::select_left, TextCommand::word_left, TextCommand::select_word_left},
    {Key::right, TextCommand::right, TextCommand::select_right, TextCommand::word_right,
     TextCommand::select_word_right},
    {Key::home, TextCommand::text_start, TextCommand::select_text_start, TextCommand::text_start,
     TextCommand::select_text_start},
    {Key::end, TextCommand::text_end, TextCommand::select_text_end, TextCommand::text_end,
     TextCommand::select_text_end},
    {Key::backspace, TextCommand::erase_left, TextCommand::erase_left, TextCommand::erase_word_left,
     TextCommand::erase_word_left},
    {Key::del, TextCommand::erase_right, TextCommand::erase_right, TextCommand::erase_word_right,
     TextCommand::erase_word_right},
};

std::optional<TextCommand> command_of(const Event& event) {
    const bool shift = has(event.mods, Mods::shift), command = has(event.mods, Mods::command);
    for (const KeyCommand& each : key_commands) {
        if (each.key != event.key) continue;
        return command ? (shift ? each.with_both : each.with_command) : (shift ? each.with_shift : each.plain);
    }
    return std::nullopt;
}

}  // namespace

void Editing::open(Ui& ui, const std::string& text, const EditingRules& rules) {
    rules_ = rules;
    original_ = given_ = text;
    edit = TextEdit(text, rules.bytes);
    known_ = hash_bytes(0, edit.text());
    edit.apply(TextCommand::select_all);
    began_ = false;
    touch(ui);
}

void Editing::follow(Ui& ui, const std::string& text) {
    if (text == given_) return;
    given_ = original_ = text;
    edit.reset(text);
    known_ = hash_bytes(0, edit.text());
    began_ = false;
    touch(ui);
}

Edit Editing::close() {
    const Edit result{.committed = began_};
    *this = {};  // frees the history, which may be large
    return result;
}

void Editing::changed(Ui& ui, std::string& text, Edit& result) {
    touch(ui);
    const std::uint64_t now = hash_bytes(0, edit.text());  // not `text`, which may have characters that are left out
    if (now == known_) return;
    known_ = now;
    text = given_ = edit.text();
    result.began |= !began_;
    result.changed = true;
    began_ = true;
}

void Editing::replace(Ui& ui, std::string_view with, std::string& text, Edit& result) {
    edit.replace(std::string(with));
    changed(ui, text, result);
}

void Editing::escape(Ui& ui, std::string& text, Edit& result) {
    if (rules_.escape_empties && !text.empty() && !rules_.read_only) {
        replace(ui, {}, text, result);
        result.committed = true;
        began_ = false;
        original_ = given_;
        return;
    }
    if (began_) {
        edit.replace(original_);
        known_ = hash_bytes(0, edit.text());
        text = given_ = original_;
        began_ = false;
        result.changed = result.cancelled = true;
        return touch(ui);
    }
    const Node* field = ui.before(ui.focus());
    field != nullptr && field->layer > 0 ? ui.close_top_overlay() : ui.set_focus(0);
}

bool Editing::take(Ui& ui, const Event& event, std::string& text, Edit& result) {
    if (event.kind == EventKind::text) {
        if (rules_.read_only || has(event.mods, Mods::command)) return false;
        edit.insert(event.codepoint);
        changed(ui, text, result);
        return true;
    }
    return event.kind == EventKind::key && take_key(ui, event, text, result);
}

bool Editing::take_key(Ui& ui, const Event& event, std::string& text, Edit& result) {
    if (event.key == Key::escape) {
        if (!rules_.keys_outside) escape(ui, text, result);
        return !rules_.keys_outside;
    }
    if (event.key == Key::enter) {
        if (rules_.keys_outside) return false;
        result.committed |= began_;
        began_ = false;
        original_ = given_;
        return true;
    }
    if (const auto command = command_of(event)) {
        const bool erases = event.key == Key::backspace || event.key == Key::del;
        if (!erases || !rules_.read_only) edit.apply(*command);
    } else if (!has(event.mods, Mods::command) || !take_shortcut(ui, event)) {
        return false;
    }
    changed(ui, text, result);
    return true;
}

/// Handles undo, redo and the clipboard. If the field has nothing to undo, the program gets the key.
bool Editing::take_shortcut(Ui& ui, const Event& event) {
    Clipboard* clipboard = ui.clipboard();
    const bool redo = event.key == key_of('Y') || (event.key == key_of('Z') && has(event.mods, Mods::shift));
    if (redo || event.key == key_of('Z')) {
        const bool can = !rules_.read_only && (redo ? edit.can_redo() : edit.can_undo());
        if (can) return edit.apply(redo ? TextCommand::redo : TextCommand::undo);
        ui.press_shortcut(event.key, event.mods);
        return false;
    }
    if (event.key == key_of('A')) return edit.apply(TextCommand::select_all), true;
    if (clipboard == nullptr) return false;
    if (event.key == key_of('V')) return !rules_.read_only && edit.insert(clipboard->get());
    if (event.key != key_of('C') && event.key != key_of('X')) return false;
    if (edit.selected().empty()) return false;  // copying nothing must not empty the clipboard
    clipboard->set(std::string(edit.selected()));
    if (event.key == key_of('X') && !rules_.read_only) edit.apply(TextCommand::erase_left);
    return true;
}

void Editing::press(Ui& ui, const Event& event, std::size_t byte) {
    touch(ui);
    edit.place(byte, has(event.mods, Mods::shift));
    if (event.clicks == 2) edit.apply(TextCommand::select_word);
    if (event.clicks == 3) edit.apply(TextCommand::select_all);
}

bool Editing::menu_open(Ui& ui, Id id) {
    return ui.overlay_count() > 0 && ui.overlay_open(overlay_name(ui, menu_kind, id));
}

void Editing::menu(Ui& ui, Id id, std::string_view label, const Response& r, std::string& text, Edit& result) {
    if (!r.context && ui.overlay_count() == 0) return;
    const std::string_view name = overlay_name(ui, menu_kind, id);
    if (r.context) {
        using Side = Placement::Side;
        bool by_key = false;
        ui.events_of(id, [&](const Event& event) { by_key |= event.kind == EventKind::key; });
        open_menu(ui, name,
                  by_key ? Placement{.side = Side::below, .anchor = id}
                         : Placement{.side = Side::pointer, .rect = {r.pointer.x, r.pointer.y, 0, 0}});
    }
    Menu menu(ui, name, ui.join({label, " menu"}));
    if (!menu) return;
    const bool board = ui.clipboard() != nullptr, selected = board && !edit.selected().empty();
    const auto item = [&](std::string_view item_name, Icon icon, std::string_view shortcut, bool enabled) {
        if (!menu_item(ui, item_name, {.icon = icon, .shortcut = shortcut, .enabled = enabled})) return;
        take_key(ui, {.kind = EventKind::key, .mods = Mods::command, .key = key_of(shortcut.back())}, text, result);
    };
    item("Cut", Icon::none, "Ctrl+X", selected && !rules_.read_only);
    item("Copy", Icon::copy, "Ctrl+C", selected);
    item("Paste", Icon::none, "Ctrl+V", board && !rules_.read_only);
    item("Select all", Icon::none, "Ctrl+A", !edit.text().empty());
}

bool Editing::caret_shown(Ui& ui) const {
    const double since = std::max(0.0, ui.time() - active_);
    if (ui.options().reduced_motion || since >= blinks_for) return true;
    const double turn = std::floor(since / blink + 1e-6);  // a wake-up exactly at a turn counts as after it
    ui.wake_at(active_ + (turn + 1) * blink, "caret");
    return static_cast<long>(turn) % 2 == 0;
}

float drag_scroll_speed(const Ui& ui, float beyond) {
    return std::clamp(beyond * 8, -ui.em(80), ui.em(80));
}

}  // namespace lapfx::ui
