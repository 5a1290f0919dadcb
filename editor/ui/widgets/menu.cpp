#include "ui/widgets/menu.h"

#include <array>

#include "ui/core/node.h"
#include "ui/value/letters.h"
#include "ui/value/utf8.h"

namespace lapfx::ui {

namespace {

constexpr double submenu_after = 0.12;  // s that the pointer stays on an item until its submenu opens
constexpr double leave_after = 0.25;    // s on another item until an open submenu closes: the way to it may be diagonal
constexpr float mark_width = 1.7F;      // em, for a check mark or an icon
constexpr Id state_id = 0x6d656e752e737461ULL;

/// One menu that is being built. It is in the frame's arena.
struct Level {
    std::string_view name;
    Level* outer = nullptr;
    int bar_index = -1;                             ///< index of the menu in a bar, else -1
    float height = 0;                               ///< px of the items so far
    char32_t letter = 0;                            ///< typed in this build, to go to the next item that begins with it
    Key key = Key::none;                            ///< Home, End, Left or Right that came in this build
    Id key_target = 0;                              ///< the node that had the keyboard then
    Id first = 0, last = 0, after = 0, before = 0;  ///< items that can be chosen, or that begin with the letter
    bool passed = false;                            ///< key_target has been built
    bool opened_by_key = false;                     ///< a key opened it in this build
    Id keys = 0;                                    ///< the node that has the keyboard while no item is marked
};

struct MenuState {
    Level* level = nullptr;
    // The item that the pointer is on, since when, and whether that has had its effect.
    Id hot = 0;
    double hot_since = 0;
    bool acted = false;
    Id keys = 0;  ///< the Level::keys that had the keyboard in the last build
    // The bar that is being built.
    int bar_count = 0, bar_index = 0;
    float bar_text = 0, bar_texts = 0;  ///< px of the titles so far, and of all titles in the last build
    float bar_pad = 0;                  ///< px on each side of a title
    int bar_want = -1;                  ///< index of the menu to open next, after Left, Right or F10
    char bar_letter = 0;                ///< came with Alt in this build, small
    std::uint32_t bar_letters = 0;      ///< bits of the letters that open the menus so far, a first
    bool bar_by_key = false;            ///< a key has opened a menu of the bar, whose first item is to be marked
    std::array<char, 96> open_bar_menu{};
};

MenuState& state_of(Ui& ui) {
    return ui.memory<MenuState>(state_id);
}

void draw_menu(Painter& painter, const Node& node, const Color& ground) {
    const float radius = painter.em(painter.theme().radius);
    painter.shadow(node.rect(), painter.theme().shadow, painter.em(0.9F), radius);
    painter.fill(node.rect(), ground, radius);
    painter.frame(node.rect(), painter.theme().border, painter.hairline(), radius);
}

struct ItemLook {
    Icon icon;
    std::string_view shortcut;
    bool submenu;
};

/// Whether the pointer or the keyboard is on it.
bool lit(const Node& node) {
    if (has(node.is, Is::disabled)) return false;
    return has(node.is, Is::expanded) ||
           (has(node.is, Is::focused) && (has(node.is, Is::hovered) || has(node.is, Is::ringed)));
}

void draw_item(Painter& painter, const Node& node, const ItemLook& look) {
    const Theme& t = painter.theme();
    const bool disabled = has(node.is, Is::disabled);
    if (lit(node)) painter.fill(node.rect(), t.accent_ground, painter.em(t.radius));
    const Color ink = disabled ? t.text_disabled : t.text, quiet = disabled ? t.text_disabled : t.text_dim;
    Rect rect = node.rect().inset(painter.em(0.3F), 0);
    const Rect mark = rect.cut_left(painter.em(mark_width) - painter.em(0.3F));
    const Icon icon = has(node.is, Is::checked) ? Icon::check : look.icon;
    if (icon != Icon::none) painter.icon({mark.x, mark.y, painter.em(1), mark.h}, icon, ink);
    const Rect end = rect.cut_right(painter.em(1.2F));
    if (look.submenu)
        painter.icon({end.right() - painter.em(0.9F), end.y, painter.em(0.8F), end.h}, Icon::chevron_right, quiet);
    if (!look.shortcut.empty()) painter.text(rect, look.shortcut, painter.text_style(), quiet, Align::end);
    painter.text(rect, node.shown, painter.text_style(), ink);
}

void draw_line(Painter& painter, const Node& node, const Color& color) {
    const Rect rect = node.rect();
    painter.fill({rect.x, std::round(rect.center().y), rect.w, painter.hairline()}, color);
}

void draw_bar(Painter& painter, const Node& node, const Color& color) {
    painter.ground(node.rect(), color);
}

struct BarItemLook {
    TextStyle style;
    std::size_t letter = 0;  ///< byte of the title
    bool underlined = false;
    friend bool operator==(const BarItemLook&, const BarItemLook&) = default;
};

void draw_bar_item(Painter& painter, const Node& node, const BarItemLook& look) {
    const Theme& t = painter.theme();
    const bool disabled = has(node.is, Is::disabled), open = has(node.is, Is::expanded);
    if (!disabled && (open || has(node.is, Is::hovered)))
        painter.fill(node.rect(), open ? t.accent_ground : t.control_hover, painter.em(t.radius));
    const Color ink = disabled ? t.text_disabled : t.text;
    painter.text(node.rect(), node.shown, look.style, ink, Align::center);
    if (!look.underlined) return;
    const Run& run = painter.fonts().run(node.shown, look.style);
    const float left = std::round(node.rect().center().x - run.width / 2);
    const float from = std::round(run.x_of(look.letter)), to = std::round(run.x_of(look.letter + 1));
    painter.fill({left + from, std::round(node.rect().center().y + painter.em(0.55F)), to - from, painter.hairline()},
                 ink);
}

/// The byte of the first letter of the title that opens no menu before it in the bar; the size of the title: none.
std::size_t letter_of(std::string_view title, std::uint32_t taken) {
    for (std::size_t i = 0; i < title.size(); ++i) {
        const char32_t c = lower<char32_t>(static_cast<unsigned char>(title[i]));
        if (c >= 'a' && c <= 'z' && (taken >> (c - 'a') & 1U) == 0) return i;
    }
    return title.size();
}

/// Reads the events that the item with the keyboard got in this build. This is done before the items are built, because
/// the events choose among them.
void take_keys(Ui& ui, Level& level) {
    level.key_target = ui.focus();
    ui.events_of(ui.focus(), [&](const Event& event) {
        if (event.kind == EventKind::text && event.codepoint != ' ') level.letter = lower(event.codepoint);
        if (event.kind == EventKind::key) level.key = event.key;
    });
}

/// A menu that the pointer opened has no marked item, and an item must not run unless a person sees that it is marked.
/// Until one is chosen, this node has the keyboard.
void put_keys(Ui& ui, Level& level, std::uint8_t layer) {
    const Node* focused = ui.before(ui.focus());
    if (focused != nullptr && focused->role == Role::menu_item && focused->layer == layer) return;
    Node& node =
        ui.leaf(Role::none, "Menu##keys",
                Sense::focus | Sense::activate | Sense::typing | Sense::arrows_x | Sense::arrows_y | Sense::extremes);
    node.placed = true;
    node.placement = ui.arena().make(Placement{});
    node.size[0] = node.size[1] = px(0);
    level.keys = node.id;
    level.passed = level.key_target == node.id;
    Id& had = state_of(ui).keys;
    bool& by_key = state_of(ui).bar_by_key;
    level.opened_by_key = level.passed && had != node.id && (ui.focus_ringed() || by_key);
    if (level.passed) by_key = false;
    if (level.passed || had == node.id) had = level.passed ? node.id : 0;
}

void watch_pointer(Ui& ui) {
    MenuState& state = state_of(ui);
    if (state.hot == ui.hot()) return;
    state.hot = ui.hot();
    state.hot_since = ui.time();
    state.acted = false;
}

void begin_menu(Ui& ui, Node& node, std::string_view name, int bar_index) {
    const float pad = ui.em(0.3F);
    for (std::uint8_t& each : node.padding) each = static_cast<std::uint8_t>(std::min(pad, 255.0F));
    node.clips = true;
    ui.draw_with<draw_menu>(node, ui.theme().raised);
    MenuState& state = state_of(ui);
    Level* level = ui.arena().make(Level{.name = ui.copy(name), .outer = state.level, .bar_index = bar_index});
    take_keys(ui, *level);
    put_keys(ui, *level, node.layer);
    watch_pointer(ui);
    state.level = level;
}

/// Left closes a submenu, or goes from a bar's menu to the one before; Right goes to the next menu of the bar.
void leave_sideways(Ui& ui, const Level& level) {
    MenuState& state = state_of(ui);
    if (level.key == Key::left && level.outer != nullptr) return ui.close_overlay(level.name);
    const Level* root = &level;
    while (root->outer != nullptr) root = root->outer;
    if (root->bar_index < 0 || state.bar_count < 2) return;
    const int step = level.key == Key::left ? -1 : 1;
    state.bar_want = (root->bar_index + step + state.bar_count) % state.bar_count;
    ui.close_overlays_over(root->name);
    ui.close_overlay(root->name);
}

/// The item that a key leads to. While none is marked, arrows lead to one, and so does opening the menu with a key.
Id next_item(const Ui& ui, const Level& level) {
    if (!level.passed) return 0;
    if (level.letter != 0) return level.after != 0 ? level.after : level.before;
    if (level.key == Key::home) return level.first;
    if (level.key == Key::end) return level.last;
    if (ui.focus() != level.keys) return 0;
    if (level.key == Key::up) return level.last;
    const bool asked = level.key == Key::down || level.key == Key::enter || level.key == Key::space;
    return asked || level.opened_by_key ? level.first : 0;
}

void end_menu(Ui& ui) {
    MenuState& state = state_of(ui);
    const Level& level = *state.level;
    Node& node = ui.parent();
    // The menu is as tall as its items. If it is taller than the window, it scrolls.
    const float whole = level.height + static_cast<float>(node.padding[1] + node.padding[3]);
    node.size[1] = px(std::min(whole, ui.window().y));
    if (whole > ui.window().y) {
        node.scrolls[1] = true;
        node.scroll = &ui.memory<ScrollState>(hash_bytes(state_id, level.name));
    }
    state.level = level.outer;
    const Id next = next_item(ui, level);
    if (next != 0) {
        ui.set_focus(next, true);
        ui.reveal(next);
    }
    ui.close_overlay_node();
    if (!level.passed) return;
    if (level.key == Key::left || level.key == Key::right) leave_sideways(ui, level);
}

/// Takes note of an item that can be chosen, for letters, Home and End.
void count_item(Level& level, const Node& node) {
    if (level.first == 0) level.first = node.id;
    level.last = node.id;
    const bool begins = level.letter != 0 && !node.shown.empty() && lower(decode(node.shown).codepoint) == level.letter;
    if (begins && level.passed && level.after == 0) level.after = node.id;
    if (begins && !level.passed && level.before == 0) level.before = node.id;
    level.passed |= node.id == level.key_target;
}

/// Returns whether the pointer has been on the item for long enough to act on it. It returns true only once.
bool pointer_acts(Ui& ui, const Level& level, Id id, double after) {
    MenuState& state = state_of(ui);
    if (state.hot != id || state.acted) return false;
    if (!ui.overlay_on_top(level.name)) after = std::max(after, leave_after);
    if (ui.time() < state.hot_since + after) {
        ui.wake_at(state.hot_since + after, "menu");
        return false;
    }
    return state.acted = true;
}

Response put_item(Ui& ui, std::string_view label, const MenuItemOptions& options, bool submenu, bool open) {
    MenuState& state = state_of(ui);
    Level& level = *state.level;
    ui.push_disabled(!options.enabled);
    Node& node = ui.leaf(Role::menu_item, label,
                         Sense::hover | Sense::press | Sense::focus | Sense::activate | Sense::typing |
                             Sense::arrows_x | Sense::extremes);
    ui.pop_disabled();
    const float shortcut = options.shortcut.empty() ? 0.0F : ui.text_width(options.shortcut) + ui.em(2);
    node.size[0] = grow();
    node.minimum[0] = std::ceil(ui.text_width(node.shown) + shortcut) + ui.em(mark_width) + ui.em(1.8F);
    node.size[1] = px(ui.row_height());
    node.tip = ui.copy(options.tip);
    node.text = ui.copy(options.shortcut);
    node.is |= when(options.checked, Is::checked) | when(open, Is::expanded);
    level.height += ui.row_height();
    const Response r = ui.respond(node);
    ui.draw_with<draw_item>(node, ItemLook{options.icon, node.text, submenu});
    if (!has(node.is, Is::disabled)) count_item(level, node);
    return r;
}

}  // namespace

void open_menu(Ui& ui, std::string_view name, const Placement& placement) {
    ui.open_overlay(name, OverlayKind::popup, placement);
}

Menu::Menu(Ui& ui, std::string_view name, std::string_view label) : ui_(ui) {
    Node* node = ui.open_overlay_node(name, Role::menu, label, Axis::y);
    open_ = node != nullptr;
    if (open_) begin_menu(ui, *node, name, -1);
}

Menu::~Menu() {
    if (open_) end_menu(ui_);
}

bool menu_item(Ui& ui, std::string_view label, const MenuItemOptions& options) {
    const Response r = put_item(ui, label, options, false, false);
    const Id id = ui.last().id;
    const bool enabled = !has(ui.last().is, Is::disabled);
    const Level* level = state_of(ui).level;
    if (pointer_acts(ui, *level, id, 0)) {
        ui.close_overlays_over(level->name);
        if (enabled) ui.set_focus(id);
    }
    if (!r.clicked) return false;
    while (level->outer != nullptr) level = level->outer;
    ui.close_overlays_over(level->name);
    ui.close_overlay(level->name);
    return true;
}

void menu_separator(Ui& ui) {
    Node& node = ui.leaf(Role::separator, {});
    const float height = ui.em(0.6F);
    node.size[0] = grow();
    node.size[1] = px(height);
    state_of(ui).level->height += height;
    ui.draw_with<draw_line>(node, ui.theme().border);
}

Submenu::Submenu(Ui& ui, std::string_view label, Icon icon) : ui_(ui) {
    Level& outer = *state_of(ui).level;
    const std::string_view name = ui.join({outer.name, "/", label});
    const bool open = ui.overlay_open(name);
    const Response r = put_item(ui, label, {.icon = icon}, true, open);
    const Id id = ui.last().id;
    bool opens = r.clicked;
    if (id == outer.key_target && outer.key == Key::right) {
        opens = true;
        outer.key = Key::none;  // the key does not lead to the next menu of the bar as well
    }
    if (!has(ui.last().is, Is::disabled) && pointer_acts(ui, outer, id, submenu_after)) opens = true;
    if (opens && !open) {
        ui.close_overlays_over(outer.name);
        ui.set_focus(id, ui.focus_ringed());  // Esc and Left return to it
        ui.open_overlay(name, OverlayKind::submenu,
                        {.side = Placement::Side::right_of, .offset = {0, -ui.em(0.3F)}, .anchor = id});
    }
    Node* node = ui.open_overlay_node(name, Role::menu, label, Axis::y);
    open_ = node != nullptr;
    if (open_) begin_menu(ui, *node, name, -1);
}

Submenu::~Submenu() {
    if (open_) end_menu(ui_);
}

namespace {

/// F10 opens the first menu, or closes the one that is open; a letter opens the menu that has it.
void take_bar_key(Ui& ui, MenuState& state, const Event& event) {
    if (event.kind != EventKind::key) return;
    const std::string_view shown(state.open_bar_menu.data());
    const bool open = !shown.empty() && ui.overlay_open(shown);
    if (event.key != Key::f10) {
        state.bar_letter = static_cast<char>(lower(static_cast<char32_t>(event.key)));
    } else if (open) {
        ui.close_overlays_over(shown);
        ui.close_overlay(shown);
    } else {
        state.bar_want = 0;
        state.bar_by_key = true;
    }
}

}  // namespace

MenuBar::MenuBar(Ui& ui) : ui_(ui) {
    Node& node = ui.open(Role::menu_bar, "Menu bar", Axis::x, Sense::hover);  // known in the next build by its id
    node.size[0] = grow();
    node.padding[0] = node.padding[2] = static_cast<std::uint8_t>(ui.em(0.3F));
    ui.draw_with<draw_bar>(node, ui.theme().panel);
    ui.follow_size(node);
    MenuState& state = state_of(ui);
    state.bar_index = 0;
    state.bar_text = 0;
    state.bar_letter = 0;
    state.bar_letters = 0;
    state.bar_pad = ui.em(0.6F);
    ui.events_of(node.id, [&](const Event& event) { take_bar_key(ui, state, event); });
    // In a narrow window titles are closer to each other, so that none is cut.
    const float width = ui.rect_before(node.id).w;
    const float room = width - 2 * ui.em(0.3F) - state.bar_texts;
    if (width > 0 && state.bar_count > 0 && room < 2 * static_cast<float>(state.bar_count) * state.bar_pad)
        state.bar_pad = std::max(ui.em(0.2F), std::floor(room / (2 * static_cast<float>(state.bar_count))));
}

MenuBar::~MenuBar() {
    MenuState& state = state_of(ui_);
    state.bar_count = state.bar_index;
    state.bar_texts = state.bar_text;
    ui_.close();
}

BarMenu::BarMenu(Ui& ui, std::string_view label) : ui_(ui) {
    MenuState& state = state_of(ui);
    const int index = state.bar_index++;
    const std::string_view name = ui.join({"menu bar/", label});
    const std::string_view other(state.open_bar_menu.data());
    bool open = ui.overlay_open(name);
    Node& node =
        ui.leaf(Role::menu_item, label, Sense::hover | Sense::press | Sense::focus | Sense::activate | Sense::arrows_y);
    const Id id = node.id;
    const float title = std::ceil(ui.text_width(node.shown));
    state.bar_text += title;
    node.size[0] = px(title + 2 * state.bar_pad);
    node.size[1] = px(ui.row_height());
    const Response r = ui.respond(node);
    bool opens = r.pressed || r.clicked, down = false;
    ui.events_of(id, [&](const Event& e) { down |= e.kind == EventKind::key && e.key == Key::down; });
    const std::size_t letter = letter_of(node.shown, state.bar_letters);
    const char32_t with_alt =
        letter < node.shown.size() ? lower<char32_t>(static_cast<unsigned char>(node.shown[letter])) : 0;
    if (with_alt != 0) state.bar_letters |= 1U << (with_alt - 'a');
    const bool by_letter = state.bar_letter != 0 && with_alt == static_cast<unsigned char>(state.bar_letter);
    if (opens) state.bar_by_key = false;
    if (by_letter) state.bar_by_key = true;
    opens = (opens && !r.released) || down || by_letter || state.bar_want == index;
    const bool another_open = !other.empty() && other != name && ui.overlay_open(other);
    if ((r.hovered || by_letter) && another_open) {
        ui.close_overlays_over(other);
        ui.close_overlay(other);
        opens = true;
    }
    if (state.bar_want == index) state.bar_want = -1;
    if (opens && !open) {
        open_menu(ui, name, {.side = Placement::Side::below, .anchor = id});
        const std::size_t size = std::min(name.size(), state.open_bar_menu.size() - 1);
        name.copy(state.open_bar_menu.data(), size);
        state.open_bar_menu[size] = 0;
        open = true;
    }
    node.is |= when(open, Is::expanded);
    const bool underlined = with_alt != 0 && has(ui.mods(), Mods::alt);
    ui.draw_with<draw_bar_item>(node, BarItemLook{ui.text_style(), letter, underlined});
    Node* menu = ui.open_overlay_node(name, Role::menu, label, Axis::y);
    open_ = menu != nullptr;
    if (open_) begin_menu(ui, *menu, name, index);
}

BarMenu::~BarMenu() {
    if (open_) end_menu(ui_);
}

}  // namespace lapfx::ui
