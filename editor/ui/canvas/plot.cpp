#include "ui/canvas/plot.h"

#include <charconv>
#include <limits>

#include "ui/canvas/plot_legend.h"
#include "ui/core/node.h"

namespace lapfx::ui {

namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
constexpr double zoom_by_key = 0.8, pan_step = 0.1;

/// The place of a value on the y axis; NaN if it has none.
double placed(const PlotState& state, double y) {
    if (!std::isfinite(y)) return nothing;
    return !state.log_y ? y : y > 0 ? std::log10(y) : nothing;
}

bool has_band(const PlotSeries& series) {
    return series.low != nullptr && series.high != nullptr;
}

/// The places of the parts of a plot; `Em` is ui or painter.
struct Frame {
    Rect title, plot, x_labels, y_labels;
    Axis1 x, y;
};
template <typename Em>
Frame frame_of(const Em& measure, Rect rect, const PlotState& state) {
    Frame f;
    rect = rect.inset(measure.em(0.3F), 0);
    f.title = rect.cut_top(measure.em(1.75F));
    f.x_labels = rect.cut_bottom(measure.em(1.6F));
    f.y_labels = rect.cut_left(measure.em(3.6F));
    f.x_labels.cut_left(f.y_labels.w);
    rect.cut_right(measure.em(0.6F));
    f.plot = rect;
    f.x = {state.x, rect.x, rect.right()};
    f.y = {state.y, rect.bottom(), rect.y};
    return f;
}

// --- what is in sight ---

Span padded(const Extremes& e, double margin) {
    if (!e.any) return {0, 1};
    double length = e.high - e.low;
    if (!(length > 1e-12 * std::max(std::abs(e.low), std::abs(e.high)))) {
        length = std::max(1.0, std::abs(e.low) * 0.1);
        return {e.low - length / 2, e.low + length / 2};
    }
    return {e.low - length * margin, e.high + length * margin};
}

/// The spans that show all of the visible series.
void fitted_spans(const PlotState& state, std::span<const PlotSeries> series, Span& x, Span& y) {
    Extremes all_x, all_y;
    for (std::size_t i = 0; i < series.size(); ++i) {
        const PlotData& data = *series[i].data;
        if (hidden(state, i) || data.size() == 0) continue;
        all_x.add(data.x(0)), all_x.add(data.x(data.size() - 1));
        Extremes own = data.extremes();
        if (has_band(series[i])) own.add(series[i].low->extremes()), own.add(series[i].high->extremes());
        if (state.log_y && own.any && own.low <= 0) own.low = std::min(1.0, own.high * 1e-3);
        if (!own.any || (state.log_y && own.high <= 0)) continue;
        all_y.add(placed(state, own.low)), all_y.add(placed(state, own.high));
    }
    x = padded(all_x, 0);
    y = padded(all_y, 0.06);
}

class Gestures {
  public:
    enum class Drag : std::uint8_t { none, pan, box, range };
    struct Memory {
        PlotState own, before;  ///< `before` is the state when the drag began
        Drag drag = Drag::none;
        bool x = true, y = true;  ///< the axes that it changes
        glm::vec2 from{0}, to{0};
    };

    Gestures(Memory& memory, PlotState& state, const Frame& frame, std::span<const PlotSeries> series)
        : m_(memory), state_(state), frame_(frame), series_(series) {}

    void take(Ui& ui, Id id, const Response& r) {
        if (r.pressed && r.clicks == 2) fit();
        if (r.held && m_.drag == Drag::none) begin(r);
        if (m_.drag != Drag::none) drag(r);
        if (r.wheel != 0) {
            const bool on_y = frame_.y_labels.contains(r.pointer);
            const bool on_x = !on_y && frame_.x_labels.contains(r.pointer);
            zoom(zoom_of(r.wheel), !on_y, !on_x, r.pointer);
        }
        if (!ui.has_events(id)) return;
        ui.events_of(id, [&](const Event& e) {
            if (e.kind == EventKind::key) key(ui, e);
            if (e.kind == EventKind::text && (e.codepoint == U'+' || e.codepoint == U'-'))
                zoom(e.codepoint == U'+' ? zoom_by_key : 1 / zoom_by_key, true, true, frame_.plot.center());
        });
    }
    PlotResult result;

