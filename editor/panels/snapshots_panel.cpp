// Snapshots A to D of the preset: kept, shown with one key, and compared, in words here and as pictures in the
// Reference panel.
#include "app/tuning/snapshots.h"

#include "app/base/layouts.h"
#include "app/editor.h"
#include "app/reference/reference.h"
#include "app/tuning/snapshot_previews.h"
#include "document/words.h"
#include "panels/panels.h"
#include "ui/core/node.h"
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
constexpr float whole_row = 26, named_row = 18, worded_row = 16, whole_height = 24, least_table = 9;
constexpr float picture_height = 3.8F, least_pictured = 12;

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

struct SlotPicture {
    ui::ImageHandle image = 0;
};
void draw_slot_picture(ui::Painter& painter, const ui::Node& node, const SlotPicture& look) {
    if (look.image != 0) return painter.image(node.rect(), look.image);
    painter.fill(node.rect(), painter.theme().canvas);
}

/// As it was when it was kept.
void slot_picture(ui::Ui& ui, const app::SnapshotPreviews& previews, std::size_t slot) {
    const ui::ImageHandle image = previews.thumbnail(slot);
    ui::Node& node = ui.leaf(ui::Role::image, ui.join({"Picture of ", Snapshots::names[slot]}));
    const glm::vec2 shape(app::SnapshotPreviews::thumbnail_size);
    node.size[0] = ui::px(std::round(ui.em(picture_height) * shape.x / shape.y));
    node.size[1] = ui::px(ui.em(picture_height));
    char text[48];
    const int length = std::snprintf(text, sizeof text, "through the endoscope, at %.2f s of the scene",
                                     previews.thumbnail_time(slot));
    node.text = image == 0 ? "being made" : ui.copy({text, static_cast<std::size_t>(std::max(length, 0))});
    node.is |= ui::when(image == 0, ui::Is::busy);
    ui.draw_with<draw_slot_picture>(node, SlotPicture{image});
}

/// The name of what is kept, and when that was.
void slot_words(ui::Ui& ui, const Snapshots& snapshots, SnapshotsState& state, std::size_t slot, bool timed) {
    const auto& snapshot = snapshots.at(slot);
    if (snapshot) ui::date_text(snapshot->time, state.text);
    name_of(ui, state.names, snapshots, slot);
    if (snapshot && timed)
        ui::label(ui, state.text.substr(state.text.find(' ') + 1), {.tone = ui::Tone::dim, .number = true});
}

void slot_buttons(ui::Ui& ui, Snapshots& snapshots, std::size_t slot, float room) {
    const bool kept = snapshots.at(slot).has_value(), icons = room < ui.em(worded_row);
    const std::string_view letter = Snapshots::names[slot];
    const auto slot_button = [&](ui::Icon icon, std::string_view label, ui::ButtonOptions options) {
        options.quiet = icons;
        return icons ? ui::icon_button(ui, icon, label, options) : ui::button(ui, label, options);
    };
    const ui::Size button_width = room >= ui.em(named_row) ? ui::px(ui.em(5.2F)) : ui::grow();
    ui.push_disabled(!kept);
    const bool show =
        slot_button(ui::Icon::eye, ui.join({"Show ", letter}),
                    {.tip = "Sets the preset to this snapshot, as one undo step. A second click goes back.",
                     .on = snapshots.shown(slot),
                     .width = button_width});
    ui.pop_disabled();
    if (show) snapshots.show(slot);
    if (slot_button(ui::Icon::plus, ui.join({"Keep ", letter}),
                    {.tip = kept ? "Replaces this snapshot with the current preset." : "Keeps the current preset.",
                     .width = button_width}))
        snapshots.keep(slot);
    ui.push_disabled(!snapshots.at(slot).has_value());
    if (ui::icon_button(ui, ui::Icon::cross, ui.join({"Clear ", letter}), {.quiet = true})) snapshots.clear(slot);
    ui.pop_disabled();
}

