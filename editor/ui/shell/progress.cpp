#include "ui/shell/progress.h"

#include <cmath>
#include <cstdio>

#include "ui/core/node.h"
#include "ui/widgets/basic.h"

namespace lapfx::ui {

namespace {

constexpr double sweep = 1.6;             // s there and back
constexpr double sweep_frame = 1.0 / 30;  // s between its pictures
constexpr float sweep_part = 0.25F;       // of the bar

struct ProgressLook {
    float from, to;  ///< of the bar's length
    TextStyle style;
};

void draw_progress(Painter& painter, const Node& node, const ProgressLook& look) {
    const Theme& t = painter.theme();
    const Rect rect = node.rect();
    const float radius = painter.em(t.radius);
    painter.fill(rect, t.field, radius);
    const float x = std::round(rect.x + rect.w * look.from);
    const Rect part{x, rect.y, std::round(rect.x + rect.w * look.to) - x, rect.h};
    const bool disabled = has(node.is, Is::disabled);
    if (part.w > 0) painter.fill(part, disabled ? t.control : t.accent, radius);
    const Rect inside = rect.inset(painter.em(0.5F), 0);
    painter.text(inside, node.text, look.style, disabled ? t.text_disabled : t.text, Align::center);
    if (part.w <= 0) return;
    painter.push_clip(part);  // the same text where it is on the filled part
    painter.text(inside, node.text, look.style, disabled ? t.text_disabled : t.text_on_accent, Align::center);
    painter.pop_clip();
}

/// Moves from 0 to 1 and back, slower at the ends.
float place_of_sweep(double time) {
    return static_cast<float>(0.5 - 0.5 * std::cos(2 * 3.14159265358979 * time / sweep));
}

std::string_view text_of(Ui& ui, bool known, double fraction, const ProgressOptions& options) {
    char percent[16] = "";
    // never 100 % before it is done
    if (known) std::snprintf(percent, sizeof percent, "%d %%", static_cast<int>(fraction * 100));
    const std::string_view left = duration_text(ui, options.seconds_left), shown(percent);
    return ui.join({shown, shown.empty() || options.text.empty() ? "" : ", ", options.text,
                    left.empty() || (shown.empty() && options.text.empty()) ? "" : ", ",
                    left.empty() || !options.at_most ? "" : "up to ", left, left.empty() ? "" : " left"});
}

}  // namespace

std::string_view duration_text(Ui& ui, double seconds) {
    if (!(seconds >= 0) || seconds > 1e8) return {};
    const int all = static_cast<int>(std::ceil(std::max(seconds, 1e-9)));
    char text[32];
    if (all < 60) {
        std::snprintf(text, sizeof text, "%d s", all);
    } else if (all < 3600) {
        std::snprintf(text, sizeof text, "%d min %02d s", all / 60, all % 60);
    } else {
        std::snprintf(text, sizeof text, "%d h %02d min", all / 3600, all / 60 % 60);
    }
    return ui.copy(text);
}

bool progress(Ui& ui, std::string_view label_text, double fraction, const ProgressOptions& options) {
    const Row row(ui, {.width = options.width, .cross = ChildAlign::center});
    const bool known = fraction >= 0 && std::isfinite(fraction);
    fraction = known ? std::min(fraction, 1.0) : 0.0;
    const std::string_view shown = split_label(label_text).shown;
    if (!shown.empty()) {
        Node& caption = ui.leaf(Role::none, {});
        caption.text = ui.copy(shown);
        caption.size[0] = px(std::ceil(ui.text_width(shown)) + ui.em(0.3F));
        caption.size[1] = px(ui.row_height());
        caption.rigid = false;
        ui.draw_with<[](Painter& p, const Node& n, const Color& color) {
            p.text(n.rect(), n.text, p.text_style(), color);
        }>(caption, ui.disabled() ? ui.theme().text_disabled : ui.theme().text);
    }
    Node& node = ui.leaf(Role::progress, label_text, Sense::hover);
    node.size[0] = grow();
    node.minimum[0] = ui.em(4);
    node.size[1] = px(ui.em(1.5F));
    node.rigid = false;
    node.text = text_of(ui, known, fraction, options);
    node.number = known ? ui.number(fraction, 0, 1) : nullptr;
    node.is |= when(!known, Is::busy);
    ui.respond(node);
    ProgressLook look{0, static_cast<float>(fraction), ui.number_style()};
    if (!known) {
        const bool runs = !ui.options().reduced_motion && !ui.disabled();
        look.from = (1 - sweep_part) * (runs ? place_of_sweep(ui.time()) : 0.5F);
        look.to = look.from + sweep_part;
        if (runs) ui.wake_at(ui.time() + sweep_frame, "progress");
    }
    ui.draw_with<draw_progress>(node, look);
    if (!options.cancellable) return false;
    return icon_button(ui, Icon::cross, ui.join({"Cancel ", split_label(label_text).name}), {.quiet = true});
}

}  // namespace lapfx::ui
