#include "ui/core/layout.h"

namespace lapfx::ui {

namespace {

float pads(const Node& node, int a) {
    return static_cast<float>(node.padding[a] + node.padding[a + 2]);
}
bool flows(const Node& node) {
    return !node.placed && !node.overlay;
}

/// The size that each node asks for, children before parents. `content` is the sum of its children along its axis, else
/// the largest of them.
void wish(std::span<Node> nodes, int a) {
    for (std::size_t i = nodes.size(); i-- > 0;) {
        Node& node = nodes[i];
        const bool along = static_cast<int>(node.axis) == a;
        if (along && node.in_flow > 1) node.content[a] += node.gap * static_cast<float>(node.in_flow - 1);
        const bool fits =
            node.size[a].kind == SizeKind::fit;  // an area that scrolls only where there is too little room
        const float needs = node.scrolls[a] && !fits ? 0.0F : node.content[a] + pads(node, a);
        node.extent[a] = std::max(node.size[a].kind == SizeKind::px ? node.size[a].value : needs, node.minimum[a]);
        if (node.parent == no_node || node.overlay) continue;
        Node& parent = nodes[node.parent];
        if (node.placed) {
            parent.has_placed = true;
            continue;
        }
        if (a == 0) ++parent.in_flow;
        const SizeKind kind = node.size[a].kind;
        parent.flexible[a] |= kind == SizeKind::grow || kind == SizeKind::fraction;
        float& sum = parent.content[a];
        sum = static_cast<int>(parent.axis) == a ? sum + node.extent[a] : std::max(sum, node.extent[a]);
    }
}

struct Shares {
    float taken = 0, weights = 0, can_shrink = 0, least = 0;  ///< least: of those that grow
};

constexpr float unshared = -1;  // extent of a child whose share is not yet known

Shares count_shares(std::span<Node> nodes, const Node& node, int a, float inside) {
    Shares all{.taken = node.in_flow > 0 ? node.gap * static_cast<float>(node.in_flow - 1) : 0.0F};
    for (std::uint32_t c = node.first; c != no_node; c = nodes[c].next) {
        Node& child = nodes[c];
        if (!flows(child)) continue;
        if (child.size[a].kind == SizeKind::grow) {
            all.weights += child.size[a].value;
            all.least += child.minimum[a];
            child.extent[a] = unshared;
            continue;
        }
        if (child.size[a].kind == SizeKind::fraction)
            child.extent[a] = std::max(inside * child.size[a].value, child.minimum[a]);
        all.taken += child.extent[a];
        if (!child.rigid) all.can_shrink += child.extent[a] - child.minimum[a];
    }
    return all;
}

/// A child whose share is below its minimum gets the minimum, and the others share the rest; repeated until no share is
/// too small.
void share_what_is_left(std::span<Node> nodes, const Node& node, int a, float left, float weights) {
    for (bool again = true; again;) {
        again = false;
        for (std::uint32_t c = node.first; c != no_node; c = nodes[c].next) {
            Node& child = nodes[c];
            if (!flows(child) || child.extent[a] != unshared) continue;
            if (weights > 0 && left * child.size[a].value / weights >= child.minimum[a]) continue;
            child.extent[a] = child.minimum[a];
            left -= child.minimum[a];
            weights -= child.size[a].value;
            again = true;
        }
    }
    for (std::uint32_t c = node.first; c != no_node; c = nodes[c].next) {
        Node& child = nodes[c];
        if (flows(child) && child.extent[a] == unshared) child.extent[a] = left * child.size[a].value / weights;
    }
}

/// Along the axis: fractions, shares of the room that is left, and shrinking where there is too little room.
void share_out(std::span<Node> nodes, const Node& node, int a, float inside) {
    const Shares all = count_shares(nodes, node, a, inside);
    float left = inside - all.taken;
    if (left < all.least && all.can_shrink > 0 && !node.scrolls[a]) {
        const float part = std::min(1.0F, (all.least - left) / all.can_shrink);
        for (std::uint32_t c = node.first; c != no_node; c = nodes[c].next) {
            Node& child = nodes[c];
            if (flows(child) && !child.rigid && child.size[a].kind != SizeKind::grow)
                child.extent[a] -= (child.extent[a] - child.minimum[a]) * part;
        }
        left += all.can_shrink * part;
    }
    share_what_is_left(nodes, node, a, left, all.weights);
}

void put_along(std::span<Node> nodes, const Node& node, int a, float inside) {
    float cursor = node.at[a] + static_cast<float>(node.padding[a]);
    if (node.main == ChildAlign::center || node.main == ChildAlign::end) {
        float all = node.in_flow > 0 ? node.gap * static_cast<float>(node.in_flow - 1) : 0.0F;
        for (std::uint32_t c = node.first; c != no_node; c = nodes[c].next) {
            if (flows(nodes[c])) all += nodes[c].extent[a];
        }
        const float left = std::max(0.0F, inside - all);
        cursor += node.main == ChildAlign::center ? left / 2 : left;
    }
    if (node.scrolls[a] && node.scroll != nullptr) cursor -= whole(node.scroll->offset[a]);
    for (std::uint32_t c = node.first; c != no_node; c = nodes[c].next) {
        Node& child = nodes[c];
        if (!flows(child)) continue;
        const float next = cursor + child.extent[a];
        child.at[a] = whole(cursor);  // both edges are rounded, not the width: neighbours always touch
        child.extent[a] = std::max(0.0F, whole(next) - child.at[a]);
        cursor = next + node.gap;
    }
}

void put_across(std::span<Node> nodes, const Node& node, int a, float inside) {
    const float from = node.at[a] + static_cast<float>(node.padding[a]) -
                       (node.scrolls[a] && node.scroll != nullptr ? whole(node.scroll->offset[a]) : 0.0F);
    for (std::uint32_t c = node.first; c != no_node; c = nodes[c].next) {
        Node& child = nodes[c];
        if (!flows(child)) continue;
        const SizeKind kind = child.size[a].kind;
        if (kind == SizeKind::fraction) child.extent[a] = inside * child.size[a].value;
        if (kind == SizeKind::grow || (kind == SizeKind::fit && node.cross == ChildAlign::stretch)) {
            child.extent[a] = node.scrolls[a] ? std::max(inside, child.extent[a]) : inside;
        } else if (!child.rigid && !node.scrolls[a]) {
            child.extent[a] = std::min(child.extent[a], inside);
        }
        child.extent[a] = whole(std::max(child.extent[a], child.minimum[a]));
        const float left = inside - child.extent[a];
        const float shift = node.cross == ChildAlign::center ? left / 2 : node.cross == ChildAlign::end ? left : 0.0F;
        child.at[a] = whole(from + shift);
    }
}

void put_placed(Node& child, const Node& parent, int a) {
    const Placement& p = *child.placement;
    if (child.size[a].kind == SizeKind::fraction) child.extent[a] = parent.extent[a] * child.size[a].value;
    if (child.size[a].kind == SizeKind::grow) child.extent[a] = parent.extent[a] - p.offset[a];
    child.extent[a] = std::max(0.0F, whole(child.extent[a]));
    child.at[a] = whole(parent.at[a] + parent.extent[a] * p.fraction[a] + p.offset[a] - child.extent[a] * p.pivot[a]);
}

/// Beside its anchor where there is room, else on the other side; always within the window.
void put_overlay(std::span<Node> nodes, Node& node, std::uint32_t anchor, int a, float window) {
    using Side = Placement::Side;
    const Placement& p = *node.placement;
    Rect rect = p.rect;
    if (anchor != no_node) rect = nodes[anchor].rect();
    const float low = a == 0 ? rect.x : rect.y, length = a == 0 ? rect.w : rect.h;
    float& extent = node.extent[a];
    if (node.size[a].kind == SizeKind::fraction) extent = window * node.size[a].value;
    extent = whole(std::min(extent, window));
    const bool primary = (p.side == Side::below && a == 1) || (p.side == Side::right_of && a == 0);
    float at = low + p.offset[a];
    if (primary) {
        at = low + length + p.offset[a];
        if (at + extent > window && low - p.offset[a] - extent >= 0) at = low - p.offset[a] - extent;
    } else if (p.side == Side::center || (p.side == Side::top && a == 0)) {
        at = (window - extent) / 2;
    } else if (p.side == Side::top) {
        at = p.offset[a];
    } else if (p.side == Side::bottom_right) {
        at = window - extent - p.offset[a];
    }
    node.at[a] = whole(std::clamp(at, 0.0F, std::max(0.0F, window - extent)));
}

bool keep_scroll(Node& node, int a, float inside) {
    ScrollState& scroll = *node.scroll;
    // the build used another size to decide which rows are in sight and whether there is a scroll bar
    const bool resized = std::abs(scroll.content[a] - node.content[a]) > 0.5F || scroll.view[a] != inside;
    scroll.content[a] = node.content[a];
    scroll.view[a] = inside;
    const float most = std::max(0.0F, node.content[a] - inside);
    const float kept = node.scrolls[a] ? std::clamp(scroll.offset[a], 0.0F, most) : 0.0F;
    const bool moved = kept != scroll.offset[a];
    scroll.offset[a] = kept;
    return moved || resized;
}

std::uint32_t find_before(std::span<const Node> nodes, std::uint32_t index, Id id) {
    if (id == 0) return no_node;
    for (std::uint32_t i = index; i-- > 0;) {
        if (nodes[i].id == id) return i;
    }
    return no_node;
}

/// What is seen of the window through the nodes around it.
void clip(std::span<Node> nodes, Node& node, const Rect& window) {
    if (node.parent == no_node || node.overlay) {
        node.clip = window;
        return;
    }
    const Node& parent = nodes[node.parent];
    node.clip = parent.clips ? intersect(parent.clip, parent.rect()) : parent.clip;
}

/// Parents before children; `placed(node)` once the node itself has its place along this axis.
template <typename Placed>
bool put(std::span<Node> nodes, int a, float window, Placed&& placed) {
    bool moved = false;
    nodes[0].at[a] = 0;
    nodes[0].extent[a] = window;
    for (std::uint32_t i = 0; i < nodes.size(); ++i) {
        Node& node = nodes[i];
        if (node.overlay) put_overlay(nodes, node, find_before(nodes, i, node.placement->anchor), a, window);
        placed(node);
        if (node.first == no_node && node.scroll == nullptr) continue;
        const float inside = std::max(0.0F, node.extent[a] - pads(node, a));
        if (node.scroll != nullptr) moved |= keep_scroll(node, a, inside);
        if (node.first == no_node) continue;
        if (static_cast<int>(node.axis) == a) {
            if (node.flexible[a] || (node.content[a] > inside && !node.scrolls[a])) share_out(nodes, node, a, inside);
            put_along(nodes, node, a, inside);
        } else {
            put_across(nodes, node, a, inside);
        }
        for (std::uint32_t c = node.has_placed ? node.first : no_node; c != no_node; c = nodes[c].next) {
            if (nodes[c].placed) put_placed(nodes[c], node, a);
        }
    }
    return moved;
}

}  // namespace

bool lay_out(Ui& ui, std::span<Node> nodes, glm::vec2 window) {
    wish(nodes, 0);
    bool moved = put(nodes, 0, window.x, [&ui](Node& node) {  // text that wraps: its height follows from its width
        if (node.height_for_width != nullptr) node.size[1] = px(node.height_for_width(ui, node, node.extent[0]));
    });
    wish(nodes, 1);
    const Rect all{0, 0, window.x, window.y};
    moved |= put(nodes, 1, window.y, [&](Node& node) { clip(nodes, node, all); });
    return moved;
}

}  // namespace lapfx::ui
