#include "ui/widgets/field.h"

#include <charconv>

#include "ui/core/node.h"

namespace lapfx::ui {

Rect field_part(const Rect& row, bool caption) {
    Rect part = row;
    if (caption) part.cut_left(whole(row.w * caption_share));
    return part;
}

void draw_caption(Painter& painter, const Node& node, bool caption) {
    if (!caption) return;
    Rect rect = node.rect();
    rect = rect.cut_left(whole(rect.w * caption_share));
    rect.cut_left(painter.em(caption_inset));
    rect.cut_right(painter.em(0.4F));
    const Theme& t = painter.theme();
    painter.text(rect, node.shown, painter.text_style(), has(node.is, Is::disabled) ? t.text_disabled : t.text);
}

void draw_field(Painter& painter, const Rect& rect, Is is) {
    const Theme& t = painter.theme();
    const bool disabled = has(is, Is::disabled), hovered = has(is, Is::hovered) && !disabled;
    painter.fill(rect, hovered ? t.field_hover : t.field, painter.em(t.radius));
    const Color edge = has(is, Is::invalid) ? t.error : has(is, Is::focused) ? t.focus : t.border;
    painter.frame(rect, edge, painter.hairline(), painter.em(t.radius));
}

Color selection_color(const Theme& theme) {
    return mix(theme.field, theme.focus, 0.35F);
}

void draw_popup(Painter& painter, const Node& node, const bool&) {
    const Theme& t = painter.theme();
    painter.shadow(node.rect(), t.shadow, painter.em(0.6F), painter.em(t.radius));
    painter.fill(node.rect(), t.raised, painter.em(t.radius));
    painter.frame(node.rect(), t.border, painter.hairline(), painter.em(t.radius));
}

std::string_view overlay_name(Ui& ui, std::string_view kind, Id owner) {
    char digits[16];
    const char* end = std::to_chars(digits, digits + sizeof digits, owner, 16).ptr;
    return ui.join({kind, {digits, static_cast<std::size_t>(end - digits)}});
}

Rect scroll_thumb(const Rect& track, const ScrollState& scroll, float least) {
    const float all = scroll.content.y, view = scroll.view.y;
    if (all <= view + 0.5F || view <= 0) return {};
    const float height = std::min(track.h, std::max(least, whole(track.h * view / all)));
    const float y = track.y + (track.h - height) * std::clamp(scroll.offset.y / (all - view), 0.0F, 1.0F);
    return {track.x, whole(y), track.w, height};
}

float scrolled_by_thumb(const Rect& track, const ScrollState& scroll, float px, float least) {
    const Rect thumb = scroll_thumb(track, scroll, least);
    const float way = track.h - thumb.h, most = std::max(0.0F, scroll.content.y - scroll.view.y);
    if (thumb.empty() || way <= 0) return scroll.offset.y;
    return std::clamp(scroll.offset.y + px * most / way, 0.0F, most);
}

}  // namespace lapfx::ui
