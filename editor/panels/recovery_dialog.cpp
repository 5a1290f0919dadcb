// After a crash: what the editor that ended had not saved.
#include "app/files/autosave.h"
#include "app/files/files.h"
#include "panels/panels.h"
#include "ui/shell/dialog.h"
#include "ui/shell/file_system.h"
#include "ui/widgets/table.h"

namespace lapfx::panels {

namespace {

constexpr std::string_view name = "recovery";

struct RecoveryState {
    bool asked = false;
    ui::TableState table;
    std::string time;
};

ui::TableCell cell_of(RecoveryState& state, const app::Autosave::Offer& offer, std::size_t column) {
    switch (column) {
        case 0:
            ui::date_text(offer.kept.time, state.time);
            return {.text = state.time, .number = true};
        case 1:
            return {.text = offer.name};
        default:
            return {.text = offer.unsaved, .tone = ui::Tone::dim};
    }
}

/// Gives the row that is selected; the newest if none is.
std::size_t offers_table(ui::Ui& ui, app::Autosave& autosave, RecoveryState& state, bool& opened) {
    constexpr std::array columns = {ui::TableColumn{"Kept", 12, ui::Align::start, false},
                                    ui::TableColumn{"Scene, preset", 19, ui::Align::start, false},
                                    ui::TableColumn{"Not saved", 10, ui::Align::start, false}};
    const auto& offers = autosave.offers();
    if (state.table.selection.current >= offers.size()) state.table.selection.only(0);
    const auto events =
        ui::table(ui, "Unsaved work", state.table, columns, offers.size(),
                  [&](std::size_t row, std::size_t column) { return cell_of(state, offers[row], column); },
                  {.height = ui::px(ui.em(9))});
    opened = events.opened != ui::no_row;
    return static_cast<std::size_t>(state.table.selection.current);
}

}  // namespace

void recovery_dialog(ui::Ui& ui, app::Autosave& autosave, app::Files& files) {
    RecoveryState& state = ui.memory<RecoveryState>(ui::hash_bytes(0, name));
    if (autosave.offers().empty()) {
        state.asked = false;
        return;
    }
    if (!state.asked) {
        state.asked = true;
        state.table.selection.only(0);
        ui::open_dialog(ui, name);
    }
    ui::Dialog dialog(ui, name, "Unsaved work was found",
                      {.width = 44, .icon = ui::Icon::warning, .tone = ui::Tone::warning});
    if (!dialog) {
        autosave.keep_for_later();
        return;
    }
    ui::label(
        ui,
        "An editor ended before this was saved. What you recover is kept until you save it; the rest is offered again.",
        {.wrap = true, .width = ui::grow()});
    bool opened = false;
    const std::size_t row = offers_table(ui, autosave, state, opened);
    for (const std::string& note : autosave.offers()[row].notes)
        ui::label(ui, note, {.tone = ui::Tone::warning, .wrap = true, .width = ui::grow()});
    const auto chosen = dialog.buttons(
        {{.label = "Discard", .tip = "Deletes the selected one from the disk, for good."},
         {.label = "Keep for later", .cancel = true, .tip = "Nothing changes; you are asked again at the next start."},
         {.label = "Recover", .standard = true, .tip = "Opens the selected one here."}},
        true);
    if (opened || chosen == 2U) {
        dialog.close();
        files.recover(row);
    } else if (chosen == 1U) {
        dialog.close();
        autosave.keep_for_later();
    } else if (chosen == 0U) {
        autosave.discard(row);
        if (autosave.offers().empty()) dialog.close();
    }
}

}  // namespace lapfx::panels
