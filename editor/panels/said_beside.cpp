#include "panels/said_beside.h"

#include <algorithm>
#include <cmath>

#include "ui/core/node.h"

namespace lapfx::panels {

namespace {

constexpr double said_for = 6;  // s

float line_width(ui::Ui& ui, std::string_view text) {
    return std::ceil(ui.text_width(text)) + ui.em(1.2F);
}

void draw_line(ui::Painter& painter, const ui::Node& node, const bool&) {
    const ui::Theme& t = painter.theme();
    painter.fill(node.rect(), t.raised, painter.em(t.radius));
    painter.text(node.rect().inset(painter.em(0.6F), 0), node.text, painter.text_style(), t.text);
}

/// A line on a ground of its own.
void put_line(ui::Ui& ui, std::string_view label, std::string_view text, const ui::Placement& placement) {
    ui::Node& node = ui.leaf(ui::Role::status, label);
    node.text = ui.copy(text);
    node.placed = true;
    node.placement = ui.arena().make(placement);
    node.size[0] = ui::px(line_width(ui, text));
    node.size[1] = ui::px(ui.row_height());
    ui.draw_with<draw_line>(node, true);
}

}  // namespace

void say_beside(ui::Ui& ui, SaidBeside& said, std::string_view text, glm::vec2 at) {
    said = {.text = std::string(text), .at = at, .until = ui.time() + said_for};
    ui.build_again();
}

void put_said(ui::Ui& ui, const SaidBeside& said, glm::vec2 picture) {
    if (said.text.empty() || ui.time() >= said.until) return;
    ui.wake_at(said.until, "what is said beside the pointer");
    const glm::vec2 most = picture - glm::vec2(line_width(ui, said.text), ui.row_height());
    const glm::vec2 wish = said.at + glm::vec2(ui.em(1), ui.em(1.2F));
    put_line(ui, "Beside the pointer", said.text,
             {.offset = glm::clamp(wish, glm::vec2(0), glm::max(most, glm::vec2(0)))});
}

void put_in_corner(ui::Ui& ui, std::string_view label, std::string_view text) {
    const float margin = ui.em(0.5F);
    put_line(ui, label, text, {.fraction = {0, 1}, .offset = {margin, -margin}, .pivot = {0, 1}});
}

}  // namespace lapfx::panels
