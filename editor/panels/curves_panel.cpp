// Factors over the scene's time on cautery power, bleeding and smoke, drawn by hand.
#include <cmath>
#include <optional>

#include "document/curve_text.h"
#include "panels/panels.h"
#include "ui/canvas/curve_editor.h"
#include "ui/core/node.h"
#include "ui/widgets/basic.h"
#include "ui/widgets/combo.h"
#include "ui/widgets/param.h"
#include "ui/widgets/scroll.h"

namespace lapfx::panels {

namespace {

using Points = std::vector<CurvePoint>;

struct CurveKind {
    std::string_view key;
    Points Curves::*points;
};
constexpr std::array<CurveKind, 3> kinds = {{
    {"cautery_power", &Curves::cautery_power},
    {"bleeding_strength", &Curves::bleeding_strength},
    {"emission", &Curves::emission},
}};

constexpr double roundest = 1000.0;                   // parts of a s, and of the value: what a hand can mean
constexpr double same_moment = 2e-3;                  // s; a point is there already
constexpr float number_width = 7.5F;                  // em
constexpr float least_height = 10, curve_height = 6;  // em
constexpr double usual_high = 2.0;                    // the value axis ends here until a point goes beyond

/// One curve as it is shown.
struct ShownCurve {
    Points points;
    ui::Curve curve;
    bool stale = true;
    double high = usual_high;
};
struct CurvesShown {
    int kind = 0;
    std::size_t typed = 0;  ///< the point whose numbers are shown: stays the same while one of them is dragged
    std::array<ShownCurve, kinds.size()> all;
};

/// A curve without points is 1 all the time. It gets one point, so that a person can start with it.
Points or_even(const Points& points) {
    return points.empty() ? Points{{0.0, 1.0}} : points;
}

bool ascending(const Points& points) {
    for (std::size_t i = 1; i < points.size(); ++i)
        if (!(points[i].time > points[i - 1].time)) return false;
    return true;
}

/// Makes `shown` equal to the scene's curve. The scale does not change during a drag.
void follow(ShownCurve& shown, const Points& points, double highest, bool dragging) {
    if (!shown.stale && shown.points == points && dragging) return;
    if (shown.stale || shown.points != points) {
        shown.stale = false;
        shown.points = points;
        std::vector<ui::CurvePoint> drawn;
        for (const CurvePoint& point : or_even(points)) {
            const bool later = drawn.empty() || point.time > drawn.back().x;
            if (later && std::isfinite(point.time) && std::isfinite(point.value))
                drawn.push_back({.x = point.time, .y = point.value});
        }
        if (drawn.empty()) drawn.push_back({.x = 0, .y = 1});
        shown.curve.set_points(drawn);
    }
    if (dragging) return;
    double top = 0;
    for (const CurvePoint& point : points) top = std::max(top, point.value);
    shown.high = top < usual_high ? std::min(usual_high, highest) : highest;
}

/// What was drawn, rounded where the points stay apart.
Points points_of(const ui::Curve& curve) {
    Points exact, round;
    for (const ui::CurvePoint& p : curve.points()) {
        exact.push_back({p.x, p.y});
        round.push_back({std::round(p.x * roundest) / roundest, std::round(p.y * roundest) / roundest});
    }
    return ascending(round) ? round : exact;
}

std::size_t nearest_to(const Points& points, double time) {
    std::size_t nearest = 0;
    for (std::size_t i = 1; i < points.size(); ++i)
        if (std::abs(points[i].time - time) < std::abs(points[nearest].time - time)) nearest = i;
    return nearest;
}

class CurveTools {
  public:
    CurveTools(ui::Ui& ui, document::Document& document, double now, ui::Toasts& toasts, const CurveKind& kind,
               const Table& table)
        : ui_(ui), document_(document), now_(now), toasts_(toasts), kind_(kind), table_(table) {}

    const Points& points() const { return document_.scene().curves.*kind_.points; }