  private:
    void fit() {
        state_.fitted = true;
        result.moved = true;
    }
    void begin(const Response& r) {
        if (r.button == Button::right) return;
        m_.before = state_;
        m_.from = m_.to = r.pressed_at;
        const bool on_y = frame_.y_labels.contains(r.pressed_at);
        const bool on_x = !on_y && frame_.x_labels.contains(r.pressed_at);
        m_.x = !on_y, m_.y = !on_x;
        m_.drag = Drag::pan;
        if (r.button != Button::left) return;
        if (has(r.mods, Mods::shift)) m_.drag = Drag::box;
        if (has(r.mods, Mods::command)) m_.drag = Drag::range;
    }
    void drag(const Response& r) {
        if (r.cancelled) {
            result.moved |= m_.drag == Drag::pan;
            m_.drag = Drag::none;
            state_ = m_.before;
            return;
        }
        m_.to = r.pointer;
        const glm::vec2 way = m_.to - m_.from;
        if (m_.drag == Drag::pan && way != glm::vec2(0)) pan(way);
        if (m_.drag == Drag::range && way.x != 0) {
            state_.range = sorted(frame_.x.value_at(m_.from.x), frame_.x.value_at(m_.to.x));
            state_.has_range = true;
        }
        if (r.held && !r.released) return;
        if (m_.drag == Drag::box) zoom_to_box();
        if (m_.drag == Drag::pan && r.button == Button::left && glm::length(way) < 3 && frame_.plot.contains(m_.from))
            result.clicked = true, result.x = frame_.x.value_at(m_.to.x);
        m_.drag = Drag::none;
    }
    static Span sorted(double a, double b) { return a < b ? Span{a, b} : Span{b, a}; }

    /// Refuses spans that are too narrow for doubles, or so wide that the data cannot be seen.
    void show(const Span& x, const Span& y) {
        Span all_x, all_y;
        fitted_spans(state_, series_, all_x, all_y);
        const auto sane = [](const Span& s, const Span& all) {
            const double most = std::max(std::abs(s.low), std::abs(s.high));
            return std::isfinite(most) && s.length() > 1e-9 * all.length() && s.length() > 1e-12 * most &&
                   s.length() < 1e4 * all.length() && most < 1e6 * (all.length() + std::abs(all.low));
        };
        if (!sane(x, all_x) || !sane(y, all_y)) return;
        state_.x = x, state_.y = y;
        state_.fitted = false;
        result.moved = true;
    }
    void pan(glm::vec2 way) {
        Span x = m_.before.x, y = m_.before.y;
        if (m_.x) x.pan(-way.x / frame_.x.scale());
        if (m_.y) y.pan(-way.y / frame_.y.scale());
        show(x, y);
    }
    void zoom(double factor, bool x_too, bool y_too, glm::vec2 at) {
        Span x = state_.x, y = state_.y;
        if (x_too) x.zoom(factor, frame_.x.value_at(at.x));
        if (y_too) y.zoom(factor, frame_.y.value_at(at.y));
        show(x, y);
    }
    void zoom_to_box() {
        const glm::vec2 way = glm::abs(m_.to - m_.from);
        if ((m_.x && way.x < 4) || (m_.y && way.y < 4)) return;
        Span x = state_.x, y = state_.y;
        if (m_.x) x = sorted(frame_.x.value_at(m_.from.x), frame_.x.value_at(m_.to.x));
        if (m_.y) y = sorted(frame_.y.value_at(m_.from.y), frame_.y.value_at(m_.to.y));
        show(x, y);
    }
    void pan_by_key(double x_part, double y_part) {
        Span x = state_.x, y = state_.y;
        x.pan(x_part * pan_step * x.length());
        y.pan(y_part * pan_step * y.length());
        show(x, y);
    }
    void key(Ui& ui, const Event& e) {
        if (e.key == Key::left) pan_by_key(-1, 0);
        if (e.key == Key::right) pan_by_key(1, 0);
        if (e.key == Key::down) pan_by_key(0, -1);
        if (e.key == Key::up) pan_by_key(0, 1);
        if (e.key == Key::home || (e.key == key_of('F'))) fit();
        if (e.key == key_of('L')) {
            state_.log_y = !state_.log_y;
            Span x;
            fitted_spans(state_, series_, x, state_.y);
            result.moved = true;
        }
        if (e.key == Key::escape) state_.has_range = false;
        if (e.key == key_of('C') && has(e.mods, Mods::command) && ui.clipboard() != nullptr)
            ui.clipboard()->set(plot_csv(series_, "x", state_.x.low, state_.x.high));
    }

