// Turns nodes into the draw list. If a node would draw the same as in the last frame, its instances are
// copied.
#include <cstring>

#include "ui/core/node.h"
#include "ui/core/ui.h"

namespace lapfx::ui {

namespace {

constexpr int most_unsettled = 3;  // frames in a row

bool same_number(const Number* a, const Number* b) {
    return a == b || (a != nullptr && b != nullptr && std::memcmp(a, b, sizeof(Number)) == 0);
}

/// Given that what they show of their labels is the same, which the text of most is.
bool same_text(const Node& a, const Node& b) {
    const auto is_shown = [](const Node& n) {
        return n.text.data() == n.shown.data() && n.text.size() == n.shown.size();
    };
    return (is_shown(a) && is_shown(b)) || a.text == b.text;
}

/// Compares all that a draw function may use, except its look.
bool same_node(const Node& a, const Node& b) {
    return a.drawer == b.drawer && a.id == b.id && a.is == b.is && a.role == b.role && a.rect() == b.rect() &&
           a.clip == b.clip && a.layer == b.layer && std::memcmp(a.padding, b.padding, sizeof a.padding) == 0 &&
           a.scroll == nullptr && a.shown == b.shown && same_text(a, b) && same_number(a.number, b.number);
}

}  // namespace

const FrameOutput& Ui::emit() {
    std::swap(list_, shown_);
    // `shown_` belongs to the nodes of the last build only if no build lies between.
    const DrawnWith now{&theme(), input_.scale, fonts_.atlas().resets, build_};
    reuse_ = drawn_with_ == DrawnWith{now.theme, now.scale, now.resets, build_ - 1};
    drawn_anew_ = !reuse_;
    Painter painter(list_, fonts_, theme(), input_.scale);
    painter.start(input_.size);
    draw_all(painter, true);
    painter.finish(options_.images);
    drawn_with_ = now;
    if (fonts_.atlas().resets != now.resets) drawn_with_ = {};  // grew while drawing
    output_.changed = !take_shown();
    if (queue_head_ < queue_.size()) wake_at(time(), "events left");
    // A UI that never comes to rest must not keep the machine busy for ever.
    if (unsettled_ > 0 && unsettled_ <= most_unsettled) wake_at(time(), "not yet at rest");
    const bool missing = fonts_.full();
    if (missing && !letters_missing_) wake_at(time(), "letters are missing");
    letters_missing_ = missing;
    remember_anchors();
    if (const char* reason = woken_.exchange(nullptr); reason != nullptr) wake_at(time(), reason);
    tree_ = &nodes();
    fresh_ = true;
    return output_;
}

/// As long as all instances are equal to those of the last frame, none are copied: their places stay empty. This call
/// ends that and copies the first `count`.
void Ui::copy_kept_places(std::uint32_t count) {
    if (drawn_anew_) return;
    drawn_anew_ = true;
    if (count > 0)
        std::memcpy(static_cast<void*>(list_.instances.data()), shown_.instances.data(), count * sizeof(Instance));
}

/// Whether the picture is the last one.
bool Ui::take_shown() {
    if (drawn_anew_) return same_picture(list_, shown_);
    if (same_frame(list_, shown_)) {
        std::swap(list_, shown_);  // its instances are there
        return true;
    }
    copy_kept_places(static_cast<std::uint32_t>(list_.instances.size()));
    return false;
}

void Ui::redraw(DrawList& list) {
    Painter painter(list, fonts_, theme(), input_.scale);
    painter.start(input_.size);
    draw_all(painter, false);
    painter.finish(options_.images);
}

void Ui::draw_all(Painter& painter, bool keep) {
    painter.clear({0, 0, window().x, window().y}, theme().window);
    draw_layer(0, static_cast<std::uint32_t>(nodes().size()), 0, painter, keep);
    for (const std::uint32_t root : overlay_roots_) {
        if (root != no_node) draw_layer(root, nodes()[root].end, nodes()[root].layer, painter, keep);
    }
}

void Ui::draw_node(std::uint32_t index, bool bottom, Painter& painter, bool keep) {
    Node& node = nodes()[index];
    painter.set_clip(node.clip);
    painter.begin_node(bottom);
    if (reuse_ && keep && node.drawer->same != nullptr && index < nodes_before().size()) {
        const Node& old = nodes_before()[index];
        if (old.instances != Node::not_kept && same_node(node, old) && node.drawer->same(node.arg, old.arg)) {
            const std::span<const Instance> kept{shown_.instances.data() + old.first_instance, old.instances};
            node.instances = old.instances;
            node.first_instance = old.first_instance;
            if (!drawn_anew_ && painter.instances() == old.first_instance && painter.keep_places(kept)) return;
            copy_kept_places(painter.instances());
            node.first_instance = painter.copy(kept);
            return;
        }
    }
    node.drawer->draw(painter, node, node.arg);
    if (!keep) return;
    if (painter.instances() != painter.node_begin()) copy_kept_places(painter.node_begin());
    if (node.drawer->same == nullptr) return;
    const bool plain = painter.drawn_plainly(node.first_instance);
    node.instances = plain ? painter.instances() - node.first_instance : Node::not_kept;
}

void Ui::draw_layer(std::uint32_t from, std::uint32_t to, std::uint8_t layer, Painter& painter, bool keep) {
    std::vector<std::uint32_t>& open = drawn_later_;
    open.clear();
    const auto finish_until = [&](std::uint32_t index) {
        while (!open.empty() && nodes()[open.back()].end <= index) {
            const Node& node = nodes()[open.back()];
            painter.set_clip(node.clip);
            painter.begin_node(false);
            if (keep) copy_kept_places(painter.instances());
            node.draw_over(painter, node, node.arg);
            open.pop_back();
        }
    };
    std::uint32_t ringed = no_node;
    std::uint32_t covered_until = layer == 0 ? from : to;  // by what is placed over other things, such as a picture
    for (std::uint32_t i = from; i < to;) {
        const Node& node = nodes()[i];
        if (node.overlay && i != from) {  // has its own turn
            i = node.end;
            continue;
        }
        finish_until(i);
        const bool seen = node.rect().overlaps(node.clip);
        if (!seen && node.clips) {
            i = node.end;
            continue;
        }
        if (node.placed && node.drawer != nullptr) covered_until = std::max(covered_until, node.end);
        if (seen && node.drawer != nullptr) draw_node(i, i >= covered_until, painter, keep);
        if (seen && node.draw_over != nullptr) open.push_back(i);
        if (has(node.is, Is::ringed)) ringed = i;
        if (options_.debug && has(node.is, Is::duplicate)) {
            painter.set_clip(node.clip);
            if (keep) copy_kept_places(painter.instances());
            painter.frame(node.rect(), theme().error, 2 * painter.hairline());
        }
        ++i;
    }
    finish_until(to);
    if (ringed == no_node || nodes()[ringed].layer != layer) return;
    if (keep) copy_kept_places(painter.instances());
    const Node& node = nodes()[ringed];
    painter.set_clip(node.clip);
    painter.begin_node(false);
    const float width = 2 * painter.hairline();
    // Outside of it: on what is in the accent colour it could not be seen.
    painter.frame(node.rect().inset(-width), theme().focus, width, em(theme().radius) + width);
}

}  // namespace lapfx::ui
