// The whole editor without a window, with a clock that goes by frames: for pictures of it, dumps and benches.
//
//     HeadlessEditor headless({1440, 900}, 1.0F, "auto");
//     headless.editor().document.open(...);
//     headless.settle();
//     write_png("editor.png", headless.picture());
#pragma once

#include <memory>

#include "app/editor.h"
#include "app/preview/target.h"
#include "ui/gl/renderer.h"

namespace lapfx::commands {

class HeadlessEditor {
  public:
    /// `exact`: as EditorOptions::exact. Throws Error (no_gl) without OpenGL, std::runtime_error without fonts.
    HeadlessEditor(glm::ivec2 size, float scale, const std::string& backend, bool exact = true,
                   std::shared_ptr<app::EarlyLoad> early = nullptr);
    ~HeadlessEditor();
    HeadlessEditor(const HeadlessEditor&) = delete;
    HeadlessEditor& operator=(const HeadlessEditor&) = delete;

    app::Editor& editor() { return *editor_; }
    ui::Ui& ui() { return *ui_; }
    const Context& context() const { return context_; }

    /// One frame, `seconds` after the last one: the panels are built and the preview is drawn.
    void frame(double seconds = 1.0 / 60, const app::FrameOptions& options = {});
    /// Runs frames until none is requested soon; an endless request is stopped after a while.
    void settle();
    /// Sends the UI of the last frame to the GPU.
    void draw_ui();
    Image picture();

  private:
    glm::ivec2 size_;
    float scale_;
    Context context_;
    ui::ImageStore images_;
    ui::Fonts fonts_;
    std::unique_ptr<app::Editor> editor_;
    std::unique_ptr<ui::Ui> ui_;
    ui::Renderer renderer_;
    app::Target target_;
    const ui::FrameOutput* output_ = nullptr;
    bool drew_ = false;
    double time_ = 0;
};

}  // namespace lapfx::commands