    Memory& m_;
    PlotState& state_;
    const Frame& frame_;
    std::span<const PlotSeries> series_;
};

// --- drawing ---

struct Look {
    std::span<const PlotSeries> series;
    PlotState state;
    PlotOptions options;
    Rect box;                             ///< the box that is dragged; empty: none
    int cursor_series;                    ///< -1: none
    double cursor_x, cursor_y;            ///< the cursor's sample, y on the axis
    std::string_view cursor, statistics;  ///< texts
    float legend;                         ///< px at the right of the title
};

/// The text at a mark of an axis; it has few digits.
std::string_view tick_text(std::span<char> buffer, double value, int decimals) {
    if (std::abs(value) < 1e6 && decimals < 6) return format_number(buffer, value, decimals);
    const auto end =
        std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::scientific, 1);
    return {buffer.data(), static_cast<std::size_t>(end.ptr - buffer.data())};
}

void draw_x_ticks(Painter& p, const Frame& f, const Look& look) {
    const Theme& t = p.theme();
    const TextStyle style = p.number_style();
    Rect labels = f.x_labels;
    ShortText name;
    name.add(look.options.x_name);
    if (!look.options.x_unit.empty()) name.add(" (").add(look.options.x_unit).add(")");
    const float named = name.view().empty() ? 0 : p.text(labels, name.view(), p.text_style(), t.text_dim, Align::end);
    if (named > 0) labels.cut_right(named + p.em(0.8F));
    const float room = p.em(4.5F);
    const Ticks marks = ticks(look.state.x.low, look.state.x.high, std::max(1, static_cast<int>(f.plot.w / room)));
    char buffer[32];
    for (int i = 0; i < marks.count; ++i) {
        const double value = marks.first + marks.step * i;
        const float x = whole(f.x.px_of(value));
        p.fill({x, f.plot.y, p.hairline(), f.plot.h}, on_well(t, grid_ink));
        const std::string_view text = tick_text(buffer, value, marks.decimals);
        const float width = p.fonts().run(text, style).width;
        const Rect place{whole(x - width / 2), labels.y, std::ceil(width), labels.h};
        if (place.right() <= labels.right()) p.text(place, text, style, t.text_dim);
    }
}

void draw_y_tick(Painter& p, const Frame& f, double place, std::string_view text) {
    const float y = whole(f.y.px_of(place));
    if (y < f.plot.y || y > f.plot.bottom()) return;
    p.fill({f.plot.x, y, f.plot.w, p.hairline()}, on_well(p.theme(), grid_ink));
    if (text.empty()) return;
    Rect label{f.y_labels.x, y - p.em(0.7F), f.y_labels.w - p.em(0.4F), p.em(1.4F)};
    p.text(label, text, p.number_style(), p.theme().text_dim, Align::end);
}

