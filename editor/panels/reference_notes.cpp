#include "panels/reference_notes.h"

#include <cmath>
#include <cstdio>

#include "app/reference/plate.h"
#include "ui/canvas/axis.h"
#include "ui/core/node.h"
#include "ui/shell/progress.h"
#include "ui/widgets/basic.h"

namespace lapfx::panels {

namespace {

using app::ReferenceLook;

void plate_on_its_way(ui::Ui& ui, const ReferenceLook& look, document::Document& document) {
    const std::optional<double> share = look.plate_progress();
    if (share && ui::progress(ui, "Making the plate", *share, {.cancellable = true})) app::show_plate(document, false);
}

/// "16:9" of 1.7778.
std::string_view aspect_name(ui::Ui& ui, double aspect) {
    for (const glm::ivec2 sides : {glm::ivec2(5, 4), {4, 3}, {16, 10}, {16, 9}}) {
        if (std::abs(aspect - static_cast<double>(sides.x) / sides.y) > 1e-3) continue;
        ui::ShortText text;
        text.add(sides.x, 0).add(":").add(sides.y, 0);
        return ui.copy(text.view());
    }
    char text[32];
    std::snprintf(text, sizeof text, "%.4g:1", aspect);
    return ui.copy(text);
}

void proposed_aspect(ui::Ui& ui, ReferenceLook& look) {
    if (!look.proposed_aspect()) return;
    const std::string_view name = aspect_name(ui, *look.proposed_aspect());
    const ui::Row row(ui, {.width = ui::grow(), .cross = ui::ChildAlign::center});
    ui::label(ui, ui.join({"The endoscope's view is squeezed: shown at ", name, " it is round."}),
              {.tone = ui::Tone::warning, .wrap = true, .width = ui::grow()});
    if (ui::button(ui, ui.join({"Use ", name}), {.tip = "Shows the reference so; the scene keeps it"}))
        return look.take_aspect();
    if (ui::button(ui, "Leave as stored", {.tip = "Leaves the reference as it is stored", .quiet = true}))
        look.leave_aspect();
}

/// What a proposal found, or why there is none.
void look_notes(ui::Ui& ui, ReferenceLook& look, ui::CommandTable& commands) {
    if (look.notes().empty()) return;
    const ui::Row row(ui, {.width = ui::grow(), .cross = ui::ChildAlign::start});
    {
        const ui::Column lines(ui, {.width = ui::grow(), .gap = 0.1F});
        for (const std::string& note : look.notes())
            ui::label(ui, note, {.tone = ui::Tone::dim, .wrap = true, .width = ui::grow()});
    }
    if (look.proposed())
        for (const char* id : {"reference.take_look", "reference.leave_look"}) ui::command_button(ui, commands, id);
    else if (ui::icon_button(ui, ui::Icon::cross, "Dismiss", {.quiet = true}))
        look.forget_notes();
}

}  // namespace

void reference_notes(ui::Ui& ui, ReferenceLook& look, const Edited& edited, ui::CommandTable& commands) {
    plate_on_its_way(ui, look, edited.document);
    proposed_aspect(ui, look);
    look_notes(ui, look, commands);
}

}  // namespace lapfx::panels
