#include "ui/shell/toast.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/core/node.h"
#include "ui/core/paragraph.h"
#include "ui/shell/dialog.h"
#include "ui/value/closed_list.h"
#include "ui/widgets/literal.h"
#include "ui/widgets/scroll.h"

namespace lapfx::ui {

namespace {

constexpr std::string_view overlay = "toasts", log_name = "notices log";
constexpr Sense card_sense = Sense::hover | Sense::press | Sense::focus | Sense::activate | Sense::arrows_y |
                             Sense::erase | Sense::escape;  // Tab does not reach it, see take_focus()
constexpr float widest = 24;                                // em
constexpr float edge = 0.8F;                                // em, to the window's edges and the status bar
constexpr float gap = 0.5F;                                 // em, between two
constexpr float inset = 0.7F;                               // em around the text
constexpr float stripe = 0.2F;                              // em, in the colour of the kind
constexpr float mark = 1.7F;                                // em of the icon and what is beside it
constexpr double minute = 60;                               // s

/// px of a notice's width that its text does not get.
float beside_text(const Ui& ui) {
    return ui.em(stripe) + 2 * ui.em(inset) + ui.em(mark) + ui.row_height();
}

constexpr struct {
    ToastKind value;
    Tone tone;
    Icon icon;
    double seconds;  ///< how long it stays; 0: until it is closed
} kinds[] = {
    {ToastKind::info, Tone::normal, Icon::info, 5},
    {ToastKind::good, Tone::good, Icon::check, 5},
    {ToastKind::warning, Tone::warning, Icon::warning, 10},
    {ToastKind::error, Tone::error, Icon::error, 0},
};
static_assert(is_whole(kinds));

const auto& info_of(ToastKind kind) {
    return kinds[static_cast<std::size_t>(kind)];
}

double seconds_of(const Toast& toast) {
    return toast.seconds >= 0 ? toast.seconds : info_of(toast.kind).seconds;
}

struct ToastLook {
    Icon icon;
    Color tint;
    TextStyle style;
    float close;        ///< px, width of the button that closes it
    std::size_t bytes;  ///< how much of the text there is room for
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
    rect.cut_right(look.close);
    draw_paragraph(painter, rect, node.text.substr(0, look.bytes), look.style, t.text);
}

struct ActionLook {
    TextStyle style;
};

void draw_action(Painter& painter, const Node& node, const ActionLook& look) {
    const Theme& t = painter.theme();
    if (has(node.is, Is::hovered)) painter.fill(node.rect(), t.control_hover, painter.em(t.radius));
    painter.text(node.rect(), node.shown, look.style, has(node.is, Is::hovered) ? t.text : t.text_link, Align::center);
}

void draw_rest(Painter& painter, const Node& node, const ActionLook& look) {
    const Theme& t = painter.theme();
    painter.fill(node.rect(), has(node.is, Is::hovered) ? t.control_hover : t.raised, painter.em(t.radius));
    painter.frame(node.rect(), t.border, painter.hairline(), painter.em(t.radius));
    painter.text(node.rect(), node.shown, look.style, t.text_link, Align::center);
}

std::string_view words_of(Ui& ui, const std::string& text, int count) {
    return count > 1 ? ui.join({text, "  x", std::to_string(count)}) : std::string_view(text);
}

float width_in(const Ui& ui) {
    return std::min(ui.em(widest), ui.window().x - 2 * ui.em(edge));
}

/// px of the window's height that notices may take.
float room_in(const Ui& ui) {
    return ui.window().y - ui.row_height() - 2 * ui.em(edge);
}

/// The height, px, of a notice whose text is `text` px high.
float height_of(const Ui& ui, float text, bool action) {
    const float height = std::max(text + 2 * ui.em(inset), ui.row_height() + ui.em(inset));
    return action ? height + ui.row_height() + ui.em(0.3F) : height;
}

struct Measured {
    float height = 0;       ///< px, of the whole notice
    std::size_t bytes = 0;  ///< how much of its text there is room for
};

Measured measure(Ui& ui, std::string_view words, bool action) {
    const TextStyle style = ui.text_style();
    const float line = ui.fonts().metrics(style).height, across = width_in(ui) - beside_text(ui);
    const float whole = paragraph_height(ui.fonts(), words, style, across);
    const float most = room_in(ui) - ui.row_height() - ui.em(gap);  // the line that leads to the log is below
    if (height_of(ui, whole, action) <= most) return {height_of(ui, whole, action), words.size()};
    std::vector<std::uint32_t> begins;
    break_lines(ui.fonts(), words, style, across, begins);
    std::size_t lines = begins.size();
    while (lines > 1 && height_of(ui, static_cast<float>(lines) * line, action) > most) --lines;
    return {height_of(ui, static_cast<float>(lines) * line, action),
            lines < begins.size() ? begins[lines] : words.size()};
}

std::string ago(double seconds) {
    const auto minutes = static_cast<long>(seconds / minute);
    if (minutes < 1) return "just now";
    if (minutes < 60) return std::to_string(minutes) + " min ago";
    return std::to_string(minutes / 60) + " h ago";
}

}  // namespace

void Toasts::note(const Toast& toast) {
    if (!log_.empty() && log_.back().kind == toast.kind && log_.back().text == toast.text) {
        ++log_.back().count;
        log_.back().time = time_;
        return;
    }
    if (log_.size() == most_notes) log_.erase(log_.begin());
    log_.push_back({.kind = toast.kind, .text = toast.text, .time = time_});
}

void Toasts::add(Toast toast) {
    note(toast);
    const auto same = std::find_if(all_.begin(), all_.end(), [&](const ListedToast& each) {
        return each.toast.kind == toast.kind && each.toast.text == toast.text;
    });
    ListedToast shown;
    shown.left = seconds_of(toast);
    shown.serial = ++serial_;
    if (same != all_.end()) {
        shown.count = same->count + 1;
        shown.serial = same->serial;
        all_.erase(same);
    } else if (all_.size() == most_kept) {
        const auto passing =
            std::find_if(all_.begin(), all_.end(), [](const ListedToast& each) { return seconds_of(each.toast) > 0; });
        all_.erase(passing != all_.end() ? passing : all_.begin());
        ++hidden_;
    }
    shown.toast = std::move(toast);
    all_.push_back(std::move(shown));
    added_ = true;
}

void Toasts::open_log(Ui& ui) {
    hidden_ = 0;
    open_dialog(ui, log_name);
}

/// Counts down the time of the notices that are visible; the others wait.
void Toasts::count_down(double passed) {
    std::erase_if(all_, [passed](ListedToast& each) {
        if (each.left <= 0 || !each.seen) return false;
        each.left -= passed;
        return each.left <= 0;
    });
}

/// The first notice that is shown: as many of the newest as there is room for.
std::size_t Toasts::first_in_sight(Ui& ui) const {
    const float rest = ui.row_height() + ui.em(gap);
    float room = room_in(ui);
    std::size_t first = all_.size();
    while (first > 0) {
        const ListedToast& each = all_[first - 1];
        const float needs =
            measure(ui, words_of(ui, each.toast.text, each.count), !each.toast.action.empty()).height + ui.em(gap);
        const bool none_left = first == 1 && hidden_ == 0;
        if (first < all_.size() && needs + (none_left ? 0.0F : rest) > room) break;
        room -= needs;
        --first;
    }
    return first;
}

Toasts::Answer Toasts::build_one(Ui& ui, ListedToast& shown) {
    const Toast& toast = shown.toast;
    const TextStyle style = ui.text_style();
    shown.seen = true;
    ui.push_seed(shown.serial);
    Node& card = ui.open(Role::status, toast.text, Axis::y, card_sense);
    const Id id = card.id;
    ids_.push_back(id);
    card.text = ui.copy(words_of(ui, toast.text, shown.count));
    card.cross = ChildAlign::end;
    const Measured measured = measure(ui, card.text, !toast.action.empty());
    card.size[0] = px(width_in(ui));
    card.size[1] = px(measured.height);
    for (std::uint8_t& pad : card.padding) pad = static_cast<std::uint8_t>(std::min(ui.em(0.3F), 255.0F));
    const Response r = ui.respond(card);
    ui.draw_with<draw_toast>(card, ToastLook{info_of(toast.kind).icon, color_of(ui.theme(), info_of(toast.kind).tone),
                                             style, ui.row_height(), measured.bytes});
    Answer answer{.gone = r.clicked};
    hovered_ |= r.hovered || r.focused;
    if (r.clicked && !r.released) answer.act = toast.act;  // Enter presses its button
    ui.events_of(id,
                 [&](const Event& event) { answer.gone |= event.kind == EventKind::key && event.key == Key::escape; });
    const bool closes =
        icon_button(ui, Icon::cross, "Close", {.tip = "Closes it; All notices keeps it", .quiet = true});
    ui.last().sense = Sense::hover | Sense::press;  // Tab does not reach it: keys close it by Esc
    hovered_ |= has(ui.last().is, Is::hovered);
    answer.gone |= closes;
    if (!toast.action.empty()) {
        spacer(ui);
        Node& action = ui.leaf(Role::link, toast.action, Sense::hover | Sense::press);
        action.size[0] = px(std::ceil(ui.text_width(action.shown)) + 2 * ui.em(0.6F));
        action.size[1] = px(ui.row_height());
        const Response a = ui.respond(action);
        ui.draw_with<draw_action>(action, ActionLook{ui.text_style(1, Weight::medium)});
        hovered_ |= a.hovered;
        if (a.clicked) answer = {.gone = true, .act = toast.act};
    }
    ui.close();
    ui.pop_seed();
    return answer;
}

/// The line that leads to the notices for which there is no room.
void Toasts::build_rest(Ui& ui, std::size_t out_of_sight) {
    const std::size_t count = hidden_ + out_of_sight;
    bool cut = false;
    for (const ListedToast& each : all_)
        if (each.seen) {
            const std::string_view words = words_of(ui, each.toast.text, each.count);
            cut |= measure(ui, words, !each.toast.action.empty()).bytes < words.size();
        }
    if (count == 0 && !cut) return;
    const std::string number = std::to_string(count);
    Node& node = ui.leaf(Role::link,
                         count == 0 ? std::string_view("Read all of it in All notices##rest")
                                    : ui.join({number, " more in All notices##rest"}),
                         Sense::hover | Sense::press);
    node.size[0] = px(width_in(ui));
    node.size[1] = px(ui.row_height());
    node.tip = "All notices so far";
    const Response r = ui.respond(node);
    ui.draw_with<draw_rest>(node, ActionLook{ui.text_style(1, Weight::medium)});
    hovered_ |= r.hovered;
    if (r.clicked) open_log(ui);
}

void Toasts::build_log(Ui& ui) {
    Dialog dialog(ui, log_name, "All notices", {.width = 40, .height = 28});
    if (!dialog) return;
    {
        const ScrollArea area(ui, "Log", {.gap = 0.5F, .padding = 0.3F});
        if (log_.empty()) label(ui, "There are no notices yet.", {.tone = Tone::dim});
        for (std::size_t i = log_.size(); i-- > 0;) {
            const ToastNote& each = log_[i];
            const Row row(ui, {.width = grow(), .cross = ChildAlign::start});
            label(ui, ui.copy(ago(ui.time() - each.time)), {.tone = Tone::dim, .width = px(ui.em(6))});
            literal(ui, words_of(ui, each.text, each.count), info_of(each.kind).tone);
        }
    }
    const auto pressed = dialog.buttons({{.label = "Copy all", .enabled = !log_.empty() && ui.clipboard() != nullptr},
                                         {.label = "Clear", .enabled = !log_.empty()},
                                         {.label = "Close", .standard = true, .cancel = true}},
                                        true);
    if (pressed == 0) {
        std::string text;
        for (const ToastNote& each : log_) text.append(words_of(ui, each.text, each.count)) += '\n';
        ui.clipboard()->set(text);
    }
    if (pressed == 1) log_.clear();
    if (pressed == 2) dialog.close();
}

/// Called after all have been built. `gone` is the index of the notice that is closed in this build, or the number of
/// visible notices.
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
    if (key == Key::up && here > 0) ui.set_focus(ids_[here - 1], true);
    if (key == Key::down && here + 1 < count) ui.set_focus(ids_[here + 1], true);
    if (key == Key::del || key == Key::backspace) gone = here;
    if (gone == here) ui.set_focus(count == 1 ? before_ : here > 0 ? ids_[here - 1] : ids_[1], ui.focus_ringed());
}

