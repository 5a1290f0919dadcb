#include "ui/shell/palette.h"

#include <algorithm>

#include "ui/core/node.h"
#include "ui/shell/fuzzy.h"
#include "ui/widgets/combo.h"
#include "ui/widgets/scroll.h"
#include "ui/widgets/text_field.h"

namespace lapfx::ui {

namespace {

constexpr std::string_view overlay = "palette";
constexpr Id state_id = 0x70616c6574746521ULL;
constexpr std::size_t rows_shown = 12;
constexpr float width = 36;        // em
constexpr float recent_bonus = 3;  // in the score: about a third of a word's beginning
// In the score, for words that are found whole outside of titles: below those in a title, above scattered letters.
constexpr float whole_letter = 10, whole_word = -4;

struct PaletteMatch {
    std::size_t index;  ///< of a command; items follow after the last command
    FuzzyMatch match;
};
using Items = std::span<const PaletteItem>;

struct PaletteState {
    std::string query;
    std::vector<PaletteMatch> found;
    std::string found_query;
    std::uint32_t found_version = 0;
    bool stale = true;
    std::size_t current = 0;
};

float score_of_words(std::string_view text) {
    float score = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == ' ') continue;
        score += whole_letter + (i == 0 || text[i - 1] == ' ' ? whole_word : 0.0F);
    }
    return score;
}

void search_items(PaletteState& state, std::size_t first, Items items) {
    const float by_words = score_of_words(state.query);
    if (by_words == 0) return;
    for (std::size_t i = 0; i < items.size(); ++i) {
        if (!contains_words(items[i].words, state.query)) continue;
        FuzzyMatch match = fuzzy_match(state.query, items[i].title).value_or(FuzzyMatch{});
        match.score = std::max(match.score, by_words);
        state.found.push_back({first + i, match});
    }
}

void search(PaletteState& state, const CommandTable& table, Items items) {
    state.found.clear();
    const auto& recent = table.recent();
    for (std::size_t i = 0; i < table.size(); ++i) {
        auto match = fuzzy_match(state.query, table.full_title(i));
        if (!match) continue;
        const auto at = std::find(recent.begin(), recent.end(), i);
        // The newest get a little more. While nothing is typed, only this decides the order.
        if (at != recent.end()) match->score += recent_bonus - 0.1F * static_cast<float>(at - recent.begin());
        state.found.push_back({i, *match});
    }
    search_items(state, table.size(), items);
    std::stable_sort(state.found.begin(), state.found.end(),
                     [](const PaletteMatch& a, const PaletteMatch& b) { return a.match.score > b.match.score; });
    state.found_query = state.query;
    state.found_version = table.version();
    state.stale = false;
    // Enter is to do something: the best that can run now is chosen, though what cannot is listed above it.
    const auto first = std::find_if(state.found.begin(), state.found.end(), [&](const PaletteMatch& found) {
        return found.index >= table.size() || table.enabled(found.index);
    });
    state.current = first == state.found.end() ? 0 : static_cast<std::size_t>(first - state.found.begin());
}

void draw_palette(Painter& painter, const Node& node, const Color& ground) {
    const float radius = painter.em(2 * painter.theme().radius);
    painter.shadow(node.rect(), painter.theme().shadow, painter.em(1.5F), radius);
    painter.fill(node.rect(), ground, radius);
    painter.frame(node.rect(), painter.theme().border, painter.hairline(), radius);
}

struct RowLook {
    Icon icon;
    FuzzyMatch match;
};

/// Draws the matched letters again in another colour, as parts of the whole text, so that its kerning stays.
void draw_matched(Painter& painter, const Rect& rect, std::string_view text, const FuzzyMatch& match, Color color) {
    const TextStyle style = painter.text_style();
    const Run& run = painter.fonts().run(text, style);
    for (std::size_t i = 0; i < std::min(text.size(), fuzzy_text_bytes);) {
        std::size_t end = i + 1;
        if (match.at(i)) {
            while (match.at(end)) ++end;
            const float from = std::round(rect.x + run.x_of(i)), to = std::round(rect.x + run.x_of(end));
            painter.push_clip({from, rect.y, to - from, rect.h});
            painter.text(rect, text, style, color);
            painter.pop_clip();
        }
        i = end;
    }
}

void draw_row(Painter& painter, const Node& node, const RowLook& look) {
    const Theme& t = painter.theme();
    const bool disabled = has(node.is, Is::disabled), current = has(node.is, Is::selected);
    if (current || has(node.is, Is::hovered))
        painter.fill(node.rect(), current ? t.accent_ground : t.field_hover, painter.em(t.radius));
    const Color ink = disabled ? t.text_disabled : t.text, quiet = disabled ? t.text_disabled : t.text_dim;
    Rect rect = node.rect().inset(painter.em(0.5F), 0);
    const Rect mark = rect.cut_left(painter.em(1.5F));
    if (look.icon != Icon::none) painter.icon({mark.x, mark.y, painter.em(1), mark.h}, look.icon, quiet);
    if (!node.text.empty()) {
        const float taken = painter.text(rect, node.text, painter.text_style(), quiet, Align::end);
        rect.cut_right(taken + painter.em(1));
    }
    painter.text(rect, node.shown, painter.text_style(), ink);
    if (!disabled) draw_matched(painter, rect, node.shown, look.match, current ? t.text : t.text_link);
}

