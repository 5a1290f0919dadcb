// The commands of the program, each declared once: menus, buttons, palette, key editor, cheat sheet, shortcuts, scripts
// and tests all read this table.
//
//     ui::CommandTable commands;
//     commands.add({.id = "file.save", .title = "Save", .group = "File", .chord = {ui::key_of('S'), ui::Mods::command},
//                   .run = [&] { document.save(); }, .enabled = [&] { return document.changed(); }});
//     ui::Ui ui(fonts, {.shortcuts = &commands});
//     ...
//     ui::command_item(u, commands, "file.save");  // in a menu
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "ui/core/ui.h"
#include "ui/widgets/basic.h"

namespace lapfx::ui {

/// A key with those held beside it.
struct Chord {
    Key key = Key::none;
    Mods mods = Mods::none;
    explicit operator bool() const { return key != Key::none; }
    friend bool operator==(const Chord&, const Chord&) = default;
};
/// "Ctrl+Shift+S"; no key: "".
std::string text_of(const Chord& chord);
/// The other way; case and the order of Ctrl, Shift and Alt do not matter. Nothing when it is no chord.
std::optional<Chord> chord_from(std::string_view text);
/// Whether a command may have this chord: not the keys that move the focus, confirm or cancel everywhere. Space is
/// allowed, because a button with the keyboard takes it before any command.
bool bindable(const Chord& chord);

struct Command {
    std::string id{};     ///< "file.save": for files and scripts, never changed
    std::string title{};  ///< "Save"
    std::string group{};  ///< "File"
    Chord chord{};        ///< the standard one; may be none
    Chord other{};  ///< runs the command as well, unless another command is bound to it; for habits from other programs
    Icon icon = Icon::none;
    std::function<void()> run{};
    std::function<bool()> enabled{};  ///< empty: always
    std::function<bool()> checked{};  ///< empty: nothing that is on or off
    std::string tip{};
    /// What is missing while it is not enabled, for its tooltip then: "Nothing is selected".
    std::string missing{};
};

class CommandTable : public Shortcuts {
  public:
    /// Throws std::invalid_argument for a mistake of the program: an id or a standard chord that is taken, no title,
    /// nothing to run.
    void add(Command command);

    std::size_t size() const { return entries_.size(); }
    const Command& operator[](std::size_t index) const { return entries_[index].command; }
    /// The index of the command with this id. Throws std::out_of_range, with the id, when there is none.
    std::size_t index_of(std::string_view id) const;
    bool contains(std::string_view id) const { return indices_.find(id) != indices_.end(); }
    /// "File: Save", for lists of all.
    const std::string& full_title(std::size_t index) const { return entries_[index].full_title; }
    bool enabled(std::size_t index) const;
    bool checked(std::size_t index) const;
    /// Its tip; while it is not enabled, with what is missing. Valid for the frame of `ui`.
    std::string_view tip(Ui& ui, std::size_t index) const;
    /// Returns whether it ran: not when it is disabled.
    bool run(std::size_t index);
    bool run(std::string_view id) { return run(index_of(id)); }
    /// As run(). A chord of a command that is not enabled is told to `on_refused`, since nothing else says so.
    bool press(Key key, Mods mods) override;
    std::function<void(const Command&)> on_refused{};

    const Chord& chord(std::size_t index) const { return entries_[index].chord; }
    const std::string& chord_text(std::size_t index) const { return entries_[index].chord_text; }
    std::optional<std::size_t> bound_to(const Chord& chord) const;
    /// Binds, or unbinds with no key. When another command has the chord, gives that one: it loses it if `take`, else
    /// nothing is changed.
    std::optional<std::size_t> bind(std::size_t index, const Chord& chord, bool take = false);
    bool rebound(std::size_t index) const { return entries_[index].chord != entries_[index].command.chord; }
    /// To its standard; the same answer as bind().
    std::optional<std::size_t> reset(std::size_t index, bool take = false) {
        return bind(index, entries_[index].command.chord, take);
    }
    void reset_all();

    /// The bindings that differ from the standard: {"file.save": "Ctrl+Alt+S", "view.grid": ""}.
    std::string to_json() const;
    /// Replaces all bindings; commands that are not named get their standard chord. Returns messages about what could
    /// not be used. Unknown commands are kept for to_json(), since they may belong to a newer version. If the text is
    /// not JSON, nothing is changed.
    std::vector<std::string> from_json(std::string_view text);

    /// Indices of what was run from the palette, the newest first, 8 at most.
    const std::vector<std::size_t>& recent() const { return recent_; }
    void note_recent(std::size_t index);
    /// Grows with every change of commands and bindings.
    std::uint32_t version() const { return version_; }

  private:
    struct Entry {
        Command command;
        Chord chord;
        std::string full_title, chord_text;
    };
    void set_chord(std::size_t index, const Chord& chord);

    std::vector<Entry> entries_;
    std::map<std::string, std::size_t, std::less<>> indices_;
    std::map<std::string, std::string> unknown_;
    std::vector<std::size_t> recent_;
    std::uint32_t version_ = 0;
};

/// In a menu: title, icon, chord and mark of the command; chosen, it runs. Returns whether it ran.
bool command_item(Ui& ui, CommandTable& table, std::string_view id);
/// A button, or a toggle where the command can be on. Its tooltip tells title and chord. Without text when `only_icon`.
bool command_button(Ui& ui, CommandTable& table, std::string_view id, bool only_icon = false);

}  // namespace lapfx::ui
