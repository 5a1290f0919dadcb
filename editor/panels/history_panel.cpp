// All steps since the document was opened, in words. A click, or Enter, goes back or forth to the state after a step.
#include "app/base/layouts.h"
#include "panels/panels.h"
#include "ui/widgets/table.h"

namespace lapfx::panels {

namespace {

struct HistoryState {
    ui::TableState table;
    std::size_t done = 0;
    std::uint64_t newest = 0;
    bool behind = true;  ///< it has to scroll to the current step
};

ui::TableCell cell_of(const document::Document& document, std::size_t row, std::size_t column) {
    const bool current = row == document.done();
    const ui::Tone tone = row > document.done() ? ui::Tone::dim : ui::Tone::normal;
    if (row == 0)
        return {.text = column == 0 ? "As opened" : "",
                .icon = column == 0 && current ? ui::Icon::chevron_right : ui::Icon::none,
                .tone = tone};
    const document::Step& step = document.steps()[row - 1];
    if (column == 0)
        return {.text = step.name, .icon = current ? ui::Icon::chevron_right : ui::Icon::none, .tone = tone};
    return {.text = step.change, .tone = tone};
}

void head(ui::Ui& ui, const document::Document& document, ui::CommandTable& commands) {
    const ui::Row row(ui, {.width = ui::grow(), .cross = ui::ChildAlign::center});
    const std::size_t count = document.steps().size();
    std::string text = std::to_string(count) + (count == 1 ? " step" : " steps");
    if (document.done() < count) text += ", " + std::to_string(count - document.done()) + " undone";
    ui::label(ui, text, {.tone = ui::Tone::dim, .number = true});
    ui::spacer(ui);
    ui::command_button(ui, commands, "edit.undo", true);
    ui::command_button(ui, commands, "edit.redo", true);
}

}  // namespace

void history_panel(ui::Ui& ui, document::Document& document, ui::CommandTable& commands) {
    HistoryState& state = ui.memory<HistoryState>(ui::hash_bytes(0, "history"));
    const ui::Column panel(ui, {.width = ui::grow(), .height = ui::grow(), .gap = 0.4F});
    head(ui, document, commands);
    const auto key_of = [&](std::size_t row) { return row == 0 ? 0 : document.steps()[row - 1].id; };
    if (const std::uint64_t newest = key_of(document.steps().size());
        state.done != document.done() || state.newest != newest) {
        state.done = document.done();
        state.newest = newest;
        state.table.selection.only(key_of(document.done()));
        state.behind = true;
    }
    constexpr std::array columns = {
        ui::TableColumn{"Step", 11, ui::Align::start, false, "What was done, oldest first."},
        ui::TableColumn{"Change", 18, ui::Align::start, false, "The old value and the new one."}};
    const ui::RowList::KeyOf key(key_of);
    const auto events = ui::table(ui, "Steps", state.table, columns, document.steps().size() + 1,
                                  [&](std::size_t row, std::size_t column) { return cell_of(document, row, column); },
                                  {.key_of = &key, .show = state.behind ? document.done() : ui::no_row});
    state.behind = events.unseen;
    std::size_t target = events.opened;
    // The arrow keys only select; a press goes to that state.
    if (events.selected && ui.held() != 0 && events.hovered != ui::no_row) target = events.hovered;
    if (target == ui::no_row || target == document.done()) return;
    document.go_to(target);
    ui.build_again();
}

}  // namespace lapfx::panels
