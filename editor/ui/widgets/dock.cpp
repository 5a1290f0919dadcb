#include "ui/widgets/dock.h"

#include <charconv>

#include "ui/core/node.h"
#include "ui/widgets/menu.h"
#include "ui/widgets/splitter.h"
#include "ui/widgets/tabs.h"

namespace lapfx::ui {

namespace {

constexpr float edge_share = 0.25F;  // of a leaf, from each side: a panel dropped there goes next to it

struct DockLook {
    Rect preview;
};

void draw_ground(Painter& painter, const Node& node, const void*) {
    const Color ground = painter.theme().window;
    painter.ground(node.rect(), ground);
}

void draw_preview(Painter& painter, const Node&, const void* arg) {
    const Rect& rect = static_cast<const DockLook*>(arg)->preview;
    if (rect.empty()) return;
    const Theme& t = painter.theme();
    painter.fill(rect, with_alpha(t.focus, 0.25F), painter.em(t.radius));
    painter.frame(rect, t.focus, 2 * painter.hairline(), painter.em(t.radius));
}

DockSide side_at(const Rect& leaf, glm::vec2 p, float tabs_height) {
    if (p.y < leaf.y + tabs_height) return DockSide::center;
    const glm::vec2 f = (p - leaf.at()) / glm::max(leaf.size(), glm::vec2(1));
    const float to[] = {f.x, 1 - f.x, f.y, 1 - f.y};
    const auto nearest = std::min_element(std::begin(to), std::end(to));
    if (*nearest > edge_share) return DockSide::center;
    constexpr DockSide sides[] = {DockSide::left, DockSide::right, DockSide::top, DockSide::bottom};
    return sides[nearest - std::begin(to)];
}

Rect half_of(Rect leaf, DockSide side) {
    switch (side) {
        case DockSide::left:
            return leaf.cut_left(std::round(leaf.w / 2));
        case DockSide::right:
            return leaf.cut_right(std::round(leaf.w / 2));
        case DockSide::top:
            return leaf.cut_top(std::round(leaf.h / 2));
        case DockSide::bottom:
            return leaf.cut_bottom(std::round(leaf.h / 2));
        default:
            return leaf;
    }
}

/// A change of the arrangement, which is made after all has been built.
struct Wish {
    enum class Kind : std::uint8_t { none, front, close, move, show } kind = Kind::none;
    int leaf = -1, tab = -1;
    int to = -1, position = -1;
    DockSide side = DockSide::center;
    std::string_view panel = {};  // a closed panel that `show` puts into leaf `to`
};

/// The panel whose tab the menu was opened at.
struct MenuOf {
    std::string panel;
};

/// The panel whose tab was pressed: its picture gets the keyboard once it is built.
struct Pressed {
    std::string panel;
};

bool is_picture(const Node& node) {
    const bool shown = node.role == Role::canvas || node.role == Role::image || node.role == Role::timeline ||
                       node.role == Role::plot || node.role == Role::curve;
    return shown && has(node.sense, Sense::focus);
}

struct Drop {
    int leaf = -1, position = -1;
    DockSide side = DockSide::center;
};

std::size_t held_open(const DockLayout& layout) {
    std::size_t count = 0;
    for (const DockNode& node : layout.nodes) count += node.tabs.size();
    return count;
}

/// One dock while it is built.
struct Making {
    Ui& ui;
    DockLayout& layout;
    std::span<const std::string_view> panels;
    const FunctionRef<void(std::size_t)>& build;
    const DockOptions& options;
    Id id;        // of the dock
    Rect* rects;  // rectangles of the nodes, px within the dock
    int* places;  // place of the pointer among the tabs of each leaf
    DockEvents& events;
    Wish wish = {};
    std::string_view context = {};  // the panel whose tab has just been clicked with the right button
    int grabbed_leaf = -1, grabbed_tab = -1;

