#include "ui/shell/dialog.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/core/node.h"
#include "ui/core/paragraph.h"
#include "ui/widgets/literal.h"
#include "ui/widgets/scroll.h"

namespace lapfx::ui {

namespace {

constexpr Id dialogs = 0x6469616c6f672e73ULL;
constexpr float shade = 0.5F;  // opacity of the layer over everything below

constexpr float least_button = 6;  // em

/// px
float button_width(Ui& ui, std::string_view label) {
    return std::max(std::ceil(ui.text_width(split_label(label).shown)) + 2 * ui.em(0.7F), ui.em(least_button));
}

struct DialogState {
    bool open = false;   ///< it was open in the last build
    bool waits = false;  ///< its standard button could not be pressed when it opened
    float row = 0;       ///< px that all its buttons side by side take, as they were last built
    bool fresh = false;  ///< no button has been given the keyboard yet
};

DialogState& state_of(Ui& ui, std::string_view name) {
    return ui.memory<DialogState>(hash_bytes(dialogs, name));
}

struct DialogLook {
    Color ground;
};

void draw_dialog(Painter& painter, const Node& node, const DialogLook& look) {
    const Theme& t = painter.theme();
    const float radius = painter.em(2 * t.radius);
    painter.fill(painter.clip(), with_alpha(t.shadow, shade));
    painter.shadow(node.rect(), t.shadow, painter.em(1.5F), radius);
    painter.fill(node.rect(), look.ground, radius);
    painter.frame(node.rect(), t.border, painter.hairline(), radius);
}

struct TitleLook {
    Icon icon;
    Color tint;
    TextStyle style;
};

void draw_title(Painter& painter, const Node& node, const TitleLook& look) {
    Rect rect = node.rect();
    if (look.icon != Icon::none) {
        painter.icon(rect.cut_left(painter.em(1.2F)), look.icon, look.tint);
        rect.cut_left(painter.em(0.6F));
    }
    draw_paragraph(painter, rect, node.text, look.style, painter.theme().text, Align::start);
}

TextStyle title_style(Ui& ui) {
    return ui.text_style(1.15F, Weight::bold);
}

float title_height(Ui& ui, const Node& node, float width) {
    const auto& look = *static_cast<const TitleLook*>(node.arg);
    const float icon = look.icon != Icon::none ? ui.em(1.8F) : 0;
    return std::max(ui.row_height(), paragraph_height(ui.fonts(), node.text, look.style, width - icon));
}

void put_title(Ui& ui, std::string_view title, const DialogOptions& options) {
    Node& node = ui.leaf(Role::heading, title);
    node.text = node.shown;
    node.size[0] = grow();
    ui.draw_with<draw_title>(node, TitleLook{options.icon, color_of(ui.theme(), options.tone), title_style(ui)});
    node.height_for_width = title_height;
}

/// Whether Enter was pressed in a text field of this dialog. The Enter that opened the dialog, in this same build, does
/// not count.
bool entered(Ui& ui) {
    const Node* node = ui.before(ui.focus());
    if (node == nullptr || node->role != Role::text_field || node->layer != ui.parent().layer) return false;
    bool enter = false;
    ui.events_of(ui.focus(), [&](const Event& e) { enter |= e.kind == EventKind::key && e.key == Key::enter; });
    return enter;
}

}  // namespace

void open_dialog(Ui& ui, std::string_view name) {
    ui.open_overlay(name, OverlayKind::modal, {.side = Placement::Side::center});
    state_of(ui, name).fresh = true;
}

Dialog::Dialog(Ui& ui, std::string_view name, std::string_view title, const DialogOptions& options)
    : ui_(ui), name_(ui.copy(name)) {
    DialogState& state = state_of(ui, name);
    Node* node = ui.open_overlay_node(name, Role::dialog, title, Axis::y);
    open_ = node != nullptr;
    cancelled_ = !open_ && state.open;
    state.open = open_;
    if (!open_) return;
    id_ = node->id;
    const float title_width = std::ceil(ui.fonts().run(split_label(title).shown, title_style(ui)).width) +
                              (options.icon != Icon::none ? ui.em(1.8F) : 0.0F);
    const float wish = std::max(ui.em(options.width), std::max(title_width, state.row) + 2 * ui.em(1));
    node->size[0] = px(std::min(wish, ui.window().x));
    if (options.height > 0) node->size[1] = px(std::min(ui.em(options.height), ui.window().y));
    for (std::uint8_t& pad : node->padding) pad = static_cast<std::uint8_t>(std::min(ui.em(1), 255.0F));
    node->gap = ui.em(0.8F);
    node->clips = true;
    ui.draw_with<draw_dialog>(*node, DialogLook{ui.theme().raised});
    put_title(ui, title, options);
    begin_body(options.height > 0);
}

Dialog::~Dialog() {
    if (!open_) return;
    end_body();
    ui_.close_overlay_node();
}

void Dialog::begin_body(bool grows) {
    ScrollState& state = ui_.memory<ScrollState>(hash_bytes(dialogs, name_));
    const float gap = ui_.parent().gap;
    Node& body = ui_.open(Role::none, {}, Axis::y);
    body.size[0] = grow();
    body.size[1] = grows ? grow() : fit();
    body.gap = gap;
    body.rigid = false;
    body.sense = Sense::wheel;
    body.scrolls[1] = true;
    body.scroll = &state;
    body.clips = state.content.y - state.view.y >= 1;  // focus rings may extend beyond it without clipping
    if (body.clips) body.padding[2] = static_cast<std::uint8_t>(std::min(ui_.em(1), 255.0F));
    body_ = &state;
}

void Dialog::end_body() {
    if (body_ == nullptr) return;
    scroll_bar(ui_, *body_);
    ui_.close();
    body_ = nullptr;
}

void Dialog::close() {
    ui_.close_overlays_over(name_);
    ui_.close_overlay(name_);
    state_of(ui_, name_).open = false;
}

/// How many of the buttons, from the first on, fit into a row: at least one.
std::size_t Dialog::buttons_in_row(std::span<const DialogButton> all) const {
    const Node& root = ui_.parent();
    float room = root.size[0].value - static_cast<float>(root.padding[0] + root.padding[2]);
    for (std::size_t i = 0; i < all.size(); ++i) {
        room -= button_width(ui_, all[i].label) + (i > 0 ? ui_.em(ui_.theme().gap) : 0.0F);
        if (room < 0) return std::max<std::size_t>(i, 1);
    }
    return all.size();
}

std::optional<std::size_t> Dialog::buttons(std::span<const DialogButton> all, bool stays) {
    if (!open_) return std::nullopt;
    end_body();
    std::optional<std::size_t> pressed;
    // A dialog is rather wider than that its last button stands alone in a second row.
    float side_by_side = 0;
    for (const DialogButton& one : all)
        side_by_side += button_width(ui_, one.label) + (side_by_side > 0 ? ui_.em(ui_.theme().gap) : 0.0F);
    if (std::exchange(state_of(ui_, name_).row, side_by_side) != side_by_side) ui_.build_again();
    Id first = 0, standard = 0, cancel = 0;
    bool has_standard = false;
    for (std::size_t begin = 0, end = 0; begin < all.size(); begin = end) {
        end = begin + buttons_in_row(all.subspan(begin));
        const Row row(ui_, {.width = grow(), .main = ChildAlign::end});
        for (std::size_t i = begin; i < end; ++i) {
            ui_.push_disabled(!all[i].enabled);
            if (button(ui_, all[i].label, {.tip = all[i].tip, .primary = all[i].standard})) pressed = i;
            ui_.pop_disabled();
            Node& node = ui_.last();
            node.minimum[0] = ui_.em(least_button);
            node.rigid = false;
            has_standard |= all[i].standard;
            if (!all[i].enabled) continue;
            if (first == 0) first = node.id;
            if (all[i].standard) standard = node.id;
            if (all[i].cancel) cancel = node.id;
            if (all[i].standard && !pressed && entered(ui_) && ui_.overlay_on_top(name_)) pressed = i;
        }
    }
    DialogState& state = state_of(ui_, name_);
    const Node* focused = ui_.before(ui_.focus());
    if (state.fresh && focused != nullptr && focused->layer == ui_.parent().layer) {
        // In a dialog of buttons alone the standard button gets the keyboard, or the one that cancels if there is none,
        // so that a person sees what Enter does.
        if (focused->id == first) ui_.set_focus(standard != 0 ? standard : cancel != 0 ? cancel : first, true);
        state.fresh = false;
        state.waits = has_standard && standard == 0;
    }
    // The standard button can be pressed now. It gets the keyboard unless the person has moved that meanwhile.
    if (state.waits && standard != 0) {
        if (ui_.focus() == cancel) ui_.set_focus(standard, true);
        state.waits = false;
    }
    if (pressed && !stays) close();
    return pressed;
}

std::optional<std::size_t> ask(Ui& ui, std::string_view name, std::string_view title, std::string_view question,
                               std::span<const DialogButton> buttons, Tone tone) {
    const Icon icon = tone == Tone::error     ? Icon::error
                      : tone == Tone::warning ? Icon::warning
                      : tone == Tone::good    ? Icon::check
                                              : Icon::none;
    Dialog dialog(ui, name, title, {.icon = icon, .tone = tone});
    if (!dialog) {
        const auto cancel =
            std::find_if(buttons.begin(), buttons.end(), [](const DialogButton& b) { return b.cancel; });
        if (!dialog.cancelled() || cancel == buttons.end()) return std::nullopt;
        return static_cast<std::size_t>(cancel - buttons.begin());
    }
    literal(ui, question);  // it may name a file
    space(ui, 0.4F);
    return dialog.buttons(buttons);
}

}  // namespace lapfx::ui
