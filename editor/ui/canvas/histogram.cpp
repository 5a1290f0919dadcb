#include "ui/canvas/histogram.h"

#include <algorithm>
#include <numeric>

#include "ui/canvas/drag_handle.h"
#include "ui/core/node.h"
#include "ui/value/number.h"
#include "ui/widgets/basic.h"

namespace lapfx::ui {

namespace {

struct Parts {
    Rect plot, axis, handles;
};
Parts parts_of(Rect rect, float em, float row, bool handles, bool has_switch) {
    Parts parts;
    rect = rect.inset(2 * std::ceil(row / 2), 0);  // the grip of low is left of the axis, that of high right
    parts.axis = rect.cut_bottom(em * 1.3F);
    if (handles) parts.handles = rect.cut_bottom(row);
    rect.cut_top(has_switch ? row + em * 0.1F : em * 0.3F);  // it covers no bars and no grips
    parts.plot = rect;
    return parts;
}

double place_of(const HistogramData& data, double value) {
    return ValueRange{.minimum = data.minimum, .maximum = data.maximum}.place_of(value);
}
struct HistogramLook {
    HistogramData data;
    Levels levels;
    bool has_levels, has_switch, logarithmic, clipped_low, clipped_high;
    int hovered;  ///< bin under the pointer; -1: none
    std::string_view readout;
};

float x_of(const Rect& plot, double place) {
    return plot.x + static_cast<float>(std::clamp(place, 0.0, 1.0)) * plot.w;
}

void draw_bars(Painter& painter, const Rect& plot, const HistogramLook& look) {
    const std::size_t count = look.data.bins.size();
    const std::uint32_t most = full_count(look.data.bins);
    const auto columns = std::min(count, static_cast<std::size_t>(std::max(plot.w, 1.0F)));
    for (std::size_t c = 0; c < columns; ++c) {
        const std::size_t from = c * count / columns, to = std::max(from + 1, (c + 1) * count / columns);
        const std::uint32_t tallest = *std::max_element(&look.data.bins[from], &look.data.bins[to - 1] + 1);
        if (tallest == 0) continue;
        const float height =
            std::max(painter.hairline(), std::round(plot.h * bar_height(tallest, most, look.logarithmic)));
        const float left = std::round(plot.x + plot.w * static_cast<float>(c) / static_cast<float>(columns));
        const float right = std::round(plot.x + plot.w * static_cast<float>(c + 1) / static_cast<float>(columns));
        const bool hovered = look.hovered >= static_cast<int>(from) && look.hovered < static_cast<int>(to);
        painter.fill({left, plot.bottom() - height, right - left, height},
                     canvas_ink(painter.theme(), hovered ? 0.9F : 0.5F));
    }
}

void draw_axis(Painter& painter, const Parts& parts, const HistogramData& data, bool lines) {
    const Theme& t = painter.theme();
    const int most = std::max(2, static_cast<int>(parts.plot.w / painter.em(3.5F)));
    const Ticks marks = ticks(data.minimum, data.maximum, most);
    for (int i = 0; i < marks.count; ++i) {
        const double value = marks.first + i * marks.step;
        const float x = std::round(x_of(parts.plot, place_of(data, value)));
        if (lines) {
            painter.fill({x, parts.plot.y, painter.hairline(), parts.plot.h}, canvas_ink(t, 0.14F));
            continue;
        }
        char buffer[32];
        const float half = painter.em(2.5F);
        TextStyle style = painter.number_style();
        style.size = painter.em(0.85F);
        painter.text({x - half, parts.axis.y, 2 * half, parts.axis.h}, format_number(buffer, value, marks.decimals),
                     style, t.text_dim, Align::center);
    }
}

void draw_levels(Painter& painter, const Parts& parts, const HistogramLook& look) {
    const Theme& t = painter.theme();
    const Rect& plot = parts.plot;
    const float low = std::round(x_of(plot, place_of(look.data, look.levels.low)));
    const float high = std::round(x_of(plot, place_of(look.data, look.levels.high)));
    painter.fill({plot.x, plot.y, low - plot.x, plot.h}, with_alpha(t.canvas, 0.65F));
    painter.fill({high, plot.y, plot.right() - high, plot.h}, with_alpha(t.accent, 0.3F));
    const auto mark = [&](float x, float strength) {
        painter.fill({x, plot.y, painter.hairline(), plot.h}, canvas_ink(t, strength));
        painter.fill({x, plot.bottom(), painter.hairline(), painter.em(0.4F)}, t.text_dim);  // down to the grip
    };
    mark(low, 0.7F), mark(high, 0.7F);
}

void draw_histogram(Painter& painter, const Node& node, const HistogramLook& look) {
    const Theme& t = painter.theme();
    const Parts parts =
        parts_of(node.rect(), painter.em(1), painter.em(t.row_height), look.has_levels, look.has_switch);
    if (parts.plot.empty()) return;
    painter.fill(parts.plot.inset(-painter.hairline()), t.canvas, painter.em(0.2F));
    draw_axis(painter, parts, look.data, true);
    draw_bars(painter, parts.plot, look);
    if (look.has_levels) draw_levels(painter, parts, look);
    const float mark = painter.em(0.25F);
    if (look.clipped_low) painter.fill({parts.plot.x, parts.plot.y, mark, parts.plot.h}, t.series[1]);
    if (look.clipped_high) painter.fill({parts.plot.right() - mark, parts.plot.y, mark, parts.plot.h}, t.series[1]);
    draw_axis(painter, parts, look.data, false);
    if (look.hovered < 0) return;
    Rect line = parts.plot.inset(painter.em(0.6F), painter.em(0.2F));
    painter.text(line.cut_top(painter.em(1.3F)), look.readout, painter.number_style(), canvas_ink(t));
}

/// "17.4 %".
std::string_view percent(Ui& ui, double share) {
    char buffer[32];
    return ui.join({format_number(buffer, share * 100, 1), " %"});
}

std::string_view bin_text(Ui& ui, const HistogramData& data, int bin, double total, std::string_view unit) {
    char value[32], count[32];
    const auto bins = static_cast<double>(data.bins.size());
    // For levels, bin i contains exactly the value i. Otherwise the middle of the bin is shown.
    const bool codes = data.minimum == 0 && bins == data.maximum + 1;
    const double width = (data.maximum - data.minimum) / bins;
    const double at = codes ? bin : data.minimum + (bin + 0.5) * width;
    const int decimals = codes || width <= 0 ? 0 : static_cast<int>(std::clamp(1 - std::log10(width), 0.0, 9.0));
    const auto n = static_cast<double>(data.bins[static_cast<std::size_t>(bin)]);
    return ui.join({format_number(value, at, decimals), unit, "   ", format_number(count, n, 0), "   ",
                    percent(ui, total > 0 ? n / total : 0)});
}

/// The colour of a grip shows what it sets: what becomes black and what becomes white.
Color knob_color(const Theme& t, bool high) {
    return canvas_ink(t, high ? 1.0F : 0.1F);
}

struct Grips {
    Ui& ui;
    const HistogramData& data;
    const HistogramOptions& options;
    Parts parts;
    glm::vec2 origin;