/// What is kept has its picture, and words above its buttons; an empty slot is one line.
void slot_row(ui::Ui& ui, Snapshots& snapshots, const app::SnapshotPreviews& previews, SnapshotsState& state,
              std::size_t slot, float room) {
    ui.push_seed(Snapshots::names[slot]);
    {
        const bool kept = snapshots.at(slot).has_value(), pictured = kept && room >= ui.em(least_pictured);
        const ui::Row row(ui, {.width = ui::grow(), .gap = 0.5F, .cross = ui::ChildAlign::center});
        if (pictured) slot_picture(ui, previews, slot);
        const ui::Column lines(ui, {.width = ui::grow(), .gap = 0.2F});
        const float rest = room - (pictured ? ui.em(picture_height * 1.25F + 0.5F) : 0);
        if (pictured) {
            const ui::Row words(ui, {.width = ui::grow(), .gap = 0.4F, .cross = ui::ChildAlign::center});
            slot_words(ui, snapshots, state, slot, room >= ui.em(named_row));
        }
        const ui::Row buttons(ui, {.width = ui::grow(), .gap = 0.4F, .cross = ui::ChildAlign::center});
        if (!pictured && room >= ui.em(named_row)) slot_words(ui, snapshots, state, slot, false);
        if (room < ui.em(worded_row)) ui::label(ui, Snapshots::names[slot], {.width = ui::grow()});
        slot_buttons(ui, snapshots, slot, rest);
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

/// Lays the two beside each other in the Reference panel.
void pictures_button(ui::Ui& ui, const SnapshotsState& s, app::ReferenceComparison& comparison, app::Layouts& layouts) {
    const auto side = [](int chosen) {
        return chosen == now ? app::CompareSide::preview : app::side_of(static_cast<std::size_t>(chosen));
    };
    ui.push_disabled(s.left == s.right);
    if (ui::button(
            ui, "Pictures",
            {.icon = ui::Icon::image,
             .tip = "Shows the two next to each other, in the Reference panel; there either can also be compared "
                    "with the reference"})) {
        comparison.show({side(s.left), side(s.right)});
        layouts.bring_to_front("Reference");
    }
    ui.pop_disabled();
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

/// What the panel works on.
struct On {
    Snapshots& snapshots;
    app::SnapshotPreviews& previews;
    app::ReferenceComparison& comparison;
    app::Layouts& layouts;
    document::Document& document;
};

/// How many parameters differ, and what can be done about it.
void differences_line(ui::Ui& ui, const On& on, const SnapshotsState& s) {
    const std::size_t count = s.differences.size();
    const std::string way =
        s.left == now ? "" : "; click one to take the value of " + std::string(sides[static_cast<std::size_t>(s.left)]);
    const ui::Row row(ui, {.width = ui::grow(), .gap = 0.6F, .cross = ui::ChildAlign::center});
    if (count == 0)
        ui::label(ui, "No parameter differs.", {.tone = ui::Tone::dim, .width = ui::grow()});
    else
        ui::label(ui, std::to_string(count) + (count == 1 ? " difference" : " differences") + way,
                  {.tone = ui::Tone::dim, .number = true, .width = ui::grow()});
    pictures_button(ui, s, on.comparison, on.layouts);
}

void comparison(ui::Ui& ui, const On& on, SnapshotsState& s, float room, ui::Size table_height) {
    const Snapshots& snapshots = on.snapshots;
    sides_row(ui, s, room);
    compare(snapshots, on.document, s);
    for (const int side : {s.left, s.right}) {
        if (there(snapshots, side)) continue;
        const std::string letter(sides[static_cast<std::size_t>(side)]);
        return ui::label(ui, "Snapshot " + letter + " is empty: Keep " + letter + " stores the preset there.",
                         {.tone = ui::Tone::dim, .wrap = true, .width = ui::grow()});
    }
    differences_line(ui, on, s);
    if (!s.differences.empty()) difference_table(ui, snapshots, on.document, s, table_height);
}

void slots_and_comparison(ui::Ui& ui, const On& on, float room, ui::Size table_height) {
    SnapshotsState& state = ui.memory<SnapshotsState>(ui::hash_bytes(0, "snapshots"));
    follow_names(on.snapshots, on.document, state.names);
    {
        const ui::Column slots(ui, {.width = ui::grow(), .gap = 0.3F});
        for (std::size_t slot = 0; slot < Snapshots::count; ++slot)
            slot_row(ui, on.snapshots, on.previews, state, slot, room);
    }
    ui::separator(ui);
    comparison(ui, on, state, room, table_height);
}

/// em: that the panel needs when it does not scroll.
float height_of(const Snapshots& snapshots) {
    float height = whole_height;
    for (std::size_t slot = 0; slot < Snapshots::count; ++slot)
        height += snapshots.at(slot) ? picture_height - 1.6F : 0;
    return height;
}

}  // namespace

void snapshots_panel(ui::Ui& ui, Snapshots& snapshots, app::SnapshotPreviews& previews,
                     app::ReferenceComparison& comparison, app::Layouts& layouts, document::Document& document) {
    previews.show_thumbnails();
    const On on{snapshots, previews, comparison, layouts, document};
    const ui::Rect room = ui.rect_before(ui.parent().id);
    if (room.h > 0 && room.h < ui.em(height_of(snapshots))) {
        const ui::ScrollArea area(ui, "All snapshots", {.gap = 0.4F});
        return slots_and_comparison(ui, on, room.w, ui::px(ui.em(least_table)));
    }
    const ui::Column panel(ui, {.width = ui::grow(), .height = ui::grow(), .gap = 0.4F});
    slots_and_comparison(ui, on, room.w, ui::grow());
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
        editor.commands.add(
            {.id = "snapshot.compare_" + small,
             .title = "Compare snapshot " + letter + " with the reference",
             .group = "Reference",
             .run =
                 [&editor, slot] {
                     editor.reference().comparison().show({app::side_of(slot), app::CompareSide::reference});
                     editor.layouts().bring_to_front("Reference");
                 },
             .enabled = [&editor, slot] { return editor.snapshots().at(slot).has_value(); },
             .tip = "The snapshot takes the place of the preview in the comparison",
             .missing = "nothing is kept as " + letter});
    }
    editor.commands.add({.id = "edit.history",
                         .title = "History",
                         .group = "Edit",
                         .chord = {key_of('H'), Mods::command},
                         .run = [&editor] { editor.layouts().bring_to_front("History"); },
                         .tip = "Lists all that was done."});
}

}  // namespace lapfx::panels