    void build() {
        const double now = now_;
        const bool there = !points().empty() && std::abs(points()[nearest_to(points(), now)].time - now) < same_moment;
        ui_.push_disabled(there || points().size() >= table_.list->maximum);
        if (ui::icon_button(ui_, ui::Icon::plus, "Add point",
                            {.tip = "Adds a point at the current time", .quiet = true}))
            add(now);
        ui_.pop_disabled();
        ui_.push_disabled(points().empty());
        if (ui::icon_button(
                ui_, ui::Icon::minus, "Remove point",
                {.tip = "Removes the point nearest to the current time (Delete: the selected points)", .quiet = true}))
            remove(now);
        if (ui::icon_button(ui_, ui::Icon::copy, "Copy as text",
                            {.tip = "Copies the points as text, one per line: time in s and value", .quiet = true}) &&
            ui_.clipboard() != nullptr)
            ui_.clipboard()->set(document::curve_text(points()));
        ui_.pop_disabled();
        ui_.push_disabled(ui_.clipboard() == nullptr);
        if (ui::button(ui_, "Paste",
                       {.tip = "Pastes points from text, one per line: time in s and value", .quiet = true}))
            paste();
        ui_.pop_disabled();
        ui_.push_disabled(points().empty());
        if (ui::icon_button(ui_, ui::Icon::reset, "Reset",
                            {.tip = "Removes all points: the factor is 1 all the time", .quiet = true}))
            change("Reset " + std::string(table_.name), {});
        ui_.pop_disabled();
    }

  private:
    void change(std::string name, Points made) {
        document_.change(std::move(name), [&](document::Content& c) { c.scene.curves.*kind_.points = made; });
    }
    void add(double time) {
        Points made = points();
        const double value = std::round(curve_at(made, time) * roundest) / roundest;
        const auto at = std::find_if(made.begin(), made.end(), [&](const CurvePoint& p) { return p.time > time; });
        made.insert(at, {std::round(time * roundest) / roundest, value});
        change("Add curve point", std::move(made));
    }
    void remove(double time) {
        Points made = points();
        made.erase(made.begin() + static_cast<std::ptrdiff_t>(nearest_to(made, time)));
        change("Remove curve point", std::move(made));
    }
    void paste() {
        try {
            change("Paste " + std::string(table_.name), document::parse_curve_text(ui_.clipboard()->get(), table_));
        } catch (const Error& error) {
            const Fault& fault = error.faults().front();
            toasts_.add({.kind = ui::ToastKind::error,
                         .text = "The clipboard does not contain a curve: " + fault.place + ": " + fault.reason});
        }
    }