void draw_y_ticks(Painter& p, const Frame& f, const Look& look) {
    char buffer[32];
    const Span& span = look.state.y;
    const int most = std::max(1, static_cast<int>(f.plot.h / p.em(2)));
    if (!look.state.log_y || span.length() < 0.3) {  // within a factor of 2, powers of ten do not help
        const bool log = look.state.log_y;
        const Ticks marks =
            log ? ticks(std::pow(10, span.low), std::pow(10, span.high), most) : ticks(span.low, span.high, most);
        for (int i = 0; i < marks.count; ++i) {
            const double value = marks.first + marks.step * i;
            draw_y_tick(p, f, log ? std::log10(value) : value, tick_text(buffer, value, marks.decimals));
        }
        return;
    }
    const int every = std::max(1, static_cast<int>(std::ceil(span.length() / most)));
    const int first = static_cast<int>(std::floor(span.low));
    for (int decade = first; decade <= span.high; ++decade) {
        const double value = std::pow(10.0, decade);
        const bool labelled = (decade - first) % every == 0;
        draw_y_tick(p, f, decade, labelled ? tick_text(buffer, value, decade < 0 ? -decade : 0) : "");
        if (span.length() > most) continue;
        for (int digit = 2; digit < 10; ++digit) {
            const bool shown = span.length() < 1.5 && (digit == 2 || digit == 5);
            const double minor = decade + std::log10(digit);
            draw_y_tick(p, f, minor, shown ? tick_text(buffer, value * digit, decade < 0 ? -decade : 0) : "");
        }
    }
}

/// Draws one vertical line for each column of pixels, long enough to touch the one before.
void draw_columns(Painter& p, const Frame& f, const PlotState& state, const PlotSeries& series, Color color,
                  std::size_t first) {
    const PlotData& data = *series.data;
    const float width = 1.25F * p.hairline();
    float before_top = 0, before_bottom = 0, before_x = 0;
    std::size_t before = 0;
    bool joined = false;
    for (float x = f.plot.x; x < f.plot.right() && first < data.size(); ++x) {
        const std::size_t last = data.index_from(f.x.value_at(x + 1));
        if (last == first) continue;
        const Extremes e = data.extremes(first, last);
        const double low = placed(state, e.low), high = placed(state, e.high);
        const bool from_gap = !std::isfinite(data.y(first));
        const bool to_gap = !std::isfinite(data.y(last - 1));
        const std::size_t from_sample = first;
        first = last;
        if (!e.any || std::isnan(high)) {
            joined = false;
            continue;
        }
        const float top = f.y.px_of(high), bottom = f.y.px_of(std::isnan(low) ? state.y.low - 1 : low);
        const bool touch = joined && !from_gap && x - before_x < 1.5F;
        if (joined && !from_gap && !touch) {  // samples are sparse here
            const double a = placed(state, data.y(before)), b = placed(state, data.y(from_sample));
            if (!std::isnan(a) && !std::isnan(b))
                p.line({before_x + 0.5F, f.y.px_of(a)}, {x + 0.5F, f.y.px_of(b)}, width, color);
        }
        const float from = touch ? std::min(top, before_bottom) : top;
        const float to = touch ? std::max(bottom, before_top) : bottom;
        p.line({x + 0.5F, from}, {x + 0.5F, to}, width, color);
        before_top = top, before_bottom = bottom, before_x = x, before = last - 1, joined = !to_gap;
    }
}

void draw_line(Painter& p, const Frame& f, const PlotState& state, const PlotData& data, Color color, float width,
               std::size_t first, std::size_t last) {
    glm::vec2 before{0};
    bool joined = false, drawn = true;
    const double x_scale = f.x.scale(), y_scale = f.y.scale();  // each takes a division
    const double x_start = f.x.from - f.x.span.low * x_scale, y_start = f.y.from - f.y.span.low * y_scale;
    const auto px = [](double v) { return static_cast<float>(std::clamp(v, -1e6, 1e6)); };
    for (std::size_t i = first; i < last; ++i) {
        const double y = placed(state, data.y(i));
        if (std::isnan(y)) {
            if (joined && !drawn) p.line(before, before, width * 2, color);  // a sample between two gaps
            joined = false;
            continue;
        }
        const glm::vec2 here{px(x_start + data.x(i) * x_scale), px(y_start + y * y_scale)};
        if (joined) p.line(before, here, width, color);
        drawn = joined;
        before = here, joined = true;
    }
    if (joined && !drawn) p.line(before, before, width * 2, color);
}

