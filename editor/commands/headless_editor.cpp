#include "commands/headless_editor.h"

#include "app/base/settings.h"
#include "commands/session.h"
#include "lapfx/authoring/command_line.h"
#include "panels/panels.h"

namespace lapfx::commands {

HeadlessEditor::HeadlessEditor(glm::ivec2 size, float scale, const std::string& backend, bool exact,
                               std::shared_ptr<app::EarlyLoad> early)
    : size_(size),
      scale_(scale > 0 ? scale : 1.0F),
      context_(Context::create(parse_backend(backend))),
      fonts_({.hinting = ui::Hinting::slight}),  // whatever the host prefers
      editor_(std::make_unique<app::Editor>(
          images_,
          app::EditorOptions{.data_folder = data_folder(),
                             .clip_folders = clip_folders(),
                             .folders = {.config = {}, .state = {}, .cache = document::Folders::of_user().cache},
                             .exact = exact,
                             .renderer = context_.renderer(),
                             .software = context_.software(),
                             .files = nullptr},
          std::move(early))),
      ui_(std::make_unique<ui::Ui>(
          fonts_, ui::UiOptions{.images = &images_, .shortcuts = &editor_->commands, .reduced_motion = true})),
      target_(size) {
    panels::set_up(*editor_);
    editor_->settings().reduced_motion = true;
    editor_->settings().hint_seen = true;
}

/// The editor's threads wake the UI, so they end before it.
HeadlessEditor::~HeadlessEditor() {
    editor_.reset();
}

void HeadlessEditor::frame(double seconds, const app::FrameOptions& options) {
    time_ += seconds;
    const auto build = [this] {
        output_ = &ui_->frame({.size = size_, .scale = scale_, .time = time_},
                              [this](ui::Ui& u) { panels::workspace(u, *editor_); });
    };
    drew_ = editor_->frame(time_, build, options);
}

void HeadlessEditor::settle() {
    constexpr int most_frames = 30;
    for (int i = 0; i < most_frames; ++i) {
        frame();
        if (!drew_ && output_->wake_at > time_ + 0.1 && !editor_->jobs.busy()) return;
    }
}

void HeadlessEditor::draw_ui() {
    renderer_.draw(*output_->list, fonts_, &images_, target_.framebuffer());
}

Image HeadlessEditor::picture() {
    draw_ui();
    return target_.read();
}

}  // namespace lapfx::commands