    ui::Ui& ui_;
    document::Document& document_;
    double now_;  ///< s
    ui::Toasts& toasts_;
    const CurveKind& kind_;
    const Table& table_;
};

void value_now(ui::Ui& ui, double now, const Points& points) {
    ui::ShortText text;
    text.add("x ").add(curve_at(points, now), 2).add(" at ").add(now, 2).add(" s");
    ui::label(ui, text.view(), {.tone = ui::Tone::dim, .number = true});
}

/// Time and value of the point nearest to the current time, to be typed.
void numbers_of_point(ui::Ui& ui, document::Document& document, double now, const CurveKind& kind, const Table& table,
                      std::size_t& number) {
    const Points& points = document.scene().curves.*kind.points;
    if (points.empty()) return;
    if (!document.in_gesture() || number >= points.size()) number = nearest_to(points, now);
    const auto put = [&](const char* label, double value, const Parameter& row, double low, double high,
                         std::string_view unit, double CurvePoint::*part) {
        const ui::Edit edit = ui::number_field(ui, label, value,
                                               {.minimum = low,
                                                .maximum = std::isfinite(high) ? high : low + 1,
                                                .hard_minimum = low,
                                                .hard_maximum = high,
                                                .step = 0.05,
                                                .unit = unit,
                                                .tip = row.help,
                                                .width = ui::px(ui.em(number_width))});
        document.take(edit, "Curve point",
                      [&, number](document::Content& c) { (c.scene.curves.*kind.points)[number].*part = value; });
    };
    const Parameter &time = *table.find_row("time"), &factor = *table.find_row("value");
    const double before = number > 0 ? points[number - 1].time + 1 / roundest : time.minimum;
    const double after = number + 1 < points.size() ? points[number + 1].time - 1 / roundest : time.maximum;
    // In a file, points may be too close for any time between them.
    const double given = points[number].time;
    put("Time", points[number].time, time, std::min(before, given), std::max(after, given), "s", &CurvePoint::time);
    put("Value", points[number].value, factor, factor.minimum, factor.maximum, {}, &CurvePoint::value);
}

void take(document::Document& document, ui::Toasts& toasts, const ui::Edit& edit, const CurveKind& kind,
          const Table& table, ShownCurve& shown) {
    Points drawn = points_of(shown.curve);
    // The document keeps round figures; the next frame shows these.
    if (edit.changed) shown.stale = true;
    if (drawn.size() > table.list->maximum) {
        toasts.add({.kind = ui::ToastKind::warning,
                    .text = std::string(table.name) + ": a curve has at most " + std::to_string(table.list->maximum) +
                            " points"});
        return;
    }
    if (drawn == or_even(document.scene().curves.*kind.points)) drawn = document.scene().curves.*kind.points;
    document.take(edit, table.name, [&](document::Content& c) { c.scene.curves.*kind.points = drawn; });
}

}  // namespace

void curves_panel(ui::Ui& ui, document::Document& document, const app::Timeline& timeline, ui::Toasts& toasts) {
    static const ui::Curve even({{.x = 0, .y = 1}});
    static const std::array tables = {document::curve_table(kinds[0].key), document::curve_table(kinds[1].key),
                                      document::curve_table(kinds[2].key)};
    static const std::array names = {tables[0]->name, tables[1]->name, tables[2]->name};
    auto& memory = ui.memory<CurvesShown>(ui.id_of("Curves"));
    const float height = ui.rect_before(ui.parent().id).h;
    ui.follow_size(ui.parent());
    const bool low = height > 0 && height < ui.em(least_height);  // then the whole panel scrolls
    std::optional<ui::ScrollArea> all;
    if (low) all.emplace(ui, "All of it");
    ui::Node& room = ui.open(ui::Role::group, "Area", ui::Axis::y);
    room.size[0] = ui::grow(), room.size[1] = low ? ui::fit() : ui::grow();
    room.gap = ui.em(0.2F);
    ui.follow_size(room);
    float wanted = 0;
    for (const std::string_view name : names) wanted += ui.text_width(name) + ui.em(1.6F);
    const float width = ui.rect_before(room.id).w;
    const bool one_row = width > wanted + ui.em(22), narrow = width > 0 && width < wanted;
    const auto choose = [&] {
        if (narrow) {
            ui::combo(ui, "Curve", memory.kind, names, {.width = ui::grow()});
            return;
        }
        const ui::Row row(ui, {.width = one_row ? ui::px(wanted) : ui::grow()});
        ui::segmented(ui, "Curve", memory.kind, names);
    };
    if (!one_row) choose();
    const bool wide = (one_row ? width - wanted : width) > ui.em(22 + 2 * number_width);
    std::size_t number = 0;
    const auto numbers = [&] {
        numbers_of_point(ui, document, timeline.time, kinds[number], *tables[number], memory.typed);
    };
    {
        const ui::Row row(ui, {.width = ui::grow(), .gap = 0.3F, .cross = ui::ChildAlign::center});
        if (one_row) choose(), ui::space(ui, 0.6F);
        number = static_cast<std::size_t>(memory.kind);
        CurveTools tools(ui, document, timeline.time, toasts, kinds[number], *tables[number]);
        if (!narrow) value_now(ui, timeline.time, tools.points());  // the plot shows it as well
        if (wide) numbers();
        ui::spacer(ui);
        tools.build();
    }
    if (!wide && !(document.scene().curves.*kinds[number].points).empty()) {
        const ui::Row row(ui, {.width = ui::grow(), .gap = 0.3F});
        numbers();
    }
    const CurveKind& kind = kinds[number];
    const Table& table = *tables[number];
    const Points& points = document.scene().curves.*kind.points;
    ShownCurve& shown = memory.all[number];
    follow(shown, points, table.find_row("value")->maximum, document.in_gesture());
    const double end = std::max(timeline.duration(), points.empty() ? 0.0 : points.back().time);
    const ui::Edit edit = ui::curve_editor(ui, table.name, shown.curve,
                                           {.x = {0, std::max(end, 0.1)},
                                            .y = {0, shown.high},
                                            .x_step = 0.05,
                                            .y_step = 0.05,
                                            .x_name = "Time",
                                            .x_unit = "s",
                                            .y_name = {},
                                            .y_unit = {},
                                            .standard = &even,
                                            .live = timeline.time,
                                            .width = ui::grow(),
                                            .height = low ? ui::px(ui.em(curve_height)) : ui::grow(),
                                            .tip = table.help});
    if (edit.began || edit.changed || edit.committed || edit.cancelled)
        take(document, toasts, edit, kind, table, shown);
    ui.close();
}

}  // namespace lapfx::panels
