#include "ui/canvas/plot_legend.h"

#include "ui/core/node.h"

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

float wish_of(Ui& ui, const PlotSeries& series) {
    if (series.name.empty()) return 0;
    return std::ceil(ui.text_width(split_label(series.name).shown)) + ui.em(1.8F);
}

float wish_of(Ui& ui, std::span<const PlotSeries> series) {
    float all = 0;
    for (const PlotSeries& one : series) all += wish_of(ui, one);
    return all;
}

}  // namespace

float legend_width(Ui& ui, std::span<const PlotSeries> series, float room) {
    return std::min(wish_of(ui, series), std::max(0.0F, room - ui.em(0.9F)));
}

bool hidden(const PlotState& state, std::size_t i) {
    return i < most_series && (state.hidden >> i & 1) != 0;
}

Color color_of(const Theme& theme, const PlotSeries& series, std::size_t i) {
    if (series.reference) return on_well(theme, 0.55F);
    return theme.series[(series.color >= 0 ? static_cast<std::size_t>(series.color) : i) % 8];
}

bool legend(Ui& ui, std::span<const PlotSeries> series, PlotState& state, float room) {
    const float share = legend_width(ui, series, room) / std::max(1.0F, wish_of(ui, series));
    Node& row = ui.open(Role::none, {}, Axis::x);
    row.placed = true;
    row.placement = ui.arena().make(Placement{.fraction = {1, 0}, .offset = {-ui.em(0.6F), 0}, .pivot = {1, 0}});
    row.size[0] = fit(), row.size[1] = px(ui.row_height());
    bool changed = false;
    for (std::size_t i = 0; i < series.size(); ++i) {
        if (series[i].name.empty()) continue;
        Node& node =
            ui.leaf(Role::toggle, series[i].name, Sense::hover | Sense::press | Sense::focus | Sense::activate);
        node.size[0] = px(std::floor(share * wish_of(ui, series[i])));
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