    DockNode& node(int index) { return layout.nodes[static_cast<std::size_t>(index)]; }
    std::string_view numbered(std::string_view word, int index) const {
        char buffer[16];
        const auto end = std::to_chars(buffer, buffer + sizeof buffer, index).ptr;
        return ui.join({word, {buffer, static_cast<std::size_t>(end - buffer)}});
    }
    float least(int index, int a) const;
    void arrange(int index, const Rect& rect);
    void leaf(int index);
    void focus_picture(std::string_view panel);
    void menu();
    void edges();
    Drop drop_at(glm::vec2 pointer, const Rect& whole);
    void turn_pages(const Rect& whole);
    void fulfil();
};

/// The least size, px, that a node needs.
float Making::least(int index, int a) const {
    const DockNode& n = layout.nodes[static_cast<std::size_t>(index)];
    if (n.leaf()) return ui.em(options.minimum) + (a == 1 ? ui.row_height() : 0.0F);
    const float first = least(n.first, a), second = least(n.second, a);
    return static_cast<int>(n.axis) == a ? first + second + splitter_gap(ui) : std::max(first, second);
}

void Making::arrange(int index, const Rect& rect) {
    rects[index] = rect;
    DockNode& n = node(index);
    if (n.leaf()) return;
    const int a = static_cast<int>(n.axis);
    const float gap = splitter_gap(ui);
    const Split split{std::max(0.0F, (a == 0 ? rect.w : rect.h) - gap), least(n.first, a), least(n.second, a), 0.5F};
    events.resized |= drag_splitter(ui, ui.id_of(numbered("edge ", index)), n.axis, split, n.fraction);
    Rect rest = rect;
    const float first = split.first(n.fraction);
    const Rect before = a == 0 ? rest.cut_left(first) : rest.cut_top(first);
    a == 0 ? rest.cut_left(gap) : rest.cut_top(gap);
    arrange(n.first, before);
    arrange(n.second, rest);
}

void Making::leaf(int index) {
    DockNode& n = node(index);
    const Rect& rect = rects[index];
    Node& box = ui.open(Role::none, {}, Axis::y);
    box.placed = true;
    box.placement = ui.arena().make(Placement{.offset = rect.at()});
    box.size[0] = px(rect.w);
    box.size[1] = px(rect.h);
    box.clips = true;
    const std::size_t count = n.tabs.size();
    auto* names = static_cast<std::string_view*>(ui.arena().take(count * sizeof(std::string_view)));
    for (std::size_t i = 0; i < count; ++i) new (names + i) std::string_view(n.tabs[i]);
    n.active = std::clamp(n.active, 0, std::max(0, static_cast<int>(count) - 1));
    const bool closable = options.closable && (count > 1 || layout.nodes.size() > 1);
    const TabEvents tabs =
        tab_strip(ui, numbered("tabs##", index), n.active, {names, count}, {.closable = closable, .draggable = true});
    places[index] = tabs.place;
    if (tabs.grabbed >= 0) grabbed_leaf = index, grabbed_tab = tabs.grabbed;
    if (tabs.context >= 0) context = names[static_cast<std::size_t>(tabs.context)];
    if (tabs.chosen >= 0) wish = {.kind = Wish::Kind::front, .leaf = index, .tab = tabs.chosen};
    if (tabs.closed >= 0) wish = {.kind = Wish::Kind::close, .leaf = index, .tab = tabs.closed};
    if (tabs.dropped >= 0) wish = {.kind = Wish::Kind::move, .leaf = index, .tab = tabs.dropped};
    if (tabs.pressed >= 0) ui.memory<Pressed>(id).panel = names[static_cast<std::size_t>(tabs.pressed)];
    if (count > 0) {
        const std::string_view front = names[static_cast<std::size_t>(n.active)];
        const auto panel = static_cast<std::size_t>(std::find(panels.begin(), panels.end(), front) - panels.begin());
        const Panel ground(ui, front, {.width = grow(), .height = grow(), .padding = options.padding});
        if (panel < panels.size()) build(panel);
        focus_picture(front);
    }
    ui.close();
}

/// After a press on its tab the keys are for what the panel shows, so that arrows turn a view. A panel without a
/// picture leaves the keyboard to the tab.
void Making::focus_picture(std::string_view panel) {
    std::string& pressed = ui.memory<Pressed>(id).panel;
    if (pressed.empty() || pressed != panel) return;
    pressed.clear();
    for (const Node* node = &ui.parent(); node <= &ui.last(); ++node)
        if (is_picture(*node)) return ui.set_focus(node->id);
}

/// The menu of a tab. It closes the tab's panel, or shows a closed panel next to it.
void Making::menu() {
    const std::string_view name = ui.join({"tabs of ", {reinterpret_cast<const char*>(&id), sizeof id}});
    const bool closable = options.closable && held_open(layout) > 1;
    if (!context.empty() && (closable || !layout.closed.empty())) {
        ui.memory<MenuOf>(id).panel = context;
        open_menu(ui, name, {.side = Placement::Side::pointer, .rect = {ui.pointer().x, ui.pointer().y, 0, 0}});
    }
    const Menu menu(ui, name, "Panels");
    if (!menu) return;
    const std::string& panel = ui.memory<MenuOf>(id).panel;
    const int leaf = layout.find(panel);
    if (leaf < 0) return;
    const std::vector<std::string>& tabs = node(leaf).tabs;
    const int tab = static_cast<int>(std::find(tabs.begin(), tabs.end(), panel) - tabs.begin());
    if (menu_item(ui, ui.join({"Close ", panel, "##close"}), {.icon = Icon::cross, .enabled = closable}))
        wish = {.kind = Wish::Kind::close, .leaf = leaf, .tab = tab};
    if (!layout.closed.empty()) menu_separator(ui);
    for (const std::string& closed : layout.closed) {
        if (menu_item(ui, ui.join({"Show ", closed}))) wish = {.kind = Wish::Kind::show, .to = leaf, .panel = closed};
    }
}

void Making::edges() {
    for (int i = 0; i < static_cast<int>(layout.nodes.size()); ++i) {
        const DockNode& n = node(i);
        if (n.leaf()) continue;
        const Rect& first = rects[n.first];
        const glm::vec2 at = n.axis == Axis::x ? glm::vec2(first.right(), first.y) : glm::vec2(first.x, first.bottom());
        put_splitter(ui, numbered("edge ", i), n.axis, at, n.axis == Axis::x ? first.h : first.w, n.fraction);
    }
}

/// The place to which the dragged panel would go; leaf -1: nowhere.
Drop Making::drop_at(glm::vec2 pointer, const Rect& whole) {
    const glm::vec2 p = pointer - whole.at();
    for (int i = 0; i < static_cast<int>(layout.nodes.size()); ++i) {
        if (!node(i).leaf() || !rects[i].contains(p)) continue;
        const bool in_tabs = p.y < rects[i].y + ui.row_height();
        const Drop drop{i, in_tabs ? places[i] : -1, side_at(rects[i], p, ui.row_height())};
        const bool same = i == grabbed_leaf || i == wish.leaf;
        if (same && (node(i).tabs.size() == 1 || (drop.side == DockSide::center && !in_tabs))) return {};
        return drop;
    }
    return {};
}

/// Ctrl+PageUp and Ctrl+PageDown choose among the tabs of the group that has the keyboard.
void Making::turn_pages(const Rect& whole) {
    ui.events_of(id, [&](const Event& event) {
        if (event.kind != EventKind::key) return;
        const glm::vec2 at = (ui.focus() != 0 ? ui.rect_before(ui.focus()).center() : ui.pointer()) - whole.at();
        for (int i = 0; i < static_cast<int>(layout.nodes.size()); ++i) {
            const int count = static_cast<int>(node(i).tabs.size());
            if (!node(i).leaf() || count < 2 || !rects[i].contains(at)) continue;
            const int to = (node(i).active + (event.key == Key::page_down ? 1 : count - 1)) % count;
            wish = {.kind = Wish::Kind::front, .leaf = i, .tab = to};
        }
    });
}

void Making::fulfil() {
    if (wish.kind == Wish::Kind::none || (wish.kind == Wish::Kind::move && wish.to < 0)) return;
    const bool show = wish.kind == Wish::Kind::show;
    const std::string name(show ? wish.panel : node(wish.leaf).tabs[static_cast<std::size_t>(wish.tab)]);
    if (wish.kind == Wish::Kind::front) node(wish.leaf).active = wish.tab;
    if (wish.kind == Wish::Kind::close) layout.close(name);
    if (wish.kind == Wish::Kind::move || show) layout.move(name, wish.to, wish.side, wish.position);
    events.arranged = true;
    ui.build_again();
}

std::size_t held_by(const DockLayout& layout) {
    return held_open(layout) + layout.closed.size();
}

}  // namespace

DockEvents dock(Ui& ui, std::string_view label, DockLayout& layout, std::span<const std::string_view> panels,
                const FunctionRef<void(std::size_t)>& build, const DockOptions& options) {
    if (layout.nodes.empty() || held_by(layout) != panels.size()) layout.fit(panels);
    DockEvents events;
    Node& outer = ui.open(Role::group, label, Axis::y, Sense::tab_keys);
    const Id id = outer.id;
    outer.size[0] = outer.size[1] = grow();
    outer.rigid = false;
    outer.clips = true;
    ScrollState& known =
        ui.memory<ScrollState>(id);  // how much room there is; the frame is built again when it changes
    outer.scroll = &known;
    DockLook* look = ui.arena().make(DockLook{});
    outer.arg = look;
    static constexpr Drawer drawer{draw_ground, nullptr};
    outer.drawer = &drawer;
    outer.draw_over = draw_preview;

    const std::size_t count = layout.nodes.size();
    auto* rects = static_cast<Rect*>(ui.arena().take(count * sizeof(Rect)));
    auto* places = static_cast<int*>(ui.arena().take(count * sizeof(int)));
    std::uninitialized_fill_n(rects, count, Rect{});
    std::uninitialized_fill_n(places, count, 0);
    Making making{ui, layout, panels, build, options, id, rects, places, events};
    making.arrange(0, {0, 0, known.view.x, known.view.y});
    for (std::size_t i = 0; i < count; ++i) {
        if (layout.nodes[i].leaf()) making.leaf(static_cast<int>(i));
    }
    making.edges();
    making.menu();

    const Rect whole = ui.rect_before(id);
    making.turn_pages(whole);
    if (making.grabbed_leaf >= 0 || making.wish.kind == Wish::Kind::move) {
        const Drop drop = making.drop_at(ui.pointer(), whole);
        if (drop.leaf >= 0) {
            making.wish.to = drop.leaf, making.wish.side = drop.side, making.wish.position = drop.position;
            if (making.grabbed_leaf >= 0) look->preview = half_of(rects[drop.leaf], drop.side).moved(whole.at());
        }
        ui.set_cursor(Cursor::move);
    }
    ui.close();
    making.fulfil();
    return events;
}

}  // namespace lapfx::ui