/// The extremes of a line between two places, of its samples and of its ends there.
Extremes extremes_between(const PlotData& data, double from, double to) {
    Extremes e = data.extremes(data.index_from(from), data.index_from(to));
    for (const double y : {data.value_at(from), data.value_at(to)})
        if (std::isfinite(y)) e.add(y);
    return e;
}

/// A bar for each step along x; steps are of a size that many of them look smooth.
void draw_band(Painter& p, const Frame& f, const PlotState& state, const PlotSeries& series, Color color) {
    const float step = 2 * p.hairline();
    for (float x = f.plot.x; x < f.plot.right(); x += step) {
        const double from = f.x.value_at(x), to = f.x.value_at(x + step);
        const Extremes low = extremes_between(*series.low, from, to), high = extremes_between(*series.high, from, to);
        if (!low.any || !high.any || std::isnan(placed(state, high.high))) continue;
        const double bottom = placed(state, low.low);
        const float y = f.y.px_of(placed(state, high.high));
        const float end = std::isnan(bottom) ? f.plot.bottom() : f.y.px_of(bottom);
        p.fill({x, y, std::min(step, f.plot.right() - x), std::max(end - y, p.hairline())}, with_alpha(color, 0.25F));
    }
}

void draw_series(Painter& p, const Frame& f, const PlotState& state, const PlotSeries& series, Color color) {
    const PlotData& data = *series.data;
    if (data.size() == 0 || f.plot.empty()) return;
    if (has_band(series)) draw_band(p, f, state, series, color);
    std::size_t first = data.index_from(state.x.low), last = data.index_from(state.x.high);
    if (static_cast<float>(last - first) > 2 * f.plot.w) return draw_columns(p, f, state, series, color, first);
    if (first > 0) --first;  // for the line that comes in from outside
    last = std::min(last + 1, data.size());
    draw_line(p, f, state, data, color, (series.reference ? 1.0F : 1.5F) * p.hairline(), first, last);
}

void draw_note(Painter& p, const Frame& f, glm::vec2 at, std::string_view text) {
    const Theme& t = p.theme();
    const float width = std::ceil(p.fonts().run(text, p.number_style()).width) + p.em(1);
    Rect box{at.x + p.em(0.8F), at.y - p.em(2.2F), width, p.em(1.6F)};
    if (box.right() > f.plot.right()) box.x = std::max(f.plot.x, at.x - p.em(0.8F) - width);
    box.y = std::max(f.plot.y, box.y);
    p.fill(box, t.raised, p.em(t.radius));
    p.frame(box, t.border, p.hairline(), p.em(t.radius));
    p.text(box.inset(p.em(0.5F), 0), text, p.number_style(), t.text);
}

void draw_cursor(Painter& p, const Frame& f, const Look& look) {
    if (look.cursor_series < 0) return;
    const Theme& t = p.theme();
    const auto i = static_cast<std::size_t>(look.cursor_series);
    const glm::vec2 at{f.x.px_of(look.cursor_x), f.y.px_of(look.cursor_y)};
    p.fill({whole(at.x), f.plot.y, p.hairline(), f.plot.h}, on_well(t, quiet_ink));
    p.line(at, at, p.em(0.6F), t.well);
    p.line(at, at, p.em(0.42F), color_of(t, look.series[i], i));
    draw_note(p, f, at, look.cursor);
}

