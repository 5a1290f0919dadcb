// Dialogs. Everything below a dialog cannot be used until it is answered.
//
//     if (ui::button(u, "New preset")) ui::open_dialog(u, "new preset");
//     if (ui::Dialog dialog(u, "new preset", "New preset"); dialog) {
//         ui::text_field(u, "Name", name);
//         if (dialog.buttons({{.label = "Cancel", .cancel = true}, {.label = "Create", .standard = true}}) == 1)
//             create(name);
//     }
//
// Content that is taller than the window scrolls between the title and the buttons. Buttons that do not fit into a row
// continue in the next one. Tab stays inside. Enter in a text field, or where nothing else takes it, presses the
// standard button; Esc closes the dialog.
#pragma once

#include <optional>

#include "ui/widgets/basic.h"

namespace lapfx::ui {

struct DialogButton {
    std::string_view label;
    bool standard = false;  ///< Enter presses it; never one that destroys. None: the keyboard begins at `cancel`
    bool cancel = false;    ///< what Esc amounts to
    bool enabled = true;
    std::string_view tip = {};
};

struct DialogOptions {
    float width = 28;  ///< em; never wider than the window
    float height = 0;  ///< em; 0: as tall as its content
    Icon icon = Icon::none;
    Tone tone = Tone::normal;  ///< of the icon
};

void open_dialog(Ui& ui, std::string_view name);

class Dialog {
  public:
    Dialog(Ui& ui, std::string_view name, std::string_view title, const DialogOptions& options = {});
    ~Dialog();
    Dialog(const Dialog&) = delete;
    Dialog& operator=(const Dialog&) = delete;
    explicit operator bool() const { return open_; }

    /// The row at the bottom, after the content. The index of the one that was pressed: the dialog is closed then,
    /// unless `stays`.
    std::optional<std::size_t> buttons(std::span<const DialogButton> all, bool stays = false);
    std::optional<std::size_t> buttons(std::initializer_list<DialogButton> all, bool stays = false) {
        return buttons(std::span(all.begin(), all.size()), stays);
    }
    void close();
    /// Its events are the keys (Sense::chords) that no node in it took.
    Id id() const { return id_; }
    /// Not open, and closed by Esc since the last build.
    bool cancelled() const { return cancelled_; }

  private:
    void begin_body(bool grows);
    void end_body();
    std::size_t buttons_in_row(std::span<const DialogButton> all) const;

    Ui& ui_;
    std::string_view name_;
    bool open_ = false, cancelled_ = false;
    Id id_ = 0;
    ScrollState* body_ = nullptr;  ///< of what is between title and buttons, while it is built
};

/// A question, open from open_dialog(ui, name) on. Returns the index of the answer, once; Esc is the one with `cancel`.
std::optional<std::size_t> ask(Ui& ui, std::string_view name, std::string_view title, std::string_view question,
                               std::span<const DialogButton> buttons, Tone tone = Tone::normal);
inline std::optional<std::size_t> ask(Ui& ui, std::string_view name, std::string_view title, std::string_view question,
                                      std::initializer_list<DialogButton> buttons, Tone tone = Tone::normal) {
    return ask(ui, name, title, question, std::span(buttons.begin(), buttons.size()), tone);
}

}  // namespace lapfx::ui
