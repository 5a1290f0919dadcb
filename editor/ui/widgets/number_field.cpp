#include "ui/widgets/number_field.h"

#include <cmath>

namespace lapfx::ui {

namespace {

constexpr double blink = 0.53;  // s shown, s not
constexpr float pad = 0.4F;     // em between the field's edge and its text

}  // namespace

std::optional<TextCommand> text_command_of(Key key, Mods mods) {
    using enum TextCommand;
    const bool select = has(mods, Mods::shift), word = has(mods, Mods::command);
    switch (key) {
        case Key::left:
            return word ? (select ? select_word_left : word_left) : (select ? select_left : left);
        case Key::right:
            return word ? (select ? select_word_right : word_right) : (select ? select_right : right);
        case Key::home:
            return select ? select_line_start : line_start;
        case Key::end:
            return select ? select_line_end : line_end;
        case Key::backspace:
            return word ? erase_word_left : erase_left;
        case Key::del:
            return word ? erase_word_right : erase_right;
        default:
            break;
    }
    if (!word) return {};
    if (key == key_of('A')) return select_all;
    if (key == key_of('Z')) return select ? redo : undo;
    if (key == key_of('Y')) return redo;
    return {};
}

void NumberEntry::open(Ui& ui, std::string_view text) {
    edit_.reset(std::string(text));
    edit_.apply(TextCommand::select_all);
    begun_with_ = edit_.text();
    evaluated_once_ = false;
    reason_.clear();
    scroll_ = 0;
    selecting_ = false;
    active_at_ = ui.time();
}

NumberEntry::Outcome NumberEntry::take(Ui& ui, Id id, const Rect& field, const ExpressionContext& context) {
    Outcome outcome = Outcome::goes_on;
    ui.events_of(id, [&](const Event& event) {
        active_at_ = ui.time();
        if (event.kind == EventKind::text) edit_.insert(event.codepoint);
        if (event.kind == EventKind::key) outcome = key(ui, event);
        pointer(ui, event, field);
    });
    evaluate_once(context);
    return outcome == Outcome::taken && !valid() ? Outcome::goes_on : outcome;
}

NumberEntry::Outcome NumberEntry::key(Ui& ui, const Event& event) {
    if (event.key == Key::enter) return Outcome::taken;
    if (event.key == Key::escape) return Outcome::given_up;
    Clipboard* clipboard = has(event.mods, Mods::command) ? ui.clipboard() : nullptr;
    const bool cut = event.key == key_of('X');
    if (clipboard != nullptr && (cut || event.key == key_of('C')) && !edit_.selected().empty()) {
        clipboard->set(std::string(edit_.selected()));
        if (cut) edit_.apply(TextCommand::erase_left);
    }
    if (clipboard != nullptr && event.key == key_of('V')) edit_.insert(clipboard->get());
    if (const auto command = text_command_of(event.key, event.mods)) edit_.apply(*command);
    return Outcome::goes_on;
}

void NumberEntry::pointer(Ui& ui, const Event& event, const Rect& field) {
    if (event.kind == EventKind::release || event.kind == EventKind::cancel) selecting_ = false;
    const bool press = event.kind == EventKind::press && event.button == Button::left;
    if (!press && !(event.kind == EventKind::pointer && selecting_)) return;
    const Run& run = ui.fonts().run(edit_.text(), ui.number_style());
    const float x = event.at.x - field.x - ui.em(pad) + scroll_;
    edit_.place(run.byte_at(x), !press || has(event.mods, Mods::shift));
    if (!press) return;
    selecting_ = event.clicks == 1;
    if (event.clicks == 2) edit_.apply(TextCommand::select_word);
    if (event.clicks == 3) edit_.apply(TextCommand::select_all);
}

/// An error costs an allocation: not in each frame.
void NumberEntry::evaluate_once(const ExpressionContext& context) {
    if (evaluated_once_ && edit_.text() == evaluated_) return;
    evaluated_once_ = true;
    evaluated_ = edit_.text();
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
    const Run& run = ui.fonts().run(edit_.text(), ui.number_style());
    const float view = std::max(1.0F, field.w - 2 * ui.em(pad)), caret = run.x_of(edit_.caret());
    scroll_ = std::clamp(scroll_, caret - view, caret);
    scroll_ = std::clamp(scroll_, 0.0F, std::max(0.0F, run.width - view));
    const float height = ui.em(1.2F);
    ui.set_caret({std::round(field.x + ui.em(pad) + caret - scroll_), field.center().y - height / 2, 1, height});
}

EntryLook NumberEntry::look(Ui& ui) const {
    bool shown = true;
    if (!ui.options().reduced_motion) {
        const double halves = std::floor((ui.time() - active_at_) / blink + 1e-6);
        shown = std::fmod(halves, 2) == 0;
        ui.wake_at(active_at_ + (halves + 1) * blink, "caret");
    }
    return {
        ui.copy(edit_.text()), edit_.caret(), edit_.selection_begin(), edit_.selection_end(), scroll_, shown, !valid()};
}

void draw_entry(Painter& painter, const Rect& field, const EntryLook& look) {
    const Theme& t = painter.theme();
    const float radius = painter.em(t.radius), line = painter.hairline();
    painter.fill(field, t.field, radius);
    painter.frame(field, look.wrong ? t.error : t.focus, line, radius);
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