void draw_plot(Painter& p, const Node& node, const Look& look) {
    const Theme& t = p.theme();
    const Frame f = frame_of(p, node.rect(), look.state);
    p.ground(node.rect(), t.panel);
    p.ground(f.plot, t.well);
    ShortText name;
    name.add(look.options.y_name);
    if (!look.options.y_unit.empty()) name.add(" (").add(look.options.y_unit).add(")");
    Rect title = f.title;
    title.cut_right(look.legend + p.em(0.6F));
    p.text(title, name.view(), p.text_style(), t.text_dim);
    draw_x_ticks(p, f, look);
    draw_y_ticks(p, f, look);
    p.push_clip(f.plot);
    const Span& range = look.state.range;
    if (look.state.has_range) {
        const float left = f.x.px_of(range.low), right = f.x.px_of(range.high);
        p.fill({left, f.plot.y, std::max(1.0F, right - left), f.plot.h}, with_alpha(t.accent, 0.22F));
    }
    for (std::size_t i = 0; i < look.series.size(); ++i) {
        if (!hidden(look.state, i)) draw_series(p, f, look.state, look.series[i], color_of(t, look.series[i], i));
    }
    if (!std::isnan(look.options.mark))
        p.fill({whole(f.x.px_of(look.options.mark)), f.plot.y, std::max(1.0F, 1.5F * p.hairline()), f.plot.h},
               t.accent);
    if (!look.box.empty()) {
        p.fill(look.box, with_alpha(t.focus, 0.15F));
        p.frame(look.box, t.focus, p.hairline());
    }
    draw_cursor(p, f, look);
    if (look.state.has_range)
        draw_note(p, f, {f.x.px_of(std::max(range.low, look.state.x.low)), f.plot.y}, look.statistics);
    p.pop_clip();
    p.frame(f.plot, has(node.is, Is::disabled) ? t.grid : t.border, p.hairline());
}

// --- readout ---

/// Finds the sample nearest to the pointer: in each series the nearest one along x, and among these the nearest in px.
void find_cursor(const Frame& f, const PlotState& state, std::span<const PlotSeries> series, glm::vec2 at,
                 PlotResult& result) {
    if (!f.plot.contains(at)) return;
    float best = 0;
    for (std::size_t i = 0; i < series.size(); ++i) {
        if (hidden(state, i) || series[i].reference || series[i].data->size() == 0) continue;
        const std::size_t index = series[i].data->nearest(f.x.value_at(at.x));
        const double y = placed(state, series[i].data->y(index));
        if (std::isnan(y)) continue;
        const float away = glm::distance(at, {f.x.px_of(series[i].data->x(index)), f.y.px_of(y)});
        if (result.series >= 0 && away >= best) continue;
        best = away, result.series = static_cast<int>(i), result.index = index;
    }
}

void put_texts(Ui& ui, const Frame& f, const PlotResult& result, Look& look) {
    const PlotOptions& o = look.options;
    const double x_size = 1 / f.x.scale();
    const double y_size = look.state.log_y ? 0 : 1 / std::abs(f.y.scale());
    const auto y_decimals = [&](double y) { return decimals_for(y_size > 0 ? y_size : std::abs(y) / 1000); };
    if (result.series >= 0) {
        const PlotSeries& s = look.series[static_cast<std::size_t>(result.series)];
        const double x = s.data->x(result.index), y = s.data->y(result.index);
        look.cursor_series = result.series, look.cursor_x = x, look.cursor_y = placed(look.state, y);
        ShortText text;
        if (!s.name.empty()) text.add(split_label(s.name).shown).add(": ");
        text.add(x, decimals_for(x_size)).add_unit(o.x_unit).add(", ").add(y, y_decimals(y)).add_unit(o.y_unit);
        look.cursor = ui.copy(text.view());
    }
    if (!look.state.has_range) return;
    for (std::size_t i = 0; i < look.series.size(); ++i) {  // the statistics of the first one that is shown
        if (hidden(look.state, i) || look.series[i].reference) continue;
        const RangeStatistics stats = look.series[i].data->statistics(look.state.range.low, look.state.range.high);
        if (!stats.extremes.any) continue;
        const int decimals = y_decimals(stats.extremes.high);
        ShortText text;
        text.add("mean ").add(stats.mean, decimals + 1).add("  area ").add(stats.area, decimals + 1);
        text.add("  min ").add(stats.extremes.low, decimals).add("  max ").add(stats.extremes.high, decimals);
        look.statistics = ui.copy(text.view());
        return;
    }
    look.statistics = "no samples";
}

}  // namespace

