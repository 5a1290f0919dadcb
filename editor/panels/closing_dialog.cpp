// What files ask (app/files/files.h): unsaved work, a file that another editor has, a disk that is full.
#include "app/files/files.h"
#include "panels/panels.h"
#include "ui/shell/dialog.h"
#include "ui/widgets/scroll.h"

namespace lapfx::panels {

namespace {

constexpr std::string_view name = "file question";
constexpr float width = 34, most_height = 12;  // em

/// The question that was last shown.
struct LastQuestion {
    std::uint64_t serial = 0;
};

void content(ui::Ui& ui, const app::Files::Question& question) {
    if (!question.text.empty()) ui::label(ui, question.text, {.wrap = true, .width = ui::grow()});
    if (question.lines.empty()) return;
    const ui::Column lines(ui, {.width = ui::grow(), .gap = 0.15F, .padding = 0.4F});
    for (const std::string& line : question.lines)
        ui::label(ui, line, {.tone = ui::Tone::dim, .wrap = true, .width = ui::grow()});
}

}  // namespace

void closing_dialog(ui::Ui& ui, app::Files& files) {
    LastQuestion& shown = ui.memory<LastQuestion>(ui::hash_bytes(0, name));
    const app::Files::Question* question = files.question();
    if (question != nullptr && question->serial != shown.serial) {
        shown.serial = question->serial;
        ui::open_dialog(ui, name);
    }
    if (question == nullptr) return;
    std::size_t cancel = question->answers.size();
    std::vector<ui::DialogButton> buttons;
    for (std::size_t i = 0; i < question->answers.size(); ++i) {
        const app::Files::Answer& answer = question->answers[i];
        if (answer.cancel) cancel = i;
        buttons.push_back(
            {.label = answer.label, .standard = answer.standard, .cancel = answer.cancel, .tip = answer.tip});
    }
    std::optional<std::size_t> chosen;
    {
        ui::Dialog dialog(ui, name, question->title,
                          {.width = width, .icon = ui::Icon::warning, .tone = ui::Tone::warning});
        if (dialog) {
            content(ui, *question);
            chosen = dialog.buttons(buttons);
        } else if (dialog.cancelled() || !ui.overlay_open(name)) {
            chosen = cancel;
        }
    }
    if (chosen) {
        files.answer(*chosen);
        ui.build_again();
    }
}

}  // namespace lapfx::panels
