#include "ui/shell/toast.h"

#include <algorithm>
#include <utility>

#include "ui/core/paragraph.h"
#include "ui/widgets/basic.h"

namespace lapfx::ui {

namespace {

constexpr std::string_view overlay = "toasts";
constexpr Sense card_sense = Sense::hover | Sense::press | Sense::focus | Sense::activate | Sense::arrows_y |
                             Sense::erase | Sense::escape;  // in no Tab order: take_focus()
constexpr float width = 24;                                 // em
constexpr float inset = 0.7F;                               // em around the text
constexpr float stripe = 0.2F;                              // em, in the colour of the kind
constexpr float mark = 1.7F;                                // em of the icon and what is beside it

double seconds_of(const Toast& toast) {
    if (toast.seconds >= 0) return toast.seconds;
    switch (toast.kind) {
        case ToastKind::error:
            return 0;
        case ToastKind::warning:
            return 10;
        default:
            return 5;
    }
}

Tone tone_of(ToastKind kind) {
    switch (kind) {
        case ToastKind::good:
            return Tone::good;
        case ToastKind::warning:
            return Tone::warning;
        case ToastKind::error:
            return Tone::error;
        default:
            return Tone::normal;
    }
}

Icon icon_of(ToastKind kind) {
    switch (kind) {
        case ToastKind::good:
            return Icon::check;
        case ToastKind::warning:
            return Icon::warning;
        case ToastKind::error:
            return Icon::error;
        default:
            return Icon::info;
    }
}

struct ToastLook {
    Icon icon;
    Color tint;
    TextStyle style;
};

void draw_toast(Painter& painter, const Node& node, const ToastLook& look) {
    const Theme& t = painter.theme();
    const float radius = painter.em(t.radius);
    painter.shadow(node.rect(), t.shadow, painter.em(0.9F), radius);
    painter.fill(node.rect(), has(node.is, Is::hovered) ? t.field_hover : t.raised, radius);
    painter.frame(node.rect(), t.border, painter.hairline(), radius);
    Rect rect = node.rect();
    painter.fill(rect.cut_left(painter.em(stripe)), look.tint, radius);
    rect = rect.inset(painter.em(inset), painter.em(inset));
    const Rect icon = rect.cut_left(painter.em(mark));
    painter.icon({icon.x, icon.y, painter.em(1.1F), painter.fonts().metrics(look.style).height}, look.icon, look.tint);
    draw_paragraph(painter, rect, node.text, look.style, t.text);
}

struct ActionLook {
    TextStyle style;
};

void draw_action(Painter& painter, const Node& node, const ActionLook& look) {
    const Theme& t = painter.theme();
    if (has(node.is, Is::hovered)) painter.fill(node.rect(), t.control_hover, painter.em(t.radius));
    painter.text(node.rect(), node.shown, look.style, has(node.is, Is::hovered) ? t.text : t.text_link, Align::center);
}

}  // namespace

void Toasts::add(Toast toast) {
    const double seconds = seconds_of(toast);
    const auto same = std::find_if(all_.begin(), all_.end(), [&](const Shown& each) {
        return each.toast.kind == toast.kind && each.toast.text == toast.text;
    });
    added_ = true;
    if (same != all_.end()) {
        same->toast = std::move(toast);
        same->left = seconds;
        same->counting = false;
        ++same->count;
        return;
    }
    all_.push_back({.toast = std::move(toast), .left = seconds, .count = 1, .serial = ++serial_});
}

/// Of those that are seen; the others wait.
void Toasts::count_down(double passed) {
    const auto end = all_.begin() + static_cast<std::ptrdiff_t>(std::min(all_.size(), most_shown));
    const auto over = [passed](Shown& each) {
        if (each.left <= 0 || !std::exchange(each.counting, true)) return false;
        each.left -= passed;
        return each.left <= 0;
    };
    all_.erase(std::remove_if(all_.begin(), end, over), end);
}

bool Toasts::build_one(Ui& ui, const Shown& shown, std::function<void()>& act) {
    const Toast& toast = shown.toast;
    const TextStyle style = ui.text_style();
    ui.push_seed(shown.serial);
    Node& card = ui.open(Role::status, toast.text, Axis::x, card_sense);
    ids_.push_back(card.id);
    const std::string count = shown.count > 1 ? " (" + std::to_string(shown.count) + ")" : std::string();
    card.text = ui.join({toast.text, count});
    card.main = Place::end;
    card.cross = Place::end;
    const float pads = ui.em(stripe) + 2 * ui.em(inset) + ui.em(mark);
    float height = paragraph_height(ui.fonts(), card.text, style, ui.em(width) - pads) + 2 * ui.em(inset);
    const float row = ui.row_height() + ui.em(0.3F);
    if (!toast.action.empty()) height += row;
    card.size[0] = px(ui.em(width));
    card.size[1] = px(std::max(height, ui.row_height()));
    for (std::uint8_t& pad : card.padding) pad = static_cast<std::uint8_t>(std::min(ui.em(0.4F), 255.0F));
    const Response r = ui.respond(card);
    ui.draw_with<draw_toast>(card, ToastLook{icon_of(toast.kind), color_of(ui.theme(), tone_of(toast.kind)), style});
    bool gone = r.clicked;
    hovered_ |= r.hovered || r.focused;
    if (r.clicked && !r.released) act = toast.act;  // Enter is its button
    if (!toast.action.empty()) {
        Node& action = ui.leaf(Role::link, toast.action, Sense::hover | Sense::press);
        action.size[0] = px(std::ceil(ui.text_width(action.shown)) + 2 * ui.em(0.6F));
        action.size[1] = px(ui.row_height());
        const Response a = ui.respond(action);
        ui.draw_with<draw_action>(action, ActionLook{ui.text_style(1, Weight::medium)});
        hovered_ |= a.hovered;
        if (a.clicked) act = toast.act;
        gone |= a.clicked;
    }
    ui.close();
    ui.pop_seed();
    return gone;
}

/// After all have been built. `gone`: the one that goes in this build, or how many there are.
void Toasts::take_keys(Ui& ui, bool wants_focus, std::size_t& gone) {
    const std::size_t count = ids_.size();
    const auto here = static_cast<std::size_t>(std::find(ids_.begin(), ids_.end(), ui.focus()) - ids_.begin());
    if (wants_focus && here == count) before_ = ui.focus();
    if (wants_focus) return ui.set_focus(here == count ? ids_.back() : before_, true);
    if (here == count) return;
    Key key = Key::none;
    ui.events_of(ids_[here], [&](const Event& event) {
        if (event.kind == EventKind::key) key = event.key;
    });
    if (key == Key::escape) ui.set_focus(before_, true);
    if (key == Key::up && here > 0) ui.set_focus(ids_[here - 1], true);
    if (key == Key::down && here + 1 < count) ui.set_focus(ids_[here + 1], true);
    if (key == Key::del || key == Key::backspace) gone = here;
    if (gone == here) ui.set_focus(count == 1 ? before_ : here > 0 ? ids_[here - 1] : ids_[1], ui.focus_ringed());
}

void Toasts::build(Ui& ui) {
    const bool wants_focus = std::exchange(wants_focus_, false);
    count_down(hovered_ ? 0.0 : std::max(0.0, ui.time() - time_));
    time_ = ui.time();
    hovered_ = false;
    if (std::exchange(added_, false))  // on top of what may have been opened since
        ui.open_overlay(
            overlay, OverlayKind::passive,
            {.side = Placement::Side::bottom_right, .offset = {ui.em(0.8F), ui.row_height() + ui.em(0.8F)}});
    if (all_.empty()) return ui.close_overlay(overlay);
    Node* root = ui.open_overlay_node(overlay, Role::group, "Notices", Axis::y);
    if (root == nullptr) return;
    root->gap = ui.em(0.5F);
    const std::size_t count = std::min(all_.size(), most_shown);
    std::size_t gone = count;
    std::function<void()> act;  // called last: it may add another
    ids_.clear();
    for (std::size_t i = 0; i < count; ++i) {
        if (build_one(ui, all_[i], act)) gone = i;
    }
    ui.close_overlay_node();
    take_keys(ui, wants_focus, gone);
    if (act && gone < count && ui.focus_ringed()) ui.set_focus(before_, true);
    if (gone < count) {
        all_.erase(all_.begin() + static_cast<std::ptrdiff_t>(gone));
        ui.wake_at(ui.time(), "toast");
    }
    for (std::size_t i = 0; !hovered_ && i < std::min(all_.size(), most_shown); ++i) {
        if (all_[i].left > 0) ui.wake_at(ui.time() + all_[i].left, "toast");
    }
    if (act) act();
}

}  // namespace lapfx::ui