    /// The grip of low is left of its value and that of high right, so that they do not cover each other when they
    /// meet.
    HandleMoves put(bool high, double place) const {
        const glm::vec2 pivot(high ? 0 : 1, 0.5F);
        const HandleMoves moves = put_handle(
            ui, {.label = high ? "High" : "Low",
                 .tip = high ? "Everything from here on counts fully" : "Everything up to here does not count",
                 .at = glm::vec2(x_of(parts.plot, place), parts.handles.center().y) - origin,
                 .pivot = pivot,
                 .cursor = Cursor::resize_x});
        ui.draw_with<draw_knob>(ui.last(),
                                KnobLook{.color = knob_color(ui.theme(), high), .size = {0.6F, 1.1F}, .pivot = pivot});
        return moves;
    }
    double place_at(const HandleMoves& moves) const {
        return static_cast<double>(moves.to.x + origin.x - parts.plot.x) /
               std::max(1.0, static_cast<double>(parts.plot.w));
    }
    void tell(double value, double minimum, double maximum, double step, std::string_view unit) const {
        char buffer[32];
        ui.last().number = ui.number(value, minimum, maximum, step);
        ui.last().text = ui.join({format_number(buffer, value, decimals_of(step)), unit});
    }

    Edit edit_end(bool high, Levels& levels) const {
        double& value = high ? levels.high : levels.low;
        HandleRange range{.minimum = data.minimum,
                          .maximum = data.maximum,
                          .step = options.step,
                          .reset = high ? options.reset.high : options.reset.low};
        if (options.initial) range.initial = high ? options.initial->high : options.initial->low;
        if (high) range.minimum = std::min(levels.low + options.step, data.maximum);
        if (!high) range.maximum = std::max(levels.high - options.step, data.minimum);
        const HandleMoves moves = put(high, place_of(data, value));
        const double dragged = data.minimum + place_at(moves) * (data.maximum - data.minimum);
        const Edit edit = edit_by_handle(ui, moves, range, moves.steps.x + moves.steps.y, dragged, value);
        tell(value, range.minimum, range.maximum, options.step, options.unit);
        return edit;
    }
};

Edit put_log_switch(Ui& ui, bool& on, const Parts& parts, glm::vec2 origin) {
    const Edit edit =
        toggle(ui, "Log", on, {.tip = "Makes rare values visible: heights follow the logarithm of the counts"});
    Node& node = ui.last();
    node.placed = true;
    node.placement =
        ui.arena().make(Placement{.offset = glm::vec2(parts.plot.right(), parts.plot.y) - origin, .pivot = {1, 1}});
    return edit;
}

}  // namespace

std::uint32_t full_count(std::span<const std::uint32_t> bins) {
    if (bins.empty()) return 0;
    const auto inner = bins.size() > 2 ? bins.subspan(1, bins.size() - 2) : bins;
    const std::uint32_t most = *std::max_element(inner.begin(), inner.end());
    return most > 0 ? most : *std::max_element(bins.begin(), bins.end());
}

float bar_height(std::uint32_t count, std::uint32_t most, bool logarithmic) {
    if (count == 0 || most == 0) return 0;
    if (count >= most) return 1;
    const auto n = static_cast<double>(count), full = static_cast<double>(most);
    return static_cast<float>(logarithmic ? std::log1p(n) / std::log1p(full) : n / full);
}

HistogramResult histogram(Ui& ui, std::string_view label, const HistogramData& data, Levels* levels,
                          const HistogramOptions& options) {
    HistogramResult result;
    Node& node = ui.open(Role::plot, label, Axis::y, Sense::hover);
    node.size[0] = options.width, node.size[1] = px(ui.em(options.height));
    node.tip = ui.copy(options.tip);
    ui.follow_size(node);
    const Rect rect = ui.rect_before(node.id);
    const Parts parts = parts_of(rect, ui.em(1), ui.row_height(), levels != nullptr, options.log_counts != nullptr);
    ui.respond(node);

    const double total = std::accumulate(data.bins.begin(), data.bins.end(), 0.0);
    const auto clipped = [&](std::uint32_t count) { return static_cast<double>(count) > options.clip_share * total; };
    auto* copy = static_cast<std::uint32_t*>(
        ui.arena().take(std::max<std::size_t>(data.bins.size_bytes(), 1), alignof(std::uint32_t)));
    std::copy(data.bins.begin(), data.bins.end(), copy);
    HistogramLook look{.data = {{copy, data.bins.size()}, data.minimum, data.maximum},
                       .levels = {},
                       .has_levels = levels != nullptr,
                       .has_switch = options.log_counts != nullptr,
                       .logarithmic = options.log_counts != nullptr && *options.log_counts,
                       .clipped_low = !data.bins.empty() && clipped(data.bins.front()),
                       .clipped_high = !data.bins.empty() && clipped(data.bins.back()),
                       .hovered = -1,
                       .readout = {}};
    const glm::vec2 pointer = ui.pointer();
    if (has(node.is, Is::hovered) && parts.plot.contains(pointer) && !data.bins.empty()) {
        const float place = (pointer.x - parts.plot.x) / parts.plot.w;
        const auto last = static_cast<int>(data.bins.size()) - 1;
        look.hovered = std::clamp(static_cast<int>(place * static_cast<float>(data.bins.size())), 0, last);
        look.readout = bin_text(ui, data, look.hovered, total, options.unit);
    }
    node.text = look.readout;
    if (look.hovered < 0 && (look.clipped_low || look.clipped_high))
        node.text = ui.join({"clipped: ", percent(ui, data.bins.front() / total), " at the low end, ",
                             percent(ui, data.bins.back() / total), " at the high end"});
    const glm::vec2 origin = rect.at();
    if (levels != nullptr) {
        const Grips grips{ui, data, options, parts, origin};
        result.low = grips.edit_end(false, *levels);
        result.high = grips.edit_end(true, *levels);
        look.levels = *levels;
    }
    if (options.log_counts != nullptr) {
        result.log = put_log_switch(ui, *options.log_counts, parts, origin);
        look.logarithmic = *options.log_counts;
    }
    ui.draw_with<draw_histogram>(ui.parent(), look);
    ui.close();
    return result;
}

}  // namespace lapfx::ui
