#include "panels/painted_strokes.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "app/measure/blood_strokes.h"
#include "app/measure/measure_bench.h"
#include "app/measure/measuring.h"
#include "app/reference/reference.h"
#include "panels/edited.h"
#include "panels/place_handle.h"
#include "ui/core/node.h"
#include "ui/shell/commands.h"
#include "ui/widgets/basic.h"
#include "ui/widgets/param.h"

namespace lapfx::panels {

namespace {

constexpr int other_series = 2;            // of the theme: beside that of blood
constexpr float body = 0.3F, core_px = 2;  // opacity of a stroke, and px of the line along its middle
constexpr double least_way = 0.5;          // of the brush's radius, from one point of a stroke to the next

/// px of the screen.
struct StrokeLook {
    std::span<const glm::vec2> points;
    float radius = 0;
    ui::Color color;
};
struct StrokesLook {
    std::span<const StrokeLook> strokes;
    glm::vec2 pointer{0};
    float brush = 0;  ///< its radius around the pointer; 0: the pointer is elsewhere
    ui::Color color;
};

void draw_dot(ui::Painter& painter, glm::vec2 at, float radius, ui::Color color) {
    painter.fill({at.x - radius, at.y - radius, 2 * radius, 2 * radius}, color, radius);
}

void draw_strokes(ui::Painter& painter, const ui::Node&, const StrokesLook& look) {
    for (const StrokeLook& stroke : look.strokes) {
        const float core = std::min(0.5F * core_px * painter.hairline(), stroke.radius);
        const ui::Color soft = ui::with_alpha(stroke.color, body);
        draw_dot(painter, stroke.points.front(), stroke.radius, soft);
        painter.polyline(stroke.points, 2 * stroke.radius, soft);
        draw_dot(painter, stroke.points.back(), stroke.radius, soft);
        draw_dot(painter, stroke.points.front(), 2 * core, stroke.color);
        painter.polyline(stroke.points, 2 * core, stroke.color);
    }
    if (look.brush <= 0) return;
    const glm::vec2 low = look.pointer - look.brush;
    painter.frame({low.x, low.y, 2 * look.brush, 2 * look.brush}, look.color, painter.hairline(), look.brush);
}

class Strokes {
  public:
    Strokes(ui::Ui& ui, const ui::View& view, const MeasureParts& on) : ui_(ui), view_(view), on_(on) {}

    void build() {
        ui::Node& node = ui_.leaf(ui::Role::none, "##strokes", ui::Sense::hover | ui::Sense::press | ui::Sense::focus);
        node.size[0] = ui::fraction(1), node.size[1] = ui::fraction(1);
        node.placed = true;
        node.placement = ui_.arena().make(ui::Placement{});
        const ui::Id id = node.id;
        const ui::Response r = ui_.respond(node);
        if (r.hovered || r.held) ui_.set_cursor(ui::Cursor::crosshair);
        paint(id);
        const StrokeMark marks = look().stroke ? look().stroke->marks : marks_of(r.mods);
        StrokesLook made{.strokes = seen(),
                         .pointer = r.pointer,
                         .brush = r.hovered || r.held ? on_screen(look().brush) : 0.0F,
                         .color = color_of(marks)};
        ui_.draw_with<draw_strokes>(ui_.last(), made);
    }

  private:
    app::MeasureLook& look() { return on_.bench.look; }
    const ReferenceMeasure& measure() const { return on_.edited.document.scene().reference.measure; }
    float on_screen(double radius) const { return static_cast<float>(radius * view_.size.x * view_.zoom); }
    ui::Color color_of(StrokeMark marks) const {
        return ui_.theme().series[marks == StrokeMark::blood ? app::blood_series : other_series];
    }
    StrokeMark marks_of(ui::Mods mods) {
        const bool blood = look().tool == app::MeasureTool::paint_blood;
        const bool turned = ui::has(mods, ui::Mods::shift);
        return blood != turned ? StrokeMark::blood : StrokeMark::other;
    }
    /// Of the picture that is seen, which may come a little after the reference.
    int frame() const { return on_.bench.ready() ? on_.bench.frame() : on_.reference.shown_frame(); }
    double time() const { return app::time_within(*on_.reference.video(), frame()); }

    void paint(ui::Id id) {
        if (!ui_.has_events(id)) return;
        ui_.events_of(id, [&](const ui::Event& event) {
            if (event.kind == ui::EventKind::press && event.button == ui::Button::left && frame() >= 0) {
                on_.reference.hold(frame());
                look().stroke = BloodStroke{.time = time(), .marks = marks_of(event.mods), .radius = look().brush};
                add_point(event.at);
            } else if (event.kind == ui::EventKind::pointer) {
                add_point(event.at);
            } else if (event.kind == ui::EventKind::release && look().stroke) {
                add_point(event.at);
                on_.bench.add_stroke();
                ui_.build_again();
            } else if (event.kind == ui::EventKind::cancel) {
                look().stroke.reset();
            }
        });
    }
    /// A point that is hardly further on says nothing that the brush does not cover already.
    void add_point(glm::vec2 at) {
        if (!look().stroke) return;
        auto& points = look().stroke->points;
        const glm::dvec2 size(view_.size), place = glm::clamp(view_.to_picture(at) / size, 0.0, 1.0);
        const PicturePlace next{rounded_place(place.x), rounded_place(place.y)};
        const auto way = [&](const PicturePlace& last) {
            return glm::length(glm::dvec2(next.x - last.x, next.y - last.y) * size) / size.x;
        };
        if (!points.empty() && way(points.back()) < least_way * look().stroke->radius) return;
        if (points.size() < most_stroke_points) points.push_back(next);
    }

