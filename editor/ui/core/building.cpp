#include "ui/core/building.h"

#include <cassert>
#include <utility>

#include "ui/core/node.h"

namespace lapfx::ui {

TextStyle Building::text_style(float relative_size, Weight weight) const {
    return {.size = em(relative_size), .weight = weight};
}

TextStyle Building::number_style() const {
    return {.size = em(1), .tabular = true};
}

Node& Building::parent() {
    return nodes()[stack_.back().node];
}

Node& Building::last() {
    return nodes().back();
}

void Building::follow_size(const Node& node) {
    followed_.push_back(static_cast<std::uint32_t>(&node - nodes().data()));
}

const Node* Building::in_place_before() const {
    const std::size_t index = built_[now_].size();
    return index < nodes_before().size() ? &nodes_before()[index] : nullptr;
}

void Building::set_drawer(Node& node, const Drawer& drawer, const void* look) {
    node.arg = look;
    node.drawer = &drawer;
}

/// The id of the next node, which would be `base`, were it not for another of that label.
Id Building::claim(Id base, bool& duplicate) {
    const auto index = static_cast<std::uint32_t>(nodes().size());
    std::vector<Node>& old = built_[1 - now_];
    // Nearly all nodes have the index that they had in the last build. The table then needs no change, and reading it
    // would miss the cache.
    if (index < old.size() && old[index].id == base && !old[index].moved) return base;
    Seen* seen = &seen_.at(base, *this);
    while (index_now(*seen) != no_node) {  // the second of one name is told from the first
        duplicate = true;
        Seen& first = seen_.at(base, *this);
        if (std::exchange(first.ordinal_build, build_) != build_) first.ordinal = 0;
        const std::uint32_t ordinal = ++first.ordinal;
        seen = &seen_.at(hash_bytes(base + ordinal, {}), *this);
    }
    seen->before = seen->node < old.size() && old[seen->node].id == seen->id ? seen->node : no_node;
    if (seen->before != no_node) old[seen->before].moved = true;
    seen->node = index;
    return seen->id;
}

std::uint32_t Building::index_now(const Seen& seen) const {
    return seen.node < built_[now_].size() && built_[now_][seen.node].id == seen.id ? seen.node : no_node;
}

std::uint32_t Building::index_now(Id id) const {
    const Seen* seen = id == 0 ? nullptr : seen_.find(id);
    return seen == nullptr ? no_node : index_now(*seen);
}

std::uint32_t Building::index_before(const Seen& seen) const {
    const std::vector<Node>& old = nodes_before();
    for (const std::uint32_t index : {seen.node, seen.before}) {
        if (index < old.size() && old[index].id == seen.id) return index;
    }
    return no_node;
}

std::uint32_t Building::index_before(Id id) const {
    if (id == 0) return no_node;
    const std::size_t newest = built_[now_].size() - 1;  // whose widget asks, as a rule
    if (newest < nodes_before().size() && nodes_before()[newest].id == id) return static_cast<std::uint32_t>(newest);
    const Seen* seen = seen_.find(id);
    return seen == nullptr ? no_node : index_before(*seen);
}

const Node* Building::before(Id id) const {
    const std::uint32_t index = index_before(id);
    return index == no_node ? nullptr : &nodes_before()[index];
}

Node& Building::add(Role role, std::string_view text, Sense sense, bool overlay) {
    const auto index = static_cast<std::uint32_t>(nodes().size());
    const Level level = stack_.back();
    bool duplicate = false;
    Label label{};
    Id id = 0;
    if (!text.empty()) {
        label = split_label(arena().copy(text));
        if (sense != Sense::none || role == Role::panel || role == Role::group)
            id = claim(hash_bytes(level.seed, label.key), duplicate);
    }
    static const Node empty;  // copied: clearing 256 bytes is a string instruction, three times slower
    Node& node = nodes().emplace_back(empty);
    node.id = id;
    node.has_events = id != 0 && has_events(id);
    node.role = role;
    node.sense = sense;
    node.label = label.name;
    node.shown = label.shown;
    node.end = index + 1;
    node.parent = level.node;
    node.layer = level.layer;
    node.overlay = overlay;
    if (duplicate) node.is |= Is::duplicate, ++duplicates_now_;
    if (disabled_ > 0 && sense != Sense::none) {
        node.is |= Is::disabled;
        node.sense = Sense::hover;
    }
    if (level.node != no_node && !overlay) {
        Node& parent = nodes()[level.node];
        if (parent.first == no_node) {
            parent.first = index;
        } else {
            nodes()[parent.last].next = index;
        }
        parent.last = index;
    }
    return node;
}

Node& Building::leaf(Role role, std::string_view label, Sense sense) {
    return add(role, label, sense, false);
}

Node& Building::open(Role role, std::string_view label, Axis axis, Sense sense) {
    Node& node = add(role, label, sense, false);
    node.axis = axis;
    const Level& level = stack_.back();
    Id seed = node.id != 0 ? node.id : level.seed;
    if (node.id == 0 && !label.empty()) seed = hash_bytes(level.seed, split_label(label).key);
    stack_.push_back({static_cast<std::uint32_t>(nodes().size() - 1), seed, level.layer});
    return node;
}

void Building::close() {
    assert(stack_.size() > 1 && "close() without open()");
    nodes()[stack_.back().node].end = static_cast<std::uint32_t>(nodes().size());
    stack_.pop_back();
}

void Building::push_seed(std::string_view key) {
    Level level = stack_.back();
    level.seed = hash_bytes(level.seed, key);
    stack_.push_back(level);
}

void Building::push_seed(std::uint64_t key) {
    Level level = stack_.back();
    level.seed = hash_bytes(level.seed ^ (key * 0x9e3779b97f4a7c15ULL), {});
    stack_.push_back(level);
}

void Building::push_disabled(bool disabled) {
    if (disabled || disabled_ > 0) ++disabled_;
}

std::string_view Building::join(std::initializer_list<std::string_view> parts) {
    std::size_t size = 0;
    for (const std::string_view part : parts) size += part.size();
    char* to = static_cast<char*>(arena().take(size, 1));
    std::size_t at = 0;
    for (const std::string_view part : parts) {
        if (!part.empty()) std::memcpy(to + at, part.data(), part.size());
        at += part.size();
    }
    return {to, size};
}

Rect Building::rect_before(Id id) const {
    const Node* node = before(id);
    return node == nullptr ? Rect{} : node->rect();
}

Response Building::respond(Node& node) {
    Response r;
    const Id id = node.id;
    const bool concerned =
        node.has_events || id == hot_ || id == focus_ || id == active_[0] || id == active_[1] || id == active_[2];
    if (!concerned) {  // nearly all nodes
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

void Building::take(Response& r, const Node& node, const Event& event) {
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
