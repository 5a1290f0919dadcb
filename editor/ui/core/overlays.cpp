#include "ui/core/overlays.h"

#include <algorithm>
#include <cassert>

#include "ui/core/node.h"

namespace lapfx::ui {

namespace {

constexpr Id overlay_seed = 0x6f7665726c617973ULL;
Id key_of(std::string_view name) {
    return hash_bytes(overlay_seed, name);
}

}  // namespace

void Overlays::open_overlay(std::string_view name, OverlayKind kind, const Placement& placement) {
    const Id key = key_of(name);
    std::erase_if(overlays_, [&](const Overlay& o) { return o.key == key; });
    // A menu or a list cannot be used while a dialog lies over it: it closes, and its opener gets the keyboard back.
    if (kind == OverlayKind::modal) close_popups();
    assert(overlays_.size() < 200);
    overlays_.push_back({.key = key,
                         .kind = kind,
                         .placement = placement,
                         .opener_focus = focus_,
                         .opened_build = build_,
                         .built = 0,
                         .wants_focus = kind != OverlayKind::passive});
    again_ = true;
}

void Overlays::close_overlay(std::string_view name) {
    const auto at =
        std::find_if(overlays_.begin(), overlays_.end(), [&](const Overlay& o) { return o.key == key_of(name); });
    if (at == overlays_.end()) return;
    if (at->kind != OverlayKind::passive) set_focus(at->opener_focus, ringed_);
    overlays_.erase(at);
    again_ = true;
}

/// The top one that is not passive; a submenu with those it came from.
void Overlays::close_top_overlay() {
    for (std::size_t i = overlays_.size(); i-- > 0;) {
        if (overlays_[i].kind != OverlayKind::passive) return close_overlay_at(i);
    }
}

void Overlays::close_overlay_at(std::size_t index) {
    set_focus(overlays_[index].opener_focus, ringed_);
    overlays_.erase(overlays_.begin() + static_cast<std::ptrdiff_t>(index));
    again_ = true;
}

/// Those that are on top, down to a dialog.
void Overlays::close_popups() {
    for (std::size_t i = overlays_.size(); i-- > 0 && overlays_[i].kind != OverlayKind::modal;)
        if (overlays_[i].kind != OverlayKind::passive) close_overlay_at(i);
}

bool Overlays::close_overlays_over(std::string_view name) {
    const auto at =
        std::find_if(overlays_.begin(), overlays_.end(), [&](const Overlay& o) { return o.key == key_of(name); });
    if (at == overlays_.end()) return false;
    const auto over =
        std::count_if(at + 1, overlays_.end(), [](const Overlay& o) { return o.kind != OverlayKind::passive; });
    for (auto i = over; i > 0; --i) close_top_overlay();
    return over > 0;
}

bool Overlays::overlay_on_top(std::string_view name) const {
    const auto top = std::find_if(overlays_.rbegin(), overlays_.rend(),
                                  [](const Overlay& o) { return o.kind != OverlayKind::passive; });
    return top != overlays_.rend() && top->key == key_of(name);
}

bool Overlays::overlay_open(std::string_view name) const {
    return std::any_of(overlays_.begin(), overlays_.end(), [&](const Overlay& o) { return o.key == key_of(name); });
}

Node* Overlays::open_overlay_node(std::string_view name, Role role, std::string_view label, Axis axis) {
    const auto at =
        std::find_if(overlays_.begin(), overlays_.end(), [&](const Overlay& o) { return o.key == key_of(name); });
    if (at == overlays_.end()) return nullptr;
    at->built = build_;
    const auto layer = static_cast<std::size_t>(at - overlays_.begin());
    if (overlay_roots_.size() <= layer) overlay_roots_.resize(layer + 1, no_node);
    stack_.push_back({0, key_of(name), static_cast<std::uint8_t>(layer + 1)});
    Node& node = add(role, label, Sense::none, true);
    const auto index = static_cast<std::uint32_t>(nodes().size() - 1);
    node.axis = axis;
    node.placement = arena().make(at->placement);
    if (at->kind == OverlayKind::modal) {
        node.is |= Is::modal;
        node.sense = Sense::chords;
        node.id = at->key;  // not by its label, which a button in it may have, too
    }
    overlay_roots_[layer] = index;
    stack_.back().node = index;
    return &node;
}

/// Keeps the rectangle of the widget that an overlay belongs to, in case it is scrolled away or no longer built.
void Overlays::remember_anchors() {
    for (Overlay& overlay : overlays_) {
        const std::uint32_t anchor = index_now(overlay.placement.anchor);
        if (anchor != no_node) overlay.placement.rect = nodes()[anchor].rect();
    }
}

void Overlays::drop_overlays_not_built() {
    for (std::size_t i = overlays_.size(); i-- > 0;) {
        // an overlay opened in this build is built in the next if its opener comes after the code that builds it
        if (overlays_[i].built == build_ || overlays_[i].opened_build == build_) continue;
        const Overlay gone = overlays_[i];
        overlays_.erase(overlays_.begin() + static_cast<std::ptrdiff_t>(i));
        if (i < overlay_roots_.size()) overlay_roots_.erase(overlay_roots_.begin() + static_cast<std::ptrdiff_t>(i));
        if (gone.kind != OverlayKind::passive) set_focus(gone.opener_focus, ringed_);
        again_ = true;
    }
}

void Overlays::focus_new_overlay() {
    for (std::size_t i = 0; i < overlays_.size(); ++i) {
        Overlay& overlay = overlays_[i];
        if (!overlay.wants_focus || overlay.built != build_ || overlay_roots_[i] == no_node) continue;
        overlay.wants_focus = false;
        const std::uint32_t root = overlay_roots_[i];
        for (std::uint32_t n = root; n < nodes()[root].end; ++n) {
            if (nodes()[n].layer != nodes()[root].layer || !has(nodes()[n].sense, Sense::focus)) continue;
            set_focus(nodes()[n].id, ringed_);
            break;
        }
        again_ = true;
    }
}

/// The layer of the overlay that has the keyboard; 0: the window.
std::uint8_t Overlays::focus_layer() const {
    for (std::size_t i = overlays_.size(); i-- > 0;) {
        if (overlays_[i].kind != OverlayKind::passive) return static_cast<std::uint8_t>(i + 1);
    }
    return 0;
}

}  // namespace lapfx::ui
