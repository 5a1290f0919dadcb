#include "ui/shell/key_editor.h"

#include <algorithm>

#include "ui/core/node.h"
#include "ui/shell/fuzzy.h"
#include "ui/widgets/scroll.h"
#include "ui/widgets/text_field.h"

namespace lapfx::ui {

namespace {

constexpr std::string_view sheet = "cheat sheet";
constexpr Id state_id = 0x6b657973206f6621ULL;
constexpr std::size_t none = ~std::size_t{0};
constexpr float chord_width = 11;                                     // em
constexpr float sheet_column = 19, sheet_gap = 2, sheet_padding = 1;  // em

/// Keys of the UI itself, which cannot be bound to commands.
constexpr SheetLine fixed_keys[] = {{"Next field", "Tab"},
                                    {"Field before", "Shift+Tab"},
                                    {"Next panel", "F6"},
                                    {"Menu bar", "F10, Alt+letter"},
                                    {"Press, choose", "Enter"},
                                    {"Close, cancel", "Esc"},
                                    {"Menu of what has the keyboard", "Menu"},
                                    {"Undo in a text field", "Ctrl+Z"},
                                    {"Reset to saved value", "Backspace"},
                                    {"Default value", "Shift+Backspace"}};

struct EditorState {
    std::string query;
    std::vector<std::size_t> found;
    std::string found_query;
    std::uint32_t found_version = ~0U;
    std::size_t recording = none;  ///< command that waits for a chord
    std::size_t wants = none;      ///< command that wants `chord`, which `holder` has
    std::size_t holder = none;
    Chord chord;
    std::string fault;
};

void search(EditorState& state, const CommandTable& table) {
    if (state.query == state.found_query && state.found_version == table.version()) return;
    state.found.clear();
    for (std::size_t i = 0; i < table.size(); ++i) {
        const bool by_keys = !state.query.empty() && fuzzy_match(state.query, table.chord_text(i)).has_value();
        if (by_keys || fuzzy_match(state.query, table.full_title(i))) state.found.push_back(i);
    }
    state.found_query = state.query;
    state.found_version = table.version();
}

struct ChordLook {
    bool recording, rebound;
};

void draw_chord(Painter& painter, const Node& node, const ChordLook& look) {
    const Theme& t = painter.theme();
    const float radius = painter.em(t.radius);
    painter.fill(node.rect(), has(node.is, Is::hovered) ? t.field_hover : t.field, radius);
    if (look.recording) painter.frame(node.rect(), t.accent, 2 * painter.hairline(), radius);
    const Color ink = look.recording || node.text.empty() ? t.text_dim : t.text;
    const Rect inside = node.rect().inset(painter.em(0.6F), 0);
    painter.text(inside, look.recording ? "Press keys" : node.text,
                 painter.text_style(1, look.rebound ? Weight::bold : Weight::regular), ink);
}

/// Takes the chord that was pressed while a command waited for one. Returns whether a binding changed.
bool take_chord(CommandTable& table, EditorState& state, std::size_t command, const Chord& chord) {
    state.recording = none;
    state.fault.clear();
    if (chord.key == Key::escape) return false;
    if (!bindable(chord)) {
        state.fault = text_of(chord) + " belongs to the whole program and cannot be changed";
        return false;
    }
    if (const auto holder = table.bind(command, chord)) {
        state.wants = command, state.holder = *holder, state.chord = chord;
        return false;
    }
    return true;
}

bool put_chord(Ui& ui, CommandTable& table, EditorState& state, std::size_t command) {
    const bool recording = state.recording == command;
    const Sense sense = Sense::hover | Sense::press | Sense::focus | (recording ? Sense::every_key : Sense::activate);
    Node& node = ui.leaf(Role::button, ui.join({"Keys of ", table.full_title(command)}), sense);
    node.size[0] = px(ui.em(chord_width));
    node.size[1] = px(ui.row_height());
    node.text = ui.copy(table.chord_text(command));
    node.tip = recording ? "Esc keeps the old keys" : "Click, then press the new keys";
    node.is |= when(recording, Is::busy) | when(table.rebound(command), Is::changed);
    const Id id = node.id;
    const Response r = ui.respond(node);
    ui.draw_with<draw_chord>(node, ChordLook{recording, table.rebound(command)});
    if (recording) {
        Chord chord;
        ui.events_of(id, [&](const Event& e) {
            if (e.kind == EventKind::key) chord = {e.key, e.mods};
        });
        if (r.focus_out) state.recording = none;
        return chord && take_chord(table, state, command, chord);
    }
    if (r.clicked) {
        state = {.query = state.query, .found = {}, .found_query = {}, .chord = {}, .fault = {}};
        state.recording = command;
        ui.set_focus(id, ui.focus_ringed());
    }
    return false;
}

bool put_row(Ui& ui, CommandTable& table, EditorState& state, std::size_t command) {
    bool changed = false;
    label(ui, table.full_title(command), {.width = grow()});
    changed |= put_chord(ui, table, state, command);
    ui.push_disabled(table.chord_text(command).empty());
    if (icon_button(ui, Icon::cross, ui.join({"No keys for ", table.full_title(command)}), {.quiet = true}))
        table.bind(command, {}), changed = true;
    ui.pop_disabled();
    ui.push_disabled(!table.rebound(command));
    if (icon_button(ui, Icon::reset, ui.join({"Standard keys for ", table.full_title(command)}), {.quiet = true})) {
        const auto holder = table.reset(command);
        if (holder) state.wants = command, state.holder = *holder, state.chord = table[command].chord;
        changed |= !holder;
    }
    ui.pop_disabled();
    return changed;
}

/// Shows why the last change was not possible.
bool put_conflict(Ui& ui, CommandTable& table, EditorState& state) {
    if (!state.fault.empty()) label(ui, state.fault, {.tone = Tone::warning, .wrap = true});
    if (state.wants >= table.size() || state.holder >= table.size()) return false;
    label(ui, ui.join({text_of(state.chord), " belongs to ", table.full_title(state.holder)}),
          {.tone = Tone::warning, .wrap = true});
    const Row row(ui);
    const bool takes =
        button(ui, ui.join({"Give it to ", table.full_title(state.wants), "###take"}), {.primary = true});
    const bool leaves = button(ui, "Leave it");
    if (takes) table.bind(state.wants, state.chord, true);
    if (takes || leaves) state.wants = state.holder = none;
    return takes;
}

void draw_sheet(Painter& painter, const Node& node, const Color& ground) {
    const float radius = painter.em(2 * painter.theme().radius);
    painter.shadow(node.rect(), painter.theme().shadow, painter.em(1.5F), radius);
    painter.fill(node.rect(), ground, radius);
    painter.frame(node.rect(), painter.theme().border, painter.hairline(), radius);
}

void draw_sheet_line(Painter& painter, const Node& node, const TextStyle& style) {
    const Theme& t = painter.theme();
    Rect rect = node.rect();
    const float taken = painter.text(rect, node.text, style, t.text, Align::end);
    rect.cut_right(taken + painter.em(1));
    painter.text(rect, node.shown, style, t.text_dim);
}

/// Puts lines into columns, from the top down.
class SheetColumns {
  public:
    SheetColumns(Ui& ui, std::size_t lines) : ui_(ui), lines_(std::max<std::size_t>(lines, 4)) { open(); }
    ~SheetColumns() { ui_.close(); }
    /// A title stays with at least one line after it.
    void title(std::string_view text) {
        if (used_ + 2 > lines_) next();
        heading(ui_, text);
        ++used_;
    }
    void line(std::string_view what, std::string_view keys) {
        if (used_ >= lines_) next();
        ui_.push_seed(placed_++);  // "Zoom" is in several groups
        Node& node = ui_.leaf(Role::list_item, what);
        ui_.pop_seed();
        node.text = ui_.copy(keys);
        node.size[0] = grow();
        node.size[1] = px(ui_.row_height());
        ui_.draw_with<draw_sheet_line>(node, ui_.text_style());
        ++used_;
    }