PlotResult plot(Ui& ui, std::string_view label, std::span<const PlotSeries> series, const PlotOptions& options) {
    Node& node = ui.open(Role::plot, label, Axis::x,
                         Sense::hover | Sense::press | Sense::middle | Sense::focus | Sense::wheel | Sense::arrows_x |
                             Sense::arrows_y | Sense::extremes | Sense::typing | Sense::copying);
    node.typed = TypedKeys::plot;
    const Id id = node.id;
    auto& memory = ui.memory<Gestures::Memory>(id);
    PlotState& state = options.state != nullptr ? *options.state : memory.own;
    if (state.has_range && node.sense != Sense::hover) node.sense = node.sense | Sense::escape;
    node.size[0] = options.width.kind == SizeKind::fit ? px(ui.em(24)) : options.width;
    node.size[1] = options.height.kind == SizeKind::fit ? px(ui.em(14)) : options.height;
    node.tip = ui.copy(options.tip);
    const Response r = ui.respond(node);
    const float width = ui.rect_before(id).w, legend_room = width > 0 ? width : ui.em(24);
    const bool toggled = legend(ui, series, state, legend_room);

    if (state.fitted) fitted_spans(state, series, state.x, state.y);
    const Frame f = frame_of(ui, ui.rect_before(id), state);
    Gestures gestures(memory, state, f, series);
    if (!f.plot.empty()) gestures.take(ui, id, r);
    if (state.fitted) fitted_spans(state, series, state.x, state.y);
    PlotResult result = gestures.result;
    result.moved |= toggled && state.fitted;

    const Frame now = frame_of(ui, ui.rect_before(id), state);
    Look look{.series = series,
              .state = state,
              .options = options,
              .box = {},
              .cursor_series = -1,
              .cursor_x = 0,
              .cursor_y = 0,
              .cursor = {},
              .statistics = {},
              .legend = legend_width(ui, series, legend_room)};
    if (memory.drag == Gestures::Drag::box) {
        const glm::vec2 a = glm::min(memory.from, memory.to), b = glm::max(memory.from, memory.to);
        look.box = {memory.x ? a.x : f.plot.x, memory.y ? a.y : f.plot.y, memory.x ? b.x - a.x : f.plot.w,
                    memory.y ? b.y - a.y : f.plot.h};
    }
    if (r.hovered && memory.drag == Gestures::Drag::none) find_cursor(now, state, series, r.pointer, result);
    put_texts(ui, now, result, look);
    PlotSeries* kept = static_cast<PlotSeries*>(ui.arena().take(series.size_bytes() + 1, alignof(PlotSeries)));
    std::uninitialized_copy(series.begin(), series.end(), kept);
    for (std::size_t i = 0; i < series.size(); ++i) kept[i].name = ui.copy(kept[i].name);
    look.series = {kept, series.size()};
    look.options.x_name = ui.copy(options.x_name), look.options.x_unit = ui.copy(options.x_unit);
    look.options.y_name = ui.copy(options.y_name), look.options.y_unit = ui.copy(options.y_unit);
    Node& me = ui.parent();
    me.text = state.has_range ? look.statistics : look.cursor;
    if (memory.drag == Gestures::Drag::box || memory.drag == Gestures::Drag::range) ui.set_cursor(Cursor::crosshair);
    ui.draw_with<draw_plot>(me, look);
    ui.close();
    return result;
}

}  // namespace lapfx::ui
