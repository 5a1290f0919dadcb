#include "panels/measure_shapes.h"

#include <algorithm>
#include <array>

#include "panels/place_handle.h"
#include "ui/core/node.h"

namespace lapfx::panels {

namespace {

using document::Content;

constexpr std::size_t least_corners = 3;
constexpr double least_side = 0.05;    // the table allows no smaller part of the picture for the region
constexpr float closing_reach = 0.9F;  // em around the first corner

/// What is drawn below the handles, px of the screen: polygons one after the other.
struct ShapesLook {
    std::span<const glm::vec2> corners;
    std::span<const std::size_t> ends;  ///< each polygon has one
    std::span<const glm::vec2> drawn;   ///< the one that is being drawn, with the pointer as its last corner
    ui::Rect region;
};

void draw_shapes(ui::Painter& painter, const ui::Node&, const ShapesLook& look) {
    const ui::Theme& t = painter.theme();
    const float width = 1.5F * painter.hairline();
    const ui::Color ink = ui::canvas_ink(t);
    std::size_t first = 0;
    for (const std::size_t end : look.ends) {
        for (std::size_t i = first; i < end; ++i)
            painter.line(look.corners[i], look.corners[i + 1 < end ? i + 1 : first], width, ink);
        first = end;
    }
    if (!look.drawn.empty()) painter.polyline(look.drawn, width, t.accent);
    if (!look.region.empty()) painter.frame(look.region, ui::canvas_ink(t, 0.6F), painter.hairline());
}

class Shapes {
  public:
    Shapes(ui::Ui& ui, const MeasureShapes& of, const ui::View& view)
        : ui_(ui),
          bench_(of.bench),
          edited_(of.edited),
          view_(view),
          region_(measure().region),
          count_(std::min(measure().parts.size(), most_left_out_parts)) {
        for (std::size_t i = 0; i < count_; ++i) {
            const auto& corners = measure().parts[i].corners;
            corner_counts_[i] = std::min(corners.size(), most_part_corners);
            std::copy_n(corners.begin(), corner_counts_[i], corners_[i].begin());
        }
    }

    void build() {
        ui::Node& below = ui_.leaf(
            ui::Role::none, "##parts",
            bench_.look.tool == app::MeasureTool::draw_part
                ? ui::Sense::hover | ui::Sense::press | ui::Sense::focus | ui::Sense::activate | ui::Sense::erase
                : ui::Sense::none);
        below.size[0] = ui::fraction(1), below.size[1] = ui::fraction(1);
        below.placed = true;
        below.placement = ui_.arena().make(ui::Placement{});
        glm::vec2 pointer{0};
        const bool drawing = bench_.look.tool == app::MeasureTool::draw_part;
        if (drawing) pointer = draw_part(below);
        ui_.draw_with<draw_shapes>(below, look(drawing, pointer));
        if (drawing) return;
        for (std::size_t i = 0; i < count_; ++i) part_handles(i);
        region_handles();
    }

  private:
    const ReferenceMeasure& measure() const { return edited_.document.scene().reference.measure; }
    static glm::dvec2 place_of(const PicturePlace& corner) { return {corner.x, corner.y}; }
    glm::vec2 on_screen(glm::dvec2 place) const { return glm::vec2(view_.to_screen(place * glm::dvec2(view_.size))); }
    glm::dvec2 in_picture(glm::vec2 at) const {
        const glm::dvec2 place = glm::clamp(view_.to_picture(at) / glm::dvec2(view_.size), 0.0, 1.0);
        return {rounded_place(place.x), rounded_place(place.y)};
    }
    void knob(float size) {
        ui_.draw_with<ui::draw_knob>(ui_.last(),
                                     ui::KnobLook{.color = ui::canvas_ink(ui_.theme()), .size = glm::vec2(size)});
    }
    glm::vec2* points(std::size_t count) {
        return static_cast<glm::vec2*>(ui_.arena().take((count + 1) * sizeof(glm::vec2), alignof(glm::vec2)));
    }