    void part(const SheetPart& part) {
        title(part.title);
        for (const SheetLine& one : part.lines) line(one.what, one.keys);
    }

  private:
    void open() {
        Node& node = ui_.open(Role::none, {}, Axis::y);
        node.size[0] = px(ui_.em(sheet_column));
    }
    void next() {
        ui_.close();
        open();
        used_ = 0;
    }
    Ui& ui_;
    std::size_t lines_, used_ = 0, placed_ = 0;
};

bool in_group(const CommandTable& table, std::size_t i, const std::string& group) {
    return table.chord(i) && table[i].group == group;
}

/// Whether this is the first command with keys of its group, which determines where the group is shown.
bool begins_group(const CommandTable& table, std::size_t i) {
    if (!table.chord(i)) return false;
    for (std::size_t k = 0; k < i; ++k) {
        if (in_group(table, k, table[i].group)) return false;
    }
    return true;
}

std::size_t lines_of(std::span<const SheetPart> parts) {
    std::size_t lines = 0;
    for (const SheetPart& part : parts) lines += 1 + part.lines.size();
    return lines;
}

std::size_t lines_of(const CommandTable& table) {
    std::size_t lines = 0;
    for (std::size_t i = 0; i < table.size(); ++i)
        lines += (table.chord(i) ? 1U : 0U) + (begins_group(table, i) ? 1U : 0U);
    return lines;
}

void put_groups(const CommandTable& table, SheetColumns& columns) {
    for (std::size_t i = 0; i < table.size(); ++i) {
        if (!begins_group(table, i)) continue;
        columns.title(table[i].group.empty() ? std::string_view("Other") : table[i].group);
        for (std::size_t k = i; k < table.size(); ++k) {
            if (in_group(table, k, table[i].group)) columns.line(table[k].title, table.chord_text(k));
        }
    }
}

}  // namespace

bool key_editor(Ui& ui, CommandTable& table) {
    EditorState& state = ui.memory<EditorState>(state_id);
    bool changed = false;
    {
        const Row row(ui, {.width = grow(), .cross = ChildAlign::center});
        search_field(ui, "Search commands", state.query, {.placeholder = "Command or keys"});
        if (button(ui, "All to standard")) {
            table.reset_all();
            state.wants = state.holder = state.recording = none;
            changed = true;
        }
    }
    changed |= put_conflict(ui, table, state);
    search(state, table);
    virtual_rows(ui, "Keys", state.found.size(), ui.row_height() + ui.em(0.2F), [&](std::size_t row) {
        if (row < state.found.size()) changed |= put_row(ui, table, state, state.found[row]);
    });
    return changed;
}

void toggle_cheat_sheet(Ui& ui) {
    if (ui.overlay_open(sheet)) return ui.close_overlay(sheet);
    ui.open_overlay(sheet, OverlayKind::popup, {.side = Placement::Side::center});
}

void cheat_sheet(Ui& ui, const CommandTable& table, std::span<const SheetPart> more) {
    Node* root = ui.open_overlay_node(sheet, Role::dialog, "Keys", Axis::y);
    if (root == nullptr) return;
    for (std::uint8_t& pad : root->padding) pad = static_cast<std::uint8_t>(std::min(ui.em(sheet_padding), 255.0F));
    root->clips = true;
    ui.draw_with<draw_sheet>(*root, ui.theme().raised);
    const SheetPart own{"Everywhere", fixed_keys};
    const std::size_t all = lines_of(table) + 1 + own.lines.size() + lines_of(more);
    const glm::vec2 room = glm::max(ui.window() - 4 * ui.em(sheet_padding), glm::vec2(ui.em(sheet_column)));
    const auto at_most = [](float whole, float part) { return static_cast<std::size_t>(std::max(1.0F, whole / part)); };
    // The bar beside the columns must not lie on the last of them.
    const float bar = ui.em(1.2F);
    const std::size_t across = at_most(room.x - bar + ui.em(sheet_gap), ui.em(sheet_column + sheet_gap));
    const std::size_t down = at_most(room.y, ui.row_height());
    const std::size_t columns = std::min(across, (all + down - 1) / down);
    const std::size_t lines = (all + columns - 1) / columns + 1;  // all columns get about the same length
    {
        const auto count = static_cast<float>(columns);
        const float whole = static_cast<float>(lines) * ui.row_height();
        const ScrollArea area(
            ui, "All keys",
            {.width = px(count * ui.em(sheet_column) + (count - 1) * ui.em(sheet_gap) + (whole > room.y ? bar : 0)),
             .height = px(std::min(whole, room.y))});
        const Row row(ui, {.gap = sheet_gap, .cross = ChildAlign::start});
        SheetColumns put(ui, lines);
        put_groups(table, put);
        put.part(own);
        for (const SheetPart& part : more) put.part(part);
    }
    ui.close_overlay_node();
}

}  // namespace lapfx::ui