/// The texts of a row.
struct RowText {
    std::string_view title, note, tip;
    Icon icon = Icon::none;
    bool enabled = true, checked = false;
};

RowText text_of(Ui& ui, const CommandTable& table, Items items, std::size_t index) {
    if (index >= table.size()) {
        const PaletteItem& item = items[index - table.size()];
        return {.title = item.title, .note = item.note, .tip = item.tip, .icon = item.icon};
    }
    return {.title = table.full_title(index),
            .note = table.chord_text(index),
            .tip = table.tip(ui, index),
            .icon = table[index].icon,
            .enabled = table.enabled(index),
            .checked = table.checked(index)};
}

/// Returns whether it was clicked.
bool put_row(Ui& ui, const RowText& text, const PaletteMatch& found, bool current) {
    ui.push_seed(found.index);
    ui.push_disabled(!text.enabled);
    Node& node = ui.leaf(Role::list_item, text.title, Sense::hover | Sense::press);
    ui.pop_disabled();
    ui.pop_seed();
    node.size[0] = grow();
    node.size[1] = px(ui.row_height());
    node.text = ui.copy(text.note);
    node.tip = ui.copy(text.tip);
    node.is |= when(current, Is::selected) | when(text.checked, Is::checked);
    const Response r = ui.respond(node);
    ui.draw_with<draw_row>(node, RowLook{text.checked ? Icon::check : text.icon, found.match});
    return r.clicked;
}

/// A key that the field got and does not use.
Key key_of_field(Ui& ui, Id field) {
    Key key = Key::none;
    ui.events_of(field, [&](const Event& event) {
        if (event.kind == EventKind::key && !has(event.mods, Mods::command)) key = event.key;
    });
    return key;
}

/// Returns whether `key` moved the choice.
bool move(PaletteState& state, Key key) {
    const std::size_t count = state.found.size();
    if (count == 0) return false;
    const std::size_t last = count - 1, page = rows_shown - 1;
    switch (key) {
        case Key::down:
            state.current = state.current == last ? 0 : state.current + 1;
            return true;
        case Key::up:
            state.current = state.current == 0 ? last : state.current - 1;
            return true;
        case Key::page_down:
            state.current = std::min(last, state.current + page);
            return true;
        case Key::page_up:
            state.current -= std::min(state.current, page);
            return true;
        default:
            return false;
    }
}

/// Builds the visible rows. Returns the index in `found` of the row that was clicked, or the size of `found`.
std::size_t put_rows(Ui& ui, const CommandTable& table, Items items, PaletteState& state, bool searched, bool moved) {
    const float height = ui.row_height();
    const auto rows = static_cast<float>(std::clamp<std::size_t>(state.found.size(), 1, rows_shown));
    ScrollArea area(ui, "Commands", {.height = px(rows * height), .role = Role::list});
    if (state.found.empty())
        label(ui, items.empty() ? "No command of this name" : "Nothing of this name", {.tone = Tone::dim});
    if (searched || (moved && state.current == 0)) area.state().offset.y = 0;
    if ((searched || moved) && area.state().view.y > 0) LineWindow::show(area, state.current, height);
    const LineWindow window(ui, area, state.found.size(), height);
    std::size_t clicked = state.found.size();
    for (std::size_t i = window.first(); i < window.last(); ++i) {
        const RowText text = text_of(ui, table, items, state.found[i].index);
        if (put_row(ui, text, state.found[i], i == state.current)) clicked = i;
    }
    return clicked;
}

}  // namespace

void open_palette(Ui& ui) {
    PaletteState& state = ui.memory<PaletteState>(state_id);
    state.query.clear();
    state.stale = true;
    ui.open_overlay(overlay, OverlayKind::popup,
                    {.side = Placement::Side::top, .offset = {0, std::round(ui.window().y * 0.1F)}});
}

bool palette(Ui& ui, CommandTable& table, Items items, const std::function<void(std::size_t)>& choose) {
    Node* root = ui.open_overlay_node(overlay, Role::dialog, "Command palette", Axis::y);
    if (root == nullptr) return false;
    PaletteState& state = ui.memory<PaletteState>(state_id);
    root->size[0] = px(std::min(ui.em(width), ui.window().x));
    for (std::uint8_t& pad : root->padding) pad = static_cast<std::uint8_t>(std::min(ui.em(0.5F), 255.0F));
    root->gap = ui.em(0.5F);
    root->clips = true;
    ui.draw_with<draw_palette>(*root, ui.theme().raised);
    text_field(
        ui, "Command", state.query,
        {.placeholder = items.empty() ? "Type a command" : "Type a command or a parameter", .keys_outside = true});
    const Key key = key_of_field(ui, ui.last().id);
    const bool searched = state.stale || state.query != state.found_query || state.found_version != table.version();
    if (searched) search(state, table, items);
    const bool moved = move(state, key);
    std::size_t chosen = put_rows(ui, table, items, state, searched, moved);
    if (key == Key::enter) chosen = state.current;
    ui.close_overlay_node();
    if (key == Key::escape) ui.close_overlay(overlay);
    if (chosen >= state.found.size()) return false;
    const std::size_t index = state.found[chosen].index;
    if (index < table.size() && !table.enabled(index)) return false;
    ui.close_overlay(overlay);  // before the command, which may open an overlay itself
    if (index >= table.size()) {
        if (choose) choose(index - table.size());
        return true;
    }
    table.note_recent(index);
    return table.run(index);
}

}  // namespace lapfx::ui
