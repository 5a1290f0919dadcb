#include "ui/widgets/number_field.h"

#include <cmath>

#include "ui/widgets/field.h"

namespace lapfx::ui {

namespace {

constexpr float pad = 0.45F;  // em between the field's edge and its text

}  // namespace

void NumberEntry::open(Ui& ui, std::string_view text) {
    text_ = begun_with_ = text;
    editing_.open(ui, text_, {.bytes = 256, .keys_outside = true});
    reason_.clear();
    scroll_ = 0;
    evaluated_once_ = selecting_ = false;
}

NumberEntry::Outcome NumberEntry::take(Ui& ui, Id id, const Rect& field, const ExpressionContext& context) {
    Outcome outcome = Outcome::goes_on;
    ui.events_of(id, [&](const Event& event) {
        if (event.kind == EventKind::key && event.key == Key::enter) outcome = Outcome::taken;
        if (event.kind == EventKind::key && event.key == Key::escape) outcome = Outcome::given_up;
        type(ui, event);
        pointer(ui, event, field);
    });
    evaluate_once(context);
    return outcome == Outcome::taken && !valid() ? Outcome::goes_on : outcome;
}

void NumberEntry::type(Ui& ui, const Event& event) {
    Edit edit;
    editing_.take(ui, event, text_, edit);
}

void NumberEntry::pointer(Ui& ui, const Event& event, const Rect& field) {
    if (event.kind == EventKind::release || event.kind == EventKind::cancel) selecting_ = false;
    const bool press = event.kind == EventKind::press && event.button == Button::left;
    const bool drag = event.kind == EventKind::pointer && selecting_;
    if (!press && !drag) return;
    const Run& run = ui.fonts().run(text_, ui.number_style());
    const std::size_t byte = run.byte_at(event.at.x - field.x - ui.em(pad) + scroll_);
    press ? editing_.press(ui, event, byte) : editing_.edit.place(byte, true);
    if (press) selecting_ = event.clicks == 1;
}

/// Evaluates a changed text once, not in each frame, because an error costs an allocation.
void NumberEntry::evaluate_once(const ExpressionContext& context) {
    if (evaluated_once_ && text_ == evaluated_) return;
    evaluated_once_ = true;
    evaluated_ = text_;
    const auto result = evaluate(evaluated_, context);
    reason_.clear();
    if (const auto* error = std::get_if<ExpressionError>(&result)) {
        reason_ = error->reason.empty() ? "not a number" : error->reason;
    } else {
        value_ = std::get<double>(result);
        if (!std::isfinite(value_)) reason_ = "not a number";
    }
}

void NumberEntry::refresh(Ui& ui, const Rect& field, const ExpressionContext& context) {
    evaluate_once(context);
    const Run& run = ui.fonts().run(text_, ui.number_style());
    const float view = std::max(1.0F, field.w - 2 * ui.em(pad)), caret = run.x_of(editing_.edit.caret());
    scroll_ = std::clamp(scroll_, caret - view, caret);
    scroll_ = std::clamp(scroll_, 0.0F, std::max(0.0F, run.width - view));
    const float height = ui.em(1.2F);
    ui.set_caret({std::round(field.x + ui.em(pad) + caret - scroll_), field.center().y - height / 2, 1, height});
}

EntryLook NumberEntry::look(Ui& ui) const {
    const TextEdit& edit = editing_.edit;
    return {ui.copy(text_),           edit.caret(), edit.selection_begin(), edit.selection_end(), scroll_,
            editing_.caret_shown(ui), !valid()};
}

void draw_entry(Painter& painter, const Rect& field, const EntryLook& look) {
    const Theme& t = painter.theme();
    const float line = painter.hairline();
    draw_field(painter, field, Is::focused | when(look.wrong, Is::invalid));
    const TextStyle style = painter.number_style();
    const Run& run = painter.fonts().run(look.text, style);
    const LineMetrics metrics = painter.fonts().metrics(style);
    const Rect inside = field.inset(painter.em(pad), line);
    const float left = inside.x - std::round(look.scroll);
    const float top = std::round(field.center().y - (metrics.ascent + metrics.descent) / 2);
    painter.push_clip(inside.inset(-line, 0));
    if (look.to > look.from) {
        const float from = run.x_of(look.from), to = run.x_of(look.to);
        painter.fill({left + from, top, to - from, metrics.ascent + metrics.descent}, t.accent_ground);
    }
    painter.run(run, {left, top + metrics.ascent}, look.wrong ? t.error : t.text);
    if (look.caret_shown)
        painter.fill({std::round(left + run.x_of(look.caret)), top, line, metrics.ascent + metrics.descent}, t.text);
    painter.pop_clip();
}

}  // namespace lapfx::ui
