#include "gallery/parts.h"

#include <array>

#include "ui/core/node.h"
#include "ui/widgets/basic.h"

namespace lapfx::gallery {

namespace {

constexpr float caption_width = 8;  // em

}  // namespace

Part::Part(ui::Ui& ui, std::string_view title) : ui_(ui) {
    ui::Node& node = ui.open(ui::Role::group, title, ui::Axis::y);
    node.gap = ui.em(ui.theme().gap);
    node.rigid = false;
    ui::heading(ui, title);
}

Line::Line(ui::Ui& ui, std::string_view caption, bool disabled) : ui_(ui), disabled_(disabled) {
    ui::Node& node = ui.open(ui::Role::group, caption, ui::Axis::x);
    node.gap = ui.em(ui.theme().gap);
    node.cross = ui::ChildAlign::center;
    node.rigid = false;
    ui::label(ui, caption, {.tone = ui::Tone::dim, .width = ui::px(ui.em(caption_width))});
    if (disabled_) ui.push_disabled(true);
}

Line::~Line() {
    if (disabled_) ui_.pop_disabled();
    ui_.close();
}

std::string_view text_of(ui::Ui& ui, double value, int decimals) {
    std::array<char, 32> buffer;
    return ui.copy(ui::format_number(buffer, value, decimals));
}

}  // namespace lapfx::gallery
