#include "ui/canvas/plot_legend.h"

namespace lapfx::ui {

namespace {

constexpr int most_series = 64;  // that can be hidden

struct LegendLook {
    Color color;
    bool shown;
};

void draw_legend(Painter& p, const Node& node, const LegendLook& look) {
    const Theme& t = p.theme();
    Rect rect = node.rect();
    if (has(node.is, Is::hovered)) p.fill(rect, t.control_hover, p.em(t.radius));
    rect = rect.inset(p.em(0.4F), 0);
    const Rect mark = rect.cut_left(p.em(0.9F));
    const float size = p.em(0.6F);
    const Rect swatch{mark.x, whole(mark.center().y - size / 2), size, size};
    look.shown ? p.fill(swatch, look.color, p.em(0.15F)) : p.frame(swatch, t.text_disabled, 1, p.em(0.15F));
    p.text(rect, node.shown, p.text_style(), look.shown ? t.text : t.text_disabled);
}

}  // namespace

bool hidden(const PlotState& state, std::size_t i) {
    return i < most_series && (state.hidden >> i & 1) != 0;
}

Color color_of(const Theme& theme, const PlotSeries& series, std::size_t i) {
    if (series.reference) return on_well(theme, 0.55F);
    return theme.series[(series.color >= 0 ? static_cast<std::size_t>(series.color) : i) % 8];
}

bool legend(Ui& ui, std::span<const PlotSeries> series, PlotState& state) {
    Node& row = ui.open(Role::none, {}, Axis::x);
    row.placed = true;
    row.placement = ui.arena().make(Placement{.fraction = {1, 0}, .offset = {-ui.em(0.6F), 0}, .pivot = {1, 0}});
    row.size[0] = fit(), row.size[1] = px(ui.row_height());
    bool changed = false;
    for (std::size_t i = 0; i < series.size(); ++i) {
        if (series[i].name.empty()) continue;
        Node& node =
            ui.leaf(Role::toggle, series[i].name, Sense::hover | Sense::press | Sense::focus | Sense::activate);
        node.size[0] = px(std::ceil(ui.text_width(node.shown)) + ui.em(1.8F));
        node.size[1] = px(ui.row_height());
        node.tip = hidden(state, i) ? "Show" : "Hide";
        if (ui.respond(node).clicked && i < most_series) state.hidden ^= 1ULL << i, changed = true;
        node.is |= when(!hidden(state, i), Is::checked);
        ui.draw_with<draw_legend>(node, LegendLook{color_of(ui.theme(), series[i], i), !hidden(state, i)});
    }
    ui.close();
    return changed;
}

}  // namespace lapfx::ui