    ShapesLook look(bool drawing, glm::vec2 pointer) {
        ShapesLook made;
        std::size_t all = 0;
        for (std::size_t i = 0; i < count_; ++i) all += corner_counts_[i];
        glm::vec2* const corners = points(all);
        auto* const ends =
            static_cast<std::size_t*>(ui_.arena().take((count_ + 1) * sizeof(std::size_t), alignof(std::size_t)));
        std::size_t at = 0;
        for (std::size_t i = 0; i < count_; ++i) {
            for (std::size_t j = 0; j < corner_counts_[i]; ++j) corners[at++] = on_screen(place_of(corners_[i][j]));
            ends[i] = at;
        }
        made.corners = {corners, all}, made.ends = {ends, count_};
        const glm::vec2 low = on_screen({region_.x, region_.y});
        const glm::vec2 high =
            on_screen({std::min(region_.x + region_.width, 1.0), std::min(region_.y + region_.height, 1.0)});
        made.region = {low.x, low.y, high.x - low.x, high.y - low.y};
        if (!drawing || bench_.look.drawn.empty()) return made;
        const auto& drawn = bench_.look.drawn;
        glm::vec2* const line = points(drawn.size() + 1);
        for (std::size_t i = 0; i < drawn.size(); ++i) line[i] = on_screen(place_of(drawn[i]));
        line[drawn.size()] = pointer;
        made.drawn = {line, drawn.size() + 1};
        return made;
    }

    /// Gives where the pointer is, px of the screen.
    glm::vec2 draw_part(ui::Node& node) {
        auto& drawn = bench_.look.drawn;
        node.tip =
            "Click the corners of the part. A double click, Enter or a click on the first corner closes it; "
            "Backspace takes the last corner back";
        const ui::Id id = node.id;
        const ui::Response r = ui_.respond(node);
        if (r.hovered) ui_.set_cursor(ui::Cursor::crosshair);
        bool closes = false;
        if (ui_.has_events(id))
            ui_.events_of(id, [&](const ui::Event& event) {
                if (event.kind != ui::EventKind::key) return;
                closes |= event.key == ui::Key::enter;
                if (event.key == ui::Key::backspace && !drawn.empty()) drawn.pop_back();
            });
        if (r.pressed) {
            const bool near = drawn.size() >= least_corners &&
                              glm::distance(r.pressed_at, on_screen(place_of(drawn.front()))) < ui_.em(closing_reach);
            closes |= near || r.clicks >= 2;
            if (!closes && drawn.size() < most_part_corners) {
                const glm::dvec2 place = in_picture(r.pressed_at);
                drawn.push_back({place.x, place.y});
            }
        }
        if (closes && drawn.size() >= least_corners) bench_.close_part(), ui_.build_again();
        return r.pointer;
    }

    void change_part(const ui::Edit& edit, std::string_view step, std::size_t index, const auto& set) {
        edited_.document.take(edit, step, [&](Content& c) {
            auto& parts = c.scene.reference.measure.parts;
            if (index < parts.size()) set(parts[index].corners);
        });
    }
    void remove_part(std::size_t index) {
        edited_.document.change("Remove part", [&](Content& c) {
            auto& parts = c.scene.reference.measure.parts;
            if (index < parts.size()) parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(index));
        });
    }