    std::span<const StrokeLook> seen() {
        const int shown = frame();
        const VideoReader& video = *on_.reference.video();
        const auto here = [&](const BloodStroke& stroke) {
            return !stroke.points.empty() && video.frame_at(stroke.time) == shown;
        };
        const auto& strokes = measure().strokes;
        const std::size_t count = static_cast<std::size_t>(std::ranges::count_if(strokes, here)) + 1;
        auto* const made = static_cast<StrokeLook*>(ui_.arena().take(count * sizeof(StrokeLook), alignof(StrokeLook)));
        std::size_t at = 0;
        for (const BloodStroke& stroke : strokes)
            if (here(stroke)) new (made + at++) StrokeLook(look_of(stroke));
        if (look().stroke) new (made + at++) StrokeLook(look_of(*look().stroke));
        return {made, at};
    }
    StrokeLook look_of(const BloodStroke& stroke) {
        const std::size_t count = stroke.points.size();
        auto* const points = static_cast<glm::vec2*>(ui_.arena().take(count * sizeof(glm::vec2), alignof(glm::vec2)));
        for (std::size_t i = 0; i < count; ++i)
            points[i] =
                glm::vec2(view_.to_screen(glm::dvec2(stroke.points[i].x, stroke.points[i].y) * glm::dvec2(view_.size)));
        return {.points = {points, count}, .radius = on_screen(stroke.radius), .color = color_of(stroke.marks)};
    }

    ui::Ui& ui_;
    const ui::View& view_;
    const MeasureParts& on_;
};

/// A frame that was painted.
struct PaintedFrame {
    int frame = 0;
    int blood = 0, other = 0;  ///< strokes
};

/// By their frames.
std::vector<PaintedFrame>& painted_frames(ui::Ui& ui, const MeasureParts& on) {
    auto& frames = ui.memory<std::vector<PaintedFrame>>(ui.id_of("painted frames"));
    frames.clear();
    for (const BloodStroke& stroke : on.edited.document.scene().reference.measure.strokes) {
        const int frame = on.reference.video()->frame_at(stroke.time);
        auto at = std::ranges::lower_bound(frames, frame, {}, &PaintedFrame::frame);
        if (at == frames.end() || at->frame != frame) at = frames.insert(at, {.frame = frame});
        ++(stroke.marks == StrokeMark::blood ? at->blood : at->other);
    }
    return frames;
}

void frame_line(ui::Ui& ui, const MeasureParts& on, const PaintedFrame& painted) {
    ui.push_seed(static_cast<std::uint64_t>(painted.frame));
    char text[96];
    std::snprintf(text, sizeof text, "%.2f s: %d blood, %d other", on.reference.video()->time_of(painted.frame),
                  painted.blood, painted.other);
    const ui::Row line(ui, {.width = ui::grow(), .cross = ui::ChildAlign::center});
    if (ui::button(ui, "Show", {.tip = "Shows this frame of the reference and holds it", .quiet = true}))
        on.reference.hold(painted.frame);
    ui::label(ui, ui.copy(text), {.width = ui::grow()});
    if (ui::icon_button(ui, ui::Icon::cross, "Remove strokes of this frame", {.quiet = true}))
        on.edited.document.change("Remove strokes", [&](document::Content& c) {
            ReferenceMeasure& measure = c.scene.reference.measure;
            std::erase_if(measure.strokes, [&](const BloodStroke& stroke) {
                return on.reference.video()->frame_at(stroke.time) == painted.frame;
            });
            if (measure.strokes.empty()) measure.without_blood = -1.0;
        });
    ui.pop_seed();
}

}  // namespace

void paint_strokes(ui::Ui& ui, const ui::View& view, void* with) {
    Strokes(ui, view, *static_cast<const MeasureParts*>(with)).build();
}

void painted_strokes(ui::Ui& ui, const MeasureParts& on) {
    const ReferenceMeasure& measure = on.edited.document.scene().reference.measure;
    app::MeasureLook& look = on.bench.look;
    if (look.paints())
        ui::param(ui, "Brush", look.brush,
                  ui::percent({.minimum = 100 * look.least_brush,
                               .maximum = 100 * look.most_brush,
                               .hard_minimum = 100 * look.least_brush,
                               .hard_maximum = 100 * look.most_brush,
                               .step = 0.1,
                               .tip = "Radius of the brush, of the picture's width. [ makes it smaller, ] larger"}));
    for (const PaintedFrame& painted : painted_frames(ui, on)) frame_line(ui, on, painted);
    for (const Fault& fault : on.bench.stroke_faults())
        ui::label(ui,
                  ui.join({"Nothing is learned from the strokes yet: ", ui.copy(app::text_of(fault, measure)), "."}),
                  {.tone = ui::Tone::warning, .wrap = true, .width = ui::grow()});
}

}  // namespace lapfx::panels
