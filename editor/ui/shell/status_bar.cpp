#include "ui/shell/status_bar.h"

#include "ui/core/node.h"

namespace lapfx::ui {

namespace {

void draw_status_bar(Painter& painter, const Node& node, const Theme* const& theme) {
    Rect rect = node.rect();
    painter.ground(rect, theme->panel);
    painter.fill(rect.cut_top(painter.hairline()), theme->border);
}

struct StatusLook {
    TextStyle style;
    Color color;
    Icon icon;
};

void draw_status(Painter& painter, const Node& node, const StatusLook& look) {
    Rect rect = node.rect();
    if (look.icon != Icon::none) {
        painter.icon(rect.cut_left(painter.em(1)), look.icon, look.color);
        rect.cut_left(painter.em(0.4F));
    }
    painter.text(rect, node.text, look.style, look.color);
}

}  // namespace

StatusBar::StatusBar(Ui& ui) : ui_(ui) {
    Node& node = ui.open(Role::group, "Status bar", Axis::x);
    node.size[0] = grow();
    node.size[1] = px(ui.row_height());
    node.padding[0] = node.padding[2] = static_cast<std::uint8_t>(std::min(ui.em(ui.theme().padding), 255.0F));
    node.cross = ChildAlign::center;
    node.gap = ui.em(1);
    node.clips = true;
    ui.draw_with<draw_status_bar>(node, &ui.theme());
}

void status_text(Ui& ui, std::string_view label_text, std::string_view text, const StatusOptions& options) {
    const TextStyle style = options.number ? ui.number_style() : ui.text_style();
    Node& node = ui.leaf(Role::status, label_text, Sense::hover);
    node.text = ui.copy(text);
    const float icon = options.icon == Icon::none ? 0.0F : ui.em(1) + ui.em(0.4F);
    const float wish = std::ceil(ui.fonts().run(text, style).width) + icon;
    node.size[0] = px(std::max(wish, ui.em(options.width)));
    node.size[1] = px(ui.row_height());
    node.rigid = options.number;
    const Rect before = ui.rect_before(node.id);
    node.tip = options.tip.empty() && before.w > 0 && before.w < wish ? node.text : ui.copy(options.tip);
    ui.respond(node);
    ui.draw_with<draw_status>(node, StatusLook{style, color_of(ui.theme(), options.tone), options.icon});
}

}  // namespace lapfx::ui