    void part_handles(std::size_t index) {
        const std::string_view name = ui_.join({"Part ", ui_.copy(std::to_string(index + 1))});
        bool removed = false;
        for (std::size_t j = 0; j < corner_counts_[index] && !removed; ++j) removed = corner_handle(index, j, name);
        if (!removed && corner_counts_[index] > 0) whole_handle(index, name);
    }
    /// Gives whether it took something out.
    bool corner_handle(std::size_t index, std::size_t j, std::string_view name) {
        glm::dvec2 place = place_of(corners_[index][j]);
        const ui::HandleMoves moves =
            put_place(ui_, view_, ui_.join({name, " corner ", ui_.copy(std::to_string(j + 1))}),
                      "A corner of a part that is not measured. Delete takes it out", place);
        knob(0.6F);
        const ui::Edit edit = edit_place(
            ui_, view_, moves, [](glm::dvec2 p) { return glm::clamp(p, 0.0, 1.0); }, place);
        change_part(edit, "Move corner", index, [&](auto& corners) {
            if (j < corners.size()) corners[j] = {place.x, place.y};
        });
        if (!moves.reset) return false;
        if (corner_counts_[index] <= least_corners) {
            remove_part(index);
        } else {
            change_part(ui::Edit::once(), "Remove corner", index, [&](auto& corners) {
                if (j < corners.size()) corners.erase(corners.begin() + static_cast<std::ptrdiff_t>(j));
            });
        }
        return true;
    }
    void whole_handle(std::size_t index, std::string_view name) {
        glm::dvec2 low{1}, high{0};
        for (std::size_t j = 0; j < corner_counts_[index]; ++j) {
            low = glm::min(low, place_of(corners_[index][j]));
            high = glm::max(high, place_of(corners_[index][j]));
        }
        const glm::dvec2 half = 0.5 * (high - low), before = low + half;
        glm::dvec2 place = before;
        const ui::HandleMoves moves =
            put_place(ui_, view_, name, "A part that is not measured. Delete takes it out", place);
        knob(0.9F);
        const ui::Edit edit = edit_place(
            ui_, view_, moves, [&](glm::dvec2 p) { return glm::clamp(p, half, 1.0 - half); }, place);
        const glm::dvec2 way = place - before;
        change_part(edit, "Move part", index, [&](auto& corners) {
            for (PicturePlace& corner : corners) {
                corner.x = std::clamp(corner.x + way.x, 0.0, 1.0);
                corner.y = std::clamp(corner.y + way.y, 0.0, 1.0);
            }
        });
        if (moves.reset) remove_part(index);
    }

    void region_handles() {
        const glm::dvec2 low(region_.x, region_.y);
        const glm::dvec2 high = glm::min(low + glm::dvec2(region_.width, region_.height), 1.0);
        constexpr std::string_view tip = "Only what is inside the region is measured. Delete puts it back";
        const auto set = [&](const ui::HandleMoves& moves, ui::Edit edit, glm::dvec2 from, glm::dvec2 to) {
            const auto side = [](double a, double b) { return std::clamp(rounded_place(b - a), least_side, 1.0); };
            MeasuredRegion next{from.x, from.y, side(from.x, to.x), side(from.y, to.y)};
            if (moves.reset || moves.initial) {
                next = moves.initial ? MeasuredRegion{} : edited_.saved.content().scene.reference.measure.region;
                edit = ui::Edit::once();
            }
            edited_.document.take(edit, "Region", [&](Content& c) { c.scene.reference.measure.region = next; });
        };
        glm::dvec2 corner = low;
        const ui::HandleMoves upper = put_place(ui_, view_, "Region upper left", tip, low);
        knob(0.6F);
        ui::Edit edit = edit_place(
            ui_, view_, upper, [&](glm::dvec2 p) { return glm::clamp(p, glm::dvec2(0), high - least_side); }, corner);
        set(upper, edit, corner, high);
        corner = high;
        const ui::HandleMoves lower = put_place(ui_, view_, "Region lower right", tip, high);
        knob(0.6F);
        edit = edit_place(
            ui_, view_, lower, [&](glm::dvec2 p) { return glm::clamp(p, low + least_side, glm::dvec2(1)); }, corner);
        set(lower, edit, low, corner);
    }

    ui::Ui& ui_;
    app::MeasureBench& bench_;
    const Edited& edited_;
    const ui::View& view_;
    // Copied before any handle changes them.
    const MeasuredRegion region_;
    std::array<std::array<PicturePlace, most_part_corners>, most_left_out_parts> corners_;
    std::array<std::size_t, most_left_out_parts> corner_counts_{};
    const std::size_t count_;
};

}  // namespace

void MeasureShapes::build(ui::Ui& ui, const ui::View& view, void* with) {
    const MeasureShapes& of = *static_cast<MeasureShapes*>(with);
    if (view.area.empty() || !of.bench.look.left_out) return;
    Shapes(ui, of, view).build();
}

}  // namespace lapfx::panels
