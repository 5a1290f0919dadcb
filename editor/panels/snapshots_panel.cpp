// Snapshots A to D of the preset: kept, shown with one key, and compared in words.
#include "app/snapshots.h"

#include "app/editor.h"
#include "app/layouts.h"
#include "document/words.h"
#include "panels/panels.h"
#include "ui/shell/file_system.h"
#include "ui/widgets/scroll.h"
#include "ui/widgets/table.h"

namespace lapfx::panels {

namespace {

using app::Snapshots;
using ui::key_of;
using ui::Mods;

constexpr int now = static_cast<int>(Snapshots::count);
constexpr std::array<std::string_view, Snapshots::count + 1> sides = {"A", "B", "C", "D", "Now"};

// em: widths of the panel below which rows leave things out, and the height below which it scrolls.
constexpr float whole_row = 24, named_row = 17, worded_row = 16, whole_height = 24, least_table = 9;

/// Names of the four slots, for these versions; with the file where it is another one than the document's.
struct SlotNames {
    std::uint64_t snapshots = 0, document = 0;
    std::array<std::string, Snapshots::count> name;
    std::array<bool, Snapshots::count> other{};
};

struct SnapshotsState {
    SlotNames names;
    int left = 0, right = now;
    ui::TableState table;
    std::vector<document::Difference> differences;
    // What was compared to find them.
    int compared_left = -1, compared_right = -1;
    std::uint64_t document = 0, snapshots = 0;
    std::string text;
};

bool there(const Snapshots& snapshots, int side) {
    return side == now || snapshots.at(static_cast<std::size_t>(side)).has_value();
}

Preset preset_of(const Snapshots& snapshots, const document::Document& document, int side) {
    return side == now ? document.preset() : snapshots.preset(static_cast<std::size_t>(side));
}

void compare(const Snapshots& snapshots, const document::Document& document, SnapshotsState& s) {
    if (s.compared_left == s.left && s.compared_right == s.right && s.document == document.version() &&
        s.snapshots == snapshots.version())
        return;
    s.compared_left = s.left;
    s.compared_right = s.right;
    s.document = document.version();
    s.snapshots = snapshots.version();
    s.differences.clear();
    if (there(snapshots, s.left) && there(snapshots, s.right))
        s.differences =
            document::differences(preset_of(snapshots, document, s.left), preset_of(snapshots, document, s.right));
}

void follow_names(const Snapshots& snapshots, const document::Document& document, SlotNames& names) {
    if (names.snapshots == snapshots.version() && names.document == document.version()) return;
    names.snapshots = snapshots.version();
    names.document = document.version();
    for (std::size_t slot = 0; slot < Snapshots::count; ++slot) {
        if (!snapshots.at(slot)) continue;
        const std::string& name = snapshots.at(slot)->preset.name;
        const std::string other = snapshots.other_file(slot);
        names.other[slot] = !other.empty();
        names.name[slot] = name.empty() ? "unnamed" : name;
        if (!other.empty()) names.name[slot] += ", of " + other;
    }
}

/// The name of the kept preset, and of its file where that is another one than the one that is open.
void name_of(ui::Ui& ui, const SlotNames& names, const Snapshots& snapshots, std::size_t slot) {
    if (!snapshots.at(slot)) return ui::label(ui, "empty", {.tone = ui::Tone::dim, .width = ui::grow()});
    ui::label(ui, names.name[slot],
              {.tone = names.other[slot] ? ui::Tone::warning : ui::Tone::normal, .width = ui::grow()});
}

void slot_row(ui::Ui& ui, Snapshots& snapshots, SnapshotsState& state, std::size_t slot, float room) {
    const auto& snapshot = snapshots.at(slot);
    const std::string letter = Snapshots::names[slot];
    const bool timed = room >= ui.em(whole_row), named = room >= ui.em(named_row);
    const auto slot_button = [&](ui::Icon icon, std::string_view label, ui::ButtonOptions options) {
        options.quiet = room < ui.em(worded_row);
        return options.quiet ? ui::icon_button(ui, icon, label, options) : ui::button(ui, label, options);
    };
    const ui::Size button_width = named ? ui::px(ui.em(5.2F)) : ui::grow();
    ui.push_seed(letter);
    {
        const ui::Row row(ui, {.width = ui::grow(), .gap = 0.4F, .cross = ui::ChildAlign::center});
        if (room < ui.em(worded_row)) ui::label(ui, letter, {.width = ui::grow()});
        ui.push_disabled(!snapshot);
        const bool show =
            slot_button(ui::Icon::eye, ui.join({"Show ", letter}),
                        {.tip = "Sets the preset to this snapshot, as one undo step. A second click goes back.",
                         .on = snapshots.shown(slot),
                         .width = button_width});
        ui.pop_disabled();
        if (show) snapshots.show(slot);
        if (snapshot) ui::date_text(snapshot->time, state.text);
        if (named) name_of(ui, state.names, snapshots, slot);
        if (snapshot && timed)
            ui::label(ui, state.text.substr(state.text.find(' ') + 1), {.tone = ui::Tone::dim, .number = true});
        if (slot_button(
                ui::Icon::plus, ui.join({"Keep ", letter}),
                {.tip = snapshot ? "Replaces this snapshot with the current preset." : "Keeps the current preset.",
                 .width = button_width}))
            snapshots.keep(slot);
        ui.push_disabled(!snapshots.at(slot).has_value());
        if (ui::icon_button(ui, ui::Icon::cross, "Clear " + letter, {.quiet = true})) snapshots.clear(slot);
        ui.pop_disabled();
    }
    ui.pop_seed();
}

/// Takes a value of the left side into the preset, as one step.
void take(const Snapshots& snapshots, document::Document& document, const SnapshotsState& state,
          const document::Difference& difference) {
    const Preset source = preset_of(snapshots, document, state.left);
    for (const document::Difference& d : document::differences(source, document.preset())) {
        if (d.kind != difference.kind || d.before_at != difference.before_at) continue;
        const std::string from = std::string(sides[static_cast<std::size_t>(state.left)]);
        document.change(d.row + " of snapshot " + from,
                        [&](document::Content& c) { document::take_back(c.preset, source, d); });
        return;
    }
}

ui::TableCell cell_of(const document::Difference& d, std::size_t column) {
    using Kind = document::Difference::Kind;
    if (column == 0) return {.text = d.name};
    const std::string& text = column == 1 ? d.before : d.after;
    const bool missing = (d.kind == Kind::added && column == 1) || (d.kind == Kind::removed && column == 2);
    return {.text = missing ? std::string_view("missing") : std::string_view(text),
            .tone = missing ? ui::Tone::dim : ui::Tone::normal};
}

void difference_table(ui::Ui& ui, const Snapshots& snapshots, document::Document& document, SnapshotsState& s,
                      ui::Size height) {
    const auto left = static_cast<std::size_t>(s.left), right = static_cast<std::size_t>(s.right);
    const std::array columns = {
        ui::TableColumn{"Parameter", 13, ui::Align::start, false},
        ui::TableColumn{sides[left], 6, ui::Align::start, false},
        ui::TableColumn{s.left == s.right ? "the same" : sides[right], 6, ui::Align::start, false}};
    const auto events = ui::table(
        ui, "Differences", s.table, columns, s.differences.size(),
        [&](std::size_t row, std::size_t column) { return cell_of(s.differences[row], column); }, {.height = height});
    std::size_t row = events.opened;
    if (events.selected && ui.held() != 0) row = events.hovered;  // the arrow keys only select
    if (s.left == now || row == ui::no_row) return;
    take(snapshots, document, s, s.differences[row]);
    s.table.selection.clear();
    ui.build_again();
}

void sides_row(ui::Ui& ui, SnapshotsState& s, float room) {
    if (room >= ui.em(whole_row)) {
        const ui::Row row(ui, {.width = ui::grow(), .gap = 0.6F, .cross = ui::ChildAlign::center});
        ui::segmented(ui, "Compare", s.left, sides);
        ui::label(ui, "against", {.tone = ui::Tone::dim});
        ui::segmented(ui, "Against", s.right, sides);
        return;
    }
    {
        const ui::Row row(ui, {.width = ui::grow()});
        ui::segmented(ui, "Compare", s.left, sides);
    }
    ui::label(ui, "against", {.tone = ui::Tone::dim});
    const ui::Row row(ui, {.width = ui::grow()});
    ui::segmented(ui, "Against", s.right, sides);
}

void comparison(ui::Ui& ui, const Snapshots& snapshots, document::Document& document, SnapshotsState& s, float room,
                ui::Size table_height) {
    sides_row(ui, s, room);
    compare(snapshots, document, s);
    for (const int side : {s.left, s.right}) {
        if (there(snapshots, side)) continue;
        const std::string letter(sides[static_cast<std::size_t>(side)]);
        return ui::label(ui, "Snapshot " + letter + " is empty: Keep " + letter + " stores the preset there.",
                         {.tone = ui::Tone::dim, .wrap = true, .width = ui::grow()});
    }
    if (s.differences.empty()) return ui::label(ui, "No parameter differs.", {.tone = ui::Tone::dim});
    const std::size_t count = s.differences.size();
    const std::string way =
        s.left == now ? "" : "; click one to take the value of " + std::string(sides[static_cast<std::size_t>(s.left)]);
    ui::label(ui, std::to_string(count) + (count == 1 ? " difference" : " differences") + way,
              {.tone = ui::Tone::dim, .number = true, .width = ui::grow()});
    difference_table(ui, snapshots, document, s, table_height);
}

void slots_and_comparison(ui::Ui& ui, Snapshots& snapshots, document::Document& document, float room,
                          ui::Size table_height) {
    SnapshotsState& state = ui.memory<SnapshotsState>(ui::hash_bytes(0, "snapshots"));
    follow_names(snapshots, document, state.names);
    {
        const ui::Column slots(ui, {.width = ui::grow(), .gap = 0.15F});
        for (std::size_t slot = 0; slot < Snapshots::count; ++slot) slot_row(ui, snapshots, state, slot, room);
    }
    ui::separator(ui);
    comparison(ui, snapshots, document, state, room, table_height);
}

}  // namespace

void snapshots_panel(ui::Ui& ui, Snapshots& snapshots, document::Document& document) {
    const ui::Rect room = ui.rect_before(ui.parent().id);
    if (room.h > 0 && room.h < ui.em(whole_height)) {
        const ui::ScrollArea area(ui, "All snapshots", {.gap = 0.4F});
        return slots_and_comparison(ui, snapshots, document, room.w, ui::px(ui.em(least_table)));
    }
    const ui::Column panel(ui, {.width = ui::grow(), .height = ui::grow(), .gap = 0.4F});
    slots_and_comparison(ui, snapshots, document, room.w, ui::grow());
}

void add_snapshot_commands(app::Editor& editor) {
    for (std::size_t slot = 0; slot < Snapshots::count; ++slot) {
        const std::string letter = Snapshots::names[slot];
        const std::string small(1, static_cast<char>('a' + slot));
        const ui::Key key = key_of(letter[0]);
        editor.commands.add({.id = "snapshot.show_" + small,
                             .title = "Show snapshot " + letter,
                             .group = "Preset",
                             .chord = {key, Mods::none},
                             .run = [&editor, slot] { editor.snapshots().show(slot); },
                             .enabled = [&editor, slot] { return editor.snapshots().at(slot).has_value(); },
                             .checked = [&editor, slot] { return editor.snapshots().shown(slot); },
                             .tip = "Sets the preset to this snapshot; a second time goes back.",
                             .missing = "nothing is kept as " + letter});
        editor.commands.add({.id = "snapshot.keep_" + small,
                             .title = "Keep as snapshot " + letter,
                             .group = "Preset",
                             .chord = {key, Mods::shift},
                             .run =
                                 [&editor, slot] {
                                     editor.snapshots().keep(slot);
                                     editor.toasts.add(
                                         {.text = std::string("Kept as snapshot ") + Snapshots::names[slot]});
                                 },
                             .tip = "Keeps the current preset."});
    }
    editor.commands.add({.id = "edit.history",
                         .title = "History",
                         .group = "Edit",
                         .chord = {key_of('H'), Mods::command},
                         .run = [&editor] { editor.layouts().bring_to_front("History"); },
                         .tip = "Lists all that was done."});
}

}  // namespace lapfx::panels
