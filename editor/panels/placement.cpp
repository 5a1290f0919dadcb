#include "panels/placement.h"

#include <cmath>

#include "lapfx/authoring/placed_picture.h"
#include "lapfx/scene.h"
#include "panels/place_handle.h"
#include "panels/table_rows.h"
#include "ui/core/node.h"
#include "ui/widgets/basic.h"
#include "ui/widgets/param.h"
#include "ui/widgets/toolbar.h"

namespace lapfx::panels {

namespace {

using document::Content;

constexpr double arm = 0.35;         // heights from the middle to the handle that turns and scales
constexpr float value_width = 9.5F;  // em

const Table& placement_table() {
    static const Table& table = *scene_table().find("reference")->find("placement");
    return table;
}

double kept(double value) {
    return std::round(value * 1e4) / 1e4;
}

void knob(ui::Ui& ui, float size) {
    ui::Node& node = ui.last();
    ui.draw_with<ui::draw_knob>(node, ui::KnobLook{.color = ui::canvas_ink(ui.theme()), .size = glm::vec2(size)});
}

/// The reference's frame and the arm that turns it, on the screen.
struct Outline {
    std::array<glm::vec2, 5> frame;
    glm::vec2 middle, side;
};

void draw_outline(ui::Painter& painter, const ui::Node&, const Outline& outline) {
    const ui::Color ink = ui::canvas_ink(painter.theme(), 0.6F);
    painter.polyline(outline.frame, painter.hairline(), ink);
    painter.line(outline.middle, outline.side, painter.hairline(), ink);
}

void put_outline(ui::Ui& ui, const ui::View& view, const ReferencePlacement& now) {
    const double aspect = double(view.size.x) / view.size.y;
    const auto on_screen = [&](glm::dvec2 place) {
        return glm::vec2(view.to_screen(placed(now, aspect, place) * double(view.size.y)));
    };
    Outline outline{.frame = {}, .middle = on_screen({aspect / 2, 0.5}), .side = on_screen({aspect / 2 + arm, 0.5})};
    constexpr std::array<glm::dvec2, 5> corners = {{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}}};
    for (std::size_t i = 0; i < corners.size(); ++i) outline.frame[i] = on_screen(corners[i] * glm::dvec2(aspect, 1));
    ui::Node& below = ui.leaf(ui::Role::none, "##outline", ui::Sense::none);
    below.size[0] = ui::fraction(1), below.size[1] = ui::fraction(1);
    below.placed = true;
    below.placement = ui.arena().make(ui::Placement{});
    ui.draw_with<draw_outline>(below, outline);
}

}  // namespace

void PlacementHandles::build(ui::Ui& ui, const ui::View& view, void* with) {
    if (view.area.empty() || view.size.y < 1) return;
    document::Document& document = static_cast<PlacementHandles*>(with)->edited.document;
    const ReferencePlacement now = document.scene().reference.placement;
    const double aspect = double(view.size.x) / view.size.y;
    const glm::dvec2 heights(aspect, 1), middle(aspect / 2, 0.5);
    const auto anywhere = [](glm::dvec2 place) { return glm::clamp(place, -2.0, 3.0); };
    const auto take = [&](const ui::HandleMoves& moves, const ui::Edit& edit, const ReferencePlacement& wanted) {
        if (moves.reset) {
            document.change("Place the reference",
                            [](Content& c) { c.scene.reference.placement = ReferencePlacement{}; });
            return;
        }
        document.take(edit, "Place the reference", [&](Content& c) { c.scene.reference.placement = wanted; });
    };

    put_outline(ui, view, now);
    const glm::dvec2 center = placed(now, aspect, middle);
    glm::dvec2 place = center / heights;
    ui::HandleMoves moves =
        put_place(ui, view, "Reference's middle", "Moves the reference. Delete: as it was stored", place);
    knob(ui, 0.9F);
    ui::Edit edit = edit_place(ui, view, moves, anywhere, place);
    ReferencePlacement wanted = now;
    const glm::dvec2 shift = place * heights - middle;
    wanted.right = kept(std::clamp(shift.x, -2.0, 2.0)), wanted.up = kept(std::clamp(-shift.y, -2.0, 2.0));
    take(moves, edit, wanted);
    if (moves.reset) return;

    place = placed(now, aspect, middle + glm::dvec2(arm, 0)) / heights;
    moves = put_place(ui, view, "Reference's side", "Turns and scales the reference. Delete: as it was stored", place);
    knob(ui, 0.6F);
    edit = edit_place(ui, view, moves, anywhere, place);
    const glm::dvec2 way = place * heights - center;
    wanted = now;
    if (glm::length(way) > 1e-6) {
        wanted.scale = kept(std::clamp(glm::length(way) / arm, 0.1, 10.0));
        wanted.rotation = kept(glm::degrees(std::atan2(-way.y, way.x)));
    }
    take(moves, edit, wanted);
}

void placement_row(ui::Ui& ui, const Edited& edited, ui::CommandTable& commands, float room) {
    document::Document& document = edited.document;
    const std::span<const Parameter> rows = placement_table().rows;
    const std::size_t circle = rows.size(), reset = circle + 1;
    std::array<ui::ToolItem, 6> items;
    for (std::size_t i = 0; i < rows.size(); ++i)
        items[i] = {.width = ui.em(value_width), .rank = static_cast<int>(i) / 2};
    items[circle] = {.width = ui::tool_width(ui, "Take the circle"), .rank = 1};
    items[reset] = {.width = ui::tool_width(ui, "Reset"), .rank = 2};
    ui::toolbar(ui, "Placement tools", room, items, [&](std::size_t item) {
        if (item == circle) return void(ui::command_button(ui, commands, "reference.take_circle"));
        if (item == reset) {
            ui.push_disabled(!document.scene().reference.placement.moved());
            if (ui::button(ui, "Reset", {.tip = "The reference as it is stored", .quiet = true}))
                document.change("Place the reference",
                                [](Content& c) { c.scene.reference.placement = ReferencePlacement{}; });
            return ui.pop_disabled();
        }
        const Parameter& row = rows[item];
        ReferencePlacement placement = document.scene().reference.placement;
        double value = std::get<double>(row.get(&placement));
        ui::ParamOptions options = param_options(row);
        const ReferencePlacement stored;
        options.standard = options.initial = std::get<double>(row.get(&stored));
        options.width = ui::px(ui.em(value_width));
        options.tip = row.help;
        const ui::Edit edit = ui::number_field(ui, row.name, value, options);
        document.take(edit, "Place the reference", [&](Content& c) { row.set(&c.scene.reference.placement, value); });
    });
}

}  // namespace lapfx::panels
