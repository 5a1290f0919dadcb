// Turns events into edits of one number.
#include <cmath>

#include "ui/widgets/param_parts.h"

namespace lapfx::ui {

namespace {

constexpr Id state_id = 0x706172616d2e7374ULL;
constexpr float drag_after = 3;  // px at scale 1
constexpr double page = 10;      // steps

/// The number of steps that a key makes; 0: it is not a key for stepping.
double steps_of(Key key) {
    switch (key) {
        case Key::right:
        case Key::up:
            return 1;
        case Key::left:
        case Key::down:
            return -1;
        case Key::page_up:
            return page;
        case Key::page_down:
            return -page;
        default:
            return 0;
    }
}

}  // namespace

NumberState* number_state(Ui& ui, Id id) {
    if (id == 0) return nullptr;
    const bool concerned = id == ui.focus() || id == ui.held() || id == ui.hot() || ui.overlay_count() > 0;
    return concerned || ui.has_events(id) ? &ui.memory<NumberState>(state_id) : nullptr;
}

std::string beyond_limits(const ParamOptions& o, double shown) {
    const double taken = std::max(o.hard_minimum, std::min(o.hard_maximum, shown));
    if (!(taken != shown)) return {};
    const auto number = [&](double value) {
        char buffer[32];
        return std::string(format_param(buffer, o, value));
    };
    std::string unit(o.unit == "deg" ? "\u00B0" : o.unit);
    if (!unit.empty() && unit != "%" && o.unit != "deg") unit.insert(0, " ");
    const bool low = std::isfinite(o.hard_minimum), high = std::isfinite(o.hard_maximum);
    const std::string allowed = low && high ? number(o.hard_minimum) + " to " + number(o.hard_maximum) + unit
                                : low       ? number(o.hard_minimum) + unit + " and more"
                                            : number(o.hard_maximum) + unit + " and less";
    return "allowed are " + allowed + ": " + number(taken) + unit + " is taken";
}

ExpressionContext context_of(const ParamOptions& options, double shown) {
    return {.unit = options.unit, .hundred_percent = options.maximum, .current = shown};
}

void copy_number(Ui& ui, const ParamOptions& options, double shown) {
    char buffer[32];
    if (ui.clipboard() != nullptr) ui.clipboard()->set(std::string(format_whole(buffer, options, shown)));
}

std::optional<double> number_to_paste(Ui& ui, const ParamOptions& options, double shown) {
    if (ui.clipboard() == nullptr) return {};
    const auto result = evaluate(ui.clipboard()->get(), context_of(options, shown));
    const double* number = std::get_if<double>(&result);
    return number != nullptr ? std::optional(*number) : std::nullopt;
}

Edit NumberGesture::take(NumberState& s, const Response& r) {
    if (s.typing == id_) {
        type(s, r);
    } else {
        // The entry that Tab left may come after this one. It closes in this build, and this one opens in the next.
        const bool from_entry = s.typing != 0 || s.tabbed_at == static_cast<std::uint32_t>(ui_.builds());
        if (r.focus_in && r.by_tab && from_entry) s.opens = id_;
        if (s.opens == id_ && !r.focus_in) {
            s.opens = 0;
            if (r.focused) open(s);
        }
        press(s, r);
        if (s.held != id_) keys(s, r), wheel(s, r);
    }
    if (s.typing == id_) s.entry.refresh(ui_, field_, context_of(o_, shown()));
    show_cursor(s, r);
    return edit_;
}

/// Sets the value. Returns whether it differs from before. Values that are not finite are refused.
bool NumberGesture::set(double next) {
    if (!std::isfinite(next)) return false;
    if (o_.integer) next = std::round(next);
    next = std::max(o_.hard_minimum, std::min(o_.hard_maximum, next));
    const double kept = next / o_.display;
    if (kept == value_ || (o_.single && static_cast<float>(kept) == static_cast<float>(value_))) return false;
    value_ = kept;
    edit_.changed = true;
    return true;
}

void NumberGesture::once(NumberState& s, double next) {
    if (!set(next)) return;
    // While an arrow repeats, this is part of that edit and ends it: there is one edit at a time.
    edit_.began |= s.stepping != id_;
    edit_.committed = true;
    if (s.stepping == id_) s.stepping = 0;
}

/// What a person has typed or pasted: says what becomes of it where it is not allowed.
void NumberGesture::enter(NumberState& s, double next) {
    if (const std::string told = beyond_limits(o_, next); !told.empty()) ui_.explain(id_, told, Ui::explained_for);
    once(s, next);
}

// --- typing ---

void NumberGesture::open(NumberState& s) {
    char buffer[32];
    const double now = shown();
    end_steps(s);
    ui_.explain(id_, {});  // what was said of the last entry
    s.typing = id_;
    s.entry.open(ui_, std::isfinite(now) ? format_whole(buffer, o_, now) : std::string_view());
}

void NumberGesture::type(NumberState& s, const Response& r) {
    if (!r.focused && !r.focus_out) return close(s, false);  // the entry is dropped if the field was disabled meanwhile
    // What was typed just before the keyboard went elsewhere may come in the same build as that.
    const NumberEntry::Outcome outcome = s.entry.take(ui_, id_, field_, context_of(o_, shown()));
    if (!r.focused) return close(s, outcome != NumberEntry::Outcome::given_up);
    if (outcome != NumberEntry::Outcome::goes_on) close(s, outcome == NumberEntry::Outcome::taken);
}

void NumberGesture::close(NumberState& s, bool keep) {
    if (keep && s.entry.valid() && s.entry.modified()) enter(s, s.entry.value());
    if (keep && !s.entry.valid()) {
        const std::string& text = s.entry.text();
        ui_.explain(id_, (text.empty() ? "Nothing" : '"' + text + '"') + " was not taken: " + s.entry.reason(),
                    Ui::explained_for);
    }
    s.typing = 0;
    s.tabbed_at = static_cast<std::uint32_t>(ui_.builds());
}

// --- pointer ---

void NumberGesture::press(NumberState& s, const Response& r) {
    if (r.pressed) {
        s.held = id_;
        s.clicks = s.dragging ? std::uint8_t{1} : r.clicks;  // a click after a drag does not count as a double click
        s.on_label = !field_.contains(r.pressed_at);
        s.dragging = s.began = false;
        s.travel = 0;
        s.start = value_, s.shown = shown();
        if (s.stepping == id_) {  // a drag is an edit of its own: not in this build
            s.travel += r.drag.x;
            return end_steps(s);
        }
    }
    if (s.held != id_) return;
    const bool holds = ui_.held() == id_ && r.held;
    if ((holds || r.released) && !s.on_label) move(s, r.drag.x, r.mods);
    if (holds) {
        if (s.dragging) ui_.lock_pointer();
        return;
    }
    s.held = 0;
    if (r.cancelled && s.began) {
        value_ = s.start;
        edit_.changed = edit_.cancelled = true;
    } else if (s.began) {
        edit_.committed = true;
    } else if (r.released && !s.dragging && s.clicks == 2) {
        if (!s.on_label) return open(s);
        if (o_.standard) once(s, *o_.standard);
    }
}

/// Only movement beyond the first few px counts, so that the value does not jump when the drag starts.
void NumberGesture::move(NumberState& s, float pixels, Mods mods) {
    if (!s.dragging) {
        const float still = drag_after * ui_.scale();
        s.travel += pixels;
        if (std::abs(s.travel) < still) return;
        s.dragging = true;
        s.raw = std::isfinite(s.shown) ? s.shown : o_.standard.value_or(o_.minimum);
        pixels = s.travel - std::copysign(still, s.travel);
    }
    if (pixels == 0) return;
    const bool changed = set(dragged(o_, s.raw, pixels, way_, mods, limits_of(o_, s.shown)));
    if (changed && !s.began) edit_.began = s.began = true;
}

void NumberGesture::wheel(NumberState& s, const Response& r) {
    if (r.wheel == 0) return;
    if (s.wheeled != id_ || s.wheel * r.wheel < 0) s.wheeled = id_, s.wheel = 0;
    s.wheel += r.wheel;  // touch pads send parts of a notch
    const float notches = std::trunc(s.wheel);
    s.wheel -= notches;
    if (notches == 0) return;
    const ParamLimits limits = limits_of(o_, shown());
    once(s, std::clamp(stepped(o_, shown(), notches, has(r.mods, Mods::shift)), limits.low, limits.high));
}

void NumberGesture::show_cursor(const NumberState& s, const Response& r) const {
    if (s.held == id_ && s.dragging) return ui_.set_cursor(Cursor::resize_x);
    if (!r.hovered || !field_.contains(r.pointer)) return;
    ui_.set_cursor(s.typing == id_ ? Cursor::text : Cursor::resize_x);
}

// --- keyboard ---

void NumberGesture::keys(NumberState& s, const Response& r) {
    ui_.events_of(id_, [&](const Event& event) {
        if (event.kind == EventKind::text && s.typing != id_) open(s);
        if (event.kind == EventKind::text) s.entry.type(ui_, event);
        if (event.kind != EventKind::key) return;
        const bool command = has(event.mods, Mods::command);
        if (const double count = steps_of(event.key); count != 0) return step(s, event, count);
        if (event.key == Key::enter) open(s);
        const std::optional<double>& back = has(event.mods, Mods::shift) ? o_.initial : o_.standard;
        if ((event.key == Key::backspace || event.key == Key::del) && back) once(s, *back);
        const ParamLimits ends = limits_of(o_, std::nan(""));
        if (event.key == Key::home && command) once(s, ends.low);
        if (event.key == Key::end && command) once(s, ends.high);
        if (event.key == key_of('C') && command) copy_number(ui_, o_, shown());
        if (event.key != key_of('V') || !command) return;
        if (const auto pasted = number_to_paste(ui_, o_, shown()))
            enter(s, *pasted);
        else
            ui_.explain(id_, "The clipboard has no number that can stand here", Ui::explained_for);
    });
    if (!ui_.key_down(s.step_key) || !r.focused) end_steps(s);
}

void NumberGesture::end_steps(NumberState& s) {
    if (s.stepping != id_) return;
    s.stepping = 0;
    edit_.committed = true;
}

/// An arrow makes one edit from its first press until it is released, however often it repeats.
void NumberGesture::step(NumberState& s, const Event& event, double count) {
    const ParamLimits limits = limits_of(o_, shown());
    const double next = stepped(o_, shown(), count, has(event.mods, Mods::shift));
    if (!set(std::clamp(next, limits.low, limits.high))) return;
    if (s.stepping != id_) edit_.began = true;
    s.stepping = id_;
    s.step_key = event.key;
}

}  // namespace lapfx::ui
