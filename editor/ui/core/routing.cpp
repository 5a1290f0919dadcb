// Events to widgets: who is meant is decided here, against the nodes of the last build, before the program builds the
// next.
#include <algorithm>
#include <utility>

#include "ui/core/ui.h"

namespace lapfx::ui {

namespace {

constexpr double double_click = 0.4;  // s between presses
constexpr float same_place = 4;       // px at scale 1 that a double click may move
constexpr float wheel_lines = 3;      // rows a notch
constexpr double scroll_ends = 0.5;   // s without the wheel

Sense sense_of(Button button) {
    return button == Button::left ? Sense::press : button == Button::middle ? Sense::middle : Sense::context;
}

bool finite(glm::vec2 v) {
    return std::isfinite(v.x) && std::isfinite(v.y);
}

}  // namespace

/// Everything up to and with the next key or button: the one after that is for a UI that knows of this one.
void Ui::take_events() {
    for (auto& each : routed_) each.second.paths.clear();
    routed_.clear();
    routing_ = true;
    for (const auto& [target, event] : late_) send(target, event);
    late_.clear();
    dropped_.clear();
    moved_ = {0, 0};
    while (queue_head_ < queue_.size()) {
        Event& event = queue_[queue_head_++];
        const bool discrete = event.kind == EventKind::press || event.kind == EventKind::release ||
                              event.kind == EventKind::key || event.kind == EventKind::drop || opens_entry(event);
        route(event);
        if (discrete) break;
    }
    if (queue_head_ == queue_.size()) queue_.clear(), queue_head_ = 0;
    routing_ = false;
    if (reveal_ != 0) reveal(std::exchange(reveal_, 0));
}

void Ui::route(Event& event) {
    if (!finite(event.at)) event.at = pointer_;
    if (!finite(event.delta)) event.delta = {0, 0};
    mods_ = event.mods;
    switch (event.kind) {
        case EventKind::pointer:
            return route_pointer(event);
        case EventKind::press:
            return route_press(event);
        case EventKind::release:
            return route_release(event);
        case EventKind::wheel:
            return route_wheel(event);
        case EventKind::text:
            return route_text(event);
        case EventKind::drop:
            return route_drop(event);
        case EventKind::key:
            if (std::find(keys_down_.begin(), keys_down_.end(), event.key) == keys_down_.end())
                keys_down_.push_back(event.key);
            typed_for_ = focus_, key_came_ = true;
            return route_key(event);
        case EventKind::key_up:
            std::erase(keys_down_, event.key);
            key_came_ = false;
            return;
        case EventKind::pointer_out:
            pointer_inside_ = false;
            return find_hot(nodes_before());
        case EventKind::focus_lost:
            keys_down_.clear();
            mods_ = Mods::none;
            return cancel_held();
        default:
            return;
    }
}

bool Ui::key_down(Key key) const {
    return std::find(keys_down_.begin(), keys_down_.end(), key) != keys_down_.end();
}

/// The first of what is typed: the next is for a text that is open.
bool Ui::opens_entry(const Event& event) {
    const Node* node = event.kind == EventKind::text ? before(focus_) : nullptr;
    return node != nullptr && !has(node->sense, Sense::editing);
}

void Ui::send(Id target, const Event& event) {
    if (target == 0) return;
    if (!routing_) {  // its widget may have been built already: in the next build it is told
        late_.emplace_back(target, event);
        again_ = true;
        return;
    }
    routed_.emplace_back(target, event);
    seen_.at(target).events = build_;
}

/// Topmost node there that senses any of `senses`. An overlay hides what lies under it.
std::uint32_t Ui::hit(std::span<const Node> all, glm::vec2 at, Sense senses) const {
    std::uint32_t best = no_node;
    int layer = -1, covered = -1, modal = 0;
    for (const Node& node : all) {
        if (!node.overlay) continue;
        if (has(node.is, Is::modal)) modal = std::max<int>(modal, node.layer);
        if (node.role != Role::tooltip && node.rect().contains(at)) covered = std::max<int>(covered, node.layer);
    }
    for (std::uint32_t i = static_cast<std::uint32_t>(all.size()); i-- > 0;) {
        const Node& node = all[i];
        if (node.layer <= layer || node.layer < covered || node.layer < modal) continue;
        if ((node.sense & senses) == Sense::none || !node.rect().contains(at) || !node.clip.contains(at)) continue;
        best = i;
        layer = node.layer;
    }
    return best;
}

void Ui::find_hot(std::span<const Node> all) {
    std::uint32_t index = no_node;
    if (pointer_inside_) index = hit(all, pointer_, Sense::hover | Sense::press | Sense::context | Sense::middle);
    const Id found = index == no_node ? 0 : all[index].id;
    const Id held_id = active_[0] != 0 ? active_[0] : active_[1] != 0 ? active_[1] : active_[2];
    hot_ = held_id != 0 && found != held_id ? 0 : found;
}

void Ui::route_pointer(const Event& event) {
    const glm::vec2 from = pointer_inside_ || held() != 0 ? pointer_ : event.at;
    pointer_ = event.at;
    pointer_inside_ = true;
    moved_ += pointer_ - from;
    if (glm::distance(pointer_, rested_at_) > 3.0F * scale()) rested_at_ = pointer_, rested_since_ = time();
    for (const Id id : active_) send(id, event);
    const Id before_id = hot_;
    find_hot(nodes_before());
    if (hot_ != before_id) rested_since_ = time(), pressed_hot_ = 0;
    if (pointer_ != from) ringed_ = ringed_ && held() == 0;
}

void Ui::cancel_held() {
    for (Id& id : active_) {
        if (id != 0) send(std::exchange(id, 0), {.kind = EventKind::cancel, .at = pointer_, .time = time()});
    }
    find_hot(nodes_before());
}

void Ui::route_press(Event& event) {
    route_pointer({.kind = EventKind::pointer, .mods = event.mods, .at = event.at, .time = event.time});
    rested_since_ = time();
    const bool held_already = active_[0] != 0 || active_[1] != 0 || active_[2] != 0;
    if (held_already) return cancel_held();
    ringed_ = false;
    pressed_hot_ = hot_;
    const std::uint32_t index = hit(nodes_before(), event.at, sense_of(event.button));
    const int layer = index == no_node ? -1 : nodes_before()[index].layer;
    // A press beside what lies on top closes it, and does nothing else.
    for (std::size_t i = overlays_.size(); i-- > 0;) {
        if (overlays_[i].kind == OverlayKind::passive) continue;
        bool inside = layer >= static_cast<int>(i) + 1;
        for (const Node& node : nodes_before())
            inside |= node.overlay && node.layer > i && node.rect().contains(event.at);
        if (inside) break;
        if (overlays_[i].kind == OverlayKind::modal) return;
        const bool chain = overlays_[i].kind == OverlayKind::submenu;
        close_top_overlay();
        if (!chain) return;
    }
    const Id target = index == no_node ? 0 : nodes_before()[index].id;
    const bool same = target == last_pressed_ && event.time - last_press_ < double_click &&
                      glm::distance(event.at, pressed_at_) <= same_place * scale();
    clicks_ = same && clicks_ < 3 ? clicks_ + 1 : 1;
    event.clicks = static_cast<std::uint8_t>(clicks_);
    last_press_ = event.time;
    last_pressed_ = target;
    pressed_at_ = event.at;
    moved_ = {0, 0};
    if (target == 0) {  // beside everything; within a menu or a dialog the keyboard stays where it is
        if (focus_layer() == 0) set_focus(0);
        return;
    }
    const Node& node = nodes_before()[index];
    active_[static_cast<int>(event.button)] = target;
    const std::size_t over = node.layer;
    const bool passive = over > 0 && over <= overlays_.size() && overlays_[over - 1].kind == OverlayKind::passive;
    if (node.role == Role::menu_item || passive) {
        // what is chosen from a menu is for what had the keyboard before; a notice never has it
    } else if (has(node.sense, Sense::focus)) {
        set_focus(target);
    } else if (node.role != Role::scroll_bar && node.role != Role::splitter) {
        set_focus(0);
    }
    send(target, event);
}

void Ui::route_release(const Event& event) {
    route_pointer({.kind = EventKind::pointer, .mods = event.mods, .at = event.at, .time = event.time});
    Id& active = active_[static_cast<int>(event.button)];
    if (active != 0) send(std::exchange(active, 0), event);
    find_hot(nodes_before());
}

/// To the innermost that can do something with it: a field with Ctrl, a canvas, a scroll area that has not come to its
/// end.
void Ui::route_wheel(const Event& event) {
    const bool scrolling = event.time - scrolled_at_ < scroll_ends;
    const double scrolled_before = std::exchange(scrolled_at_, event.time);
    const std::uint32_t over =
        hit(nodes_before(), pointer_, Sense::hover | Sense::press | Sense::wheel | Sense::command_wheel);
    for (std::uint32_t i = over; i != no_node; i = nodes_before()[i].overlay ? no_node : nodes_before()[i].parent) {
        const Node& node = nodes_before()[i];
        const bool by_focus = has(node.sense, Sense::focus_wheel) && node.id == focus_ && !scrolling;
        const bool wants = has(node.sense, Sense::wheel) || by_focus ||
                           (has(node.sense, Sense::command_wheel) && has(event.mods, Mods::command));
        if (wants && node.scroll == nullptr) {
            if (by_focus) scrolled_at_ = scrolled_before;
            return send(node.id, event);
        }
        if (node.scroll == nullptr || has(event.mods, Mods::command)) continue;
        ScrollState& scroll = *node.scroll;
        glm::vec2 by = event.delta * em(theme().row_height) * wheel_lines;
        if (has(event.mods, Mods::shift) && by.x == 0) by = {by.y, 0};
        for (int a = 0; a < 2; ++a) {
            if (!node.scrolls[a]) by[a] = 0;
        }
        const glm::vec2 most = glm::max(scroll.content - scroll.view, glm::vec2(0));
        const glm::vec2 next = glm::clamp(scroll.offset - by, glm::vec2(0), most);
        if (next == scroll.offset) continue;
        scroll.offset = next;
        again_ = true;
        return;
    }
}

void Ui::route_text(const Event& event) {
    // The key moved the focus, as a shortcut or as the space that chose: its letter is not meant for what has it now.
    if (std::exchange(key_came_, false) && typed_for_ != focus_) return;
    const Node* node = before(focus_);
    if (node == nullptr) return;
    const char32_t c = event.codepoint;
    // Of what an expression can begin with. Letters, too, unless they are a shortcut: "sqrt(16)" must not become
    // "(16)".
    const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
    const bool number = (c >= '0' && c <= '9') || c == '-' || c == '+' || c == '.' || c == ',' || c == '(' ||
                        c == '=' || (letter && !key_ran_shortcut_);
    if (has(node->sense, Sense::typing) || has(node->sense, Sense::editing) ||
        (has(node->sense, Sense::digits) && number && ringed_))
        send(focus_, event);
}

void Ui::route_drop(Event& event) {
    const std::uint32_t index = hit(nodes_before(), event.at, Sense::drop);
    if (index == no_node) {
        dropped_ = event.paths;
    } else {
        send(nodes_before()[index].id, event);
    }
}

void Ui::set_focus(Id id, bool by_keyboard) {
    ringed_ = by_keyboard && id != 0;
    if (id == focus_) return;
    send(std::exchange(focus_, id), {.kind = EventKind::focus_out, .time = time()});
    send(focus_, {.kind = EventKind::focus_in, .time = time()});
    rested_since_ = time();
    again_ = true;
}

/// In the layout that is known; what has just been built is revealed by the next build.
void Ui::reveal(Id id) {
    const std::uint32_t index = index_before(id);
    if (index == no_node || index >= nodes_before().size()) {
        reveal_ = id;
        again_ = true;
        return;
    }
    Rect rect = nodes_before()[index].rect();
    for (std::uint32_t i = nodes_before()[index].parent; i != no_node; i = nodes_before()[i].parent) {
        const Node& area = nodes_before()[i];
        if (area.overlay && area.scroll == nullptr) break;
        if (area.scroll == nullptr) continue;
        const Rect view = area.inside();
        for (int a = 0; a < 2; ++a) {
            if (!area.scrolls[a]) continue;
            const float low = a == 0 ? rect.x : rect.y, high = a == 0 ? rect.right() : rect.bottom();
            const float from = a == 0 ? view.x : view.y, to = a == 0 ? view.right() : view.bottom();
            const float by = low < from ? low - from : high > to ? std::min(high - to, low - from) : 0.0F;
            area.scroll->offset[a] += by;
            rect = rect.moved(a == 0 ? glm::vec2(-by, 0) : glm::vec2(0, -by));
            if (by != 0) again_ = true;
        }
    }
}

Response Ui::respond(Node& node) {
    Response r;
    const Id id = node.id;
    const bool concerned =
        node.has_events || id == hot_ || id == focus_ || id == active_[0] || id == active_[1] || id == active_[2];
    if (!concerned) {  // nearly all
        r.pointer = pointer_;
        r.mods = mods_;
        return r;
    }
    if (id == 0 || has(node.is, Is::disabled)) {
        if (id != 0 && id == hot_) node.is |= Is::hovered;
        return r;
    }
    r.hovered = id == hot_;
    r.focused = id == focus_;
    for (int b = 0; b < 3; ++b) {
        if (active_[b] == id) r.held = true, r.button = static_cast<Button>(b);
    }
    node.is |= when(r.hovered, Is::hovered) | when(r.held, Is::held) | when(r.focused, Is::focused) |
               when(r.focused && ringed_, Is::ringed);
    r.pointer = pointer_;
    r.pressed_at = pressed_at_;
    r.mods = mods_;
    if (r.held) r.drag = moved_;
    if (!node.has_events) return r;
    for (const auto& [target, event] : routed_) {
        if (target == id) take(r, node, event);
    }
    return r;
}

void Ui::take(Response& r, const Node& node, const Event& event) {
    r.mods = event.mods;
    switch (event.kind) {
        case EventKind::press:
            r.button = event.button;
            if (event.button == Button::left) r.pressed = true, r.clicks = event.clicks;
            if (event.button == Button::right) r.context = true;
            break;
        case EventKind::release:
            if (event.button != Button::left) break;
            r.released = true;
            r.drag = moved_;
            r.clicked |= rect_before(node.id).contains(event.at);
            break;
        case EventKind::key:
            if (event.key == Key::menu) r.context = true;
            if (has(node.sense, Sense::activate) && (event.key == Key::enter || event.key == Key::space))
                r.clicked = true;
            break;
        case EventKind::wheel:
            r.wheel += event.delta.y;
            break;
        case EventKind::cancel:
            r.cancelled = true;
            break;
        case EventKind::focus_in:
            r.focus_in = true, r.by_tab = event.key == Key::tab;
            break;
        case EventKind::focus_out:
            r.focus_out = true;
            break;
        default:
            break;
    }
}

}  // namespace lapfx::ui
