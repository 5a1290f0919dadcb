// The UI that shows the editor, from its first frame on: for parts that have something to show between frames.
#pragma once

#include "ui/core/ui.h"

namespace lapfx::app {

class Screen {
  public:
    void show_on(ui::Ui& ui) { ui_ = &ui; }
    /// Null before the first frame.
    ui::Ui* ui() const { return ui_; }
    /// Another frame is wanted. From any thread, once there was a frame; before, nothing happens.
    void wake(const char* reason) const {
        if (ui_ != nullptr) ui_->wake(reason);
    }
    /// The next frame is due then. In a frame, also after the panels were built.
    void wake_at(double time, const char* reason) const {
        if (ui_ != nullptr) ui_->wake_at(time, reason);
    }
    /// Null where there is none.
    ui::Clipboard* clipboard() const { return ui_ != nullptr ? ui_->clipboard() : nullptr; }
    /// A pointer's button, or a key that stands for it, is held on a widget.
    bool held() const { return ui_ != nullptr && ui_->held() != 0; }

  private:
    ui::Ui* ui_ = nullptr;
};

}  // namespace lapfx::app
