// Sends events to widgets: finds the node that an event is for among those of the last build, before the program builds
// again.
#include <algorithm>
#include <utility>

#include "ui/core/node.h"
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

/// Takes events up to and including the next key or button; later ones wait for a UI that knows of this one.
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

/// Whether this character opens an entry, which the next character is for.
bool Ui::opens_entry(const Event& event) {
    const Node* node = event.kind == EventKind::text ? before(focus_) : nullptr;
    return node != nullptr && !has(node->sense, Sense::editing);
}

/// The topmost node there that has any of `senses`. An overlay hides the nodes under it.
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
    // A press outside the top overlay closes it and does nothing else.
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
        // a command of a menu is for the node that had the keyboard before; a notice never has it
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

/// The wheel goes to the innermost node that uses it: a field with Ctrl, a canvas, or a scroll area that is not at its
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
    // This key has moved the focus, as a shortcut or as the space that chose an item. Its letter is not for the node
    // that has the focus now.
    if (std::exchange(key_came_, false) && typed_for_ != focus_) return;
    const Node* node = before(focus_);
    if (node == nullptr || (node->role == Role::combo && !ringed_)) return;
    const char32_t c = event.codepoint;
    // Characters that an expression can begin with. Letters count unless they are a shortcut: "sqrt(16)" must not
    // become "(16)".
    const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
    const bool number = (c >= '0' && c <= '9') || c == '-' || c == '+' || c == '.' || c == ',' || c == '(' ||
                        c == '=' || (letter && !key_ran_shortcut_);
    if (has(node->sense, Sense::typing) || has(node->sense, Sense::editing) ||
        (has(node->sense, Sense::digits) && number && ringed_))
        return send(focus_, event);
    // What is typed while a popup is open is for its text field, as "#8a4a3c" in a colour picker.
    if (has(node->sense, Sense::digits) || c <= U' ' || has(event.mods, Mods::command)) return;
    if (const Id field = text_field_of_popup(); field != 0) {
        set_focus(field, true);
        send(field, event);
    }
}

/// The first text field of the popup on top; 0: there is no popup, or none in it.
Id Ui::text_field_of_popup() const {
    if (overlays_.empty() || overlays_.back().kind != OverlayKind::popup) return 0;
    for (const Node& node : nodes_before())
        if (node.layer == overlays_.size() && node.role == Role::text_field && has(node.sense, Sense::typing))
            return node.id;
    return 0;
}

void Ui::route_drop(Event& event) {
    const std::uint32_t index = hit(nodes_before(), event.at, Sense::drop);
    if (index == no_node) {
        dropped_ = event.paths;
    } else {
        send(nodes_before()[index].id, event);
    }
}

}  // namespace lapfx::ui
