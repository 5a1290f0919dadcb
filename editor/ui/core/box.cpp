#include "ui/core/node.h"
#include "ui/core/ui.h"

namespace lapfx::ui {

namespace {

void arrange(Ui& ui, Node& node, const BoxOptions& options) {
    node.size[0] = options.width;
    node.size[1] = options.height;
    node.gap = ui.em(options.gap < 0 ? ui.theme().gap : options.gap);
    for (std::uint8_t& pad : node.padding)
        pad = static_cast<std::uint8_t>(std::clamp(ui.em(options.padding), 0.0F, 255.0F));
    node.cross = options.cross;
    node.main = options.main;
    node.rigid = false;
}

void draw_panel(Painter& painter, const Node& node, const Color& color) {
    node.placed ? painter.fill(node.rect(), color, painter.em(painter.theme().radius))
                : painter.ground(node.rect(), color);
}

}  // namespace

Box::Box(Ui& ui, Axis axis, const BoxOptions& options) : ui_(ui) {
    arrange(ui, ui.open(Role::none, {}, axis), options);
}

Panel::Panel(Ui& ui, std::string_view label, const BoxOptions& options) : ui_(ui) {
    Node& node = ui.open(Role::panel, label, Axis::y);
    arrange(ui, node, options);
    node.clips = true;
    ui.draw_with<draw_panel>(node, ui.theme().panel);
}

void spacer(Ui& ui, float weight) {
    const Axis axis = ui.parent().axis;
    Node& node = ui.leaf(Role::none, {});
    node.size[static_cast<int>(axis)] = grow(weight);
}

void space(Ui& ui, float ems) {
    const Axis axis = ui.parent().axis;
    Node& node = ui.leaf(Role::none, {});
    node.size[static_cast<int>(axis)] = px(ui.em(ems));
}

}  // namespace lapfx::ui
