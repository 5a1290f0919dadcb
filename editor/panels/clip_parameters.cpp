#include "panels/clip_parameters.h"

#include <cmath>
#include <unordered_map>

#include "ui/widgets/color_field.h"
#include "ui/widgets/combo.h"
#include "ui/widgets/param.h"

namespace lapfx::panels {

namespace {

ui::Edit number_row(ui::Ui& ui, const Parameter& row, double& value, double standard) {
    ui::ParamOptions options{.minimum = row.minimum,
                             .maximum = row.maximum,
                             .hard_minimum = row.minimum,
                             .hard_maximum = row.maximum,
                             .step = row.step,
                             .unit = row.unit,
                             .standard = standard,
                             .tip = tip_of(row)};
    if (row.scale == Scale::logarithmic) options.scale = ui::ValueScale::logarithmic, options.smallest = row.minimum;
    return ui::param(ui, row.name, value, options);
}

ui::Edit color_row(ui::Ui& ui, const Parameter& row, glm::dvec3& value) {
    const auto code = [](double share) {
        return static_cast<std::uint8_t>(std::lround(255 * glm::clamp(share, 0.0, 1.0)));
    };
    ui::Color color{code(value.r), code(value.g), code(value.b), 255};
    const ui::Edit edit = ui::color_field(ui, row.name, color, {.caption = true, .tip = tip_of(row)});
    if (edit.changed) value = glm::dvec3(color.r, color.g, color.b) / 255.0;
    return edit;
}

}  // namespace

const Table& clip_table() {
    static const Table& table = *preset_table().find("smoke")->find("clips");
    return table;
}

const Table& keying_table() {
    static const Table& table = *preset_table().find("smoke")->find("keying");
    return table;
}

std::string_view tip_of(const Parameter& row) {
    static std::unordered_map<const Parameter*, std::string> tips;
    std::string& tip = tips[&row];
    if (!tip.empty()) return tip;
    tip = row.help;
    if (row.kind == Kind::number) tip += " Allowed: " + row.expected() + ".";
    return tip;
}

void clip_row(ui::Ui& ui, app::Editor& editor, const Parameter& row, const void* owner, const void* standard,
              const ui::FunctionRef<void*(document::Content&)>& in) {
    Value value = row.get(owner);
    ui::Edit edit;
    switch (row.kind) {
        case Kind::number:
            edit = number_row(ui, row, std::get<double>(value), std::get<double>(row.get(standard)));
            break;
        case Kind::choice:
            edit = ui::combo(ui, row.name, std::get<int>(value), row.choices, {.tip = tip_of(row), .caption = true});
            break;
        case Kind::color:
            edit = color_row(ui, row, std::get<glm::dvec3>(value));
            break;
        default:
            return;
    }
    editor.document.take(edit, row.name, [&](document::Content& c) { row.set(in(c), value); });
}

ui::FileRequest clip_request(std::string title, bool many) {
    return {.task = many ? ui::FileTask::open_many : ui::FileTask::open,
            .title = std::move(title),
            .filters = {{"Smoke videos", {".mp4", ".mov", ".webm", ".mkv", ".avi", ".m4v", ".mpg", ".ogv", ".gif"}},
                        {"Images", {".png", ".jpg", ".jpeg", ".webp", ".bmp", ".tif"}}}};
}

}  // namespace lapfx::panels