void Toasts::build(Ui& ui) {
    build_log(ui);
    const bool wants_focus = std::exchange(wants_focus_, false);
    count_down(hovered_ ? 0.0 : std::max(0.0, ui.time() - time_));
    time_ = ui.time();
    hovered_ = false;
    if (std::exchange(added_, false))  // over anything that has been opened since
        ui.open_overlay(
            overlay, OverlayKind::passive,
            {.side = Placement::Side::bottom_right, .offset = {ui.em(edge), ui.row_height() + ui.em(edge)}});
    if (all_.empty()) {
        hidden_ = 0;
        return ui.close_overlay(overlay);
    }
    Node* root = ui.open_overlay_node(overlay, Role::group, "Notices", Axis::y);
    if (root == nullptr) return;
    root->gap = ui.em(gap);
    const std::size_t first = first_in_sight(ui), count = all_.size() - first;
    for (ListedToast& each : all_) each.seen = false;
    std::size_t gone = count;
    std::function<void()> act;  // called last, as it may add another notice
    ids_.clear();
    for (std::size_t i = 0; i < count; ++i) {
        Answer answer = build_one(ui, all_[first + i]);
        if (answer.gone) gone = i;
        if (answer.act) act = std::move(answer.act);
    }
    build_rest(ui, first);
    ui.close_overlay_node();
    take_keys(ui, wants_focus, gone);
    if (act && gone < count && ui.focus_ringed()) ui.set_focus(before_, true);
    if (gone < count) {
        all_.erase(all_.begin() + static_cast<std::ptrdiff_t>(first + gone));
        ui.wake_at(ui.time(), "toast");
    }
    for (const ListedToast& each : all_)
        if (!hovered_ && each.seen && each.left > 0) ui.wake_at(ui.time() + each.left, "toast");
    if (act) act();
}

}  // namespace lapfx::ui
