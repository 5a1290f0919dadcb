// lapfx_gallery [OPTION ...]: what `lapfx gallery` starts; its options are in editor/commands/gallery.cpp.
#include "commands/gallery.h"

#include <algorithm>
#include <iostream>

#include "app/preview/target.h"
#include "commands/dump.h"
#include "commands/options.h"
#include "commands/program.h"
#include "gallery/gallery.h"
#include "lapfx/authoring/command_line.h"
#include "lapfx/authoring/file.h"
#include "lapfx/context.h"
#include "output/files.h"
#include "ui/core/tree.h"
#include "ui/gl/renderer.h"
#include "window/ui_window.h"

namespace lapfx::gallery {

namespace {

using namespace commands;

void set_up(gallery::State& state, const GalleryOptions& o) {
    state.page = gallery::page_named(o.page);
    if (state.page < 0) {
        throw wrong_option("--page", "\"" + o.page + "\" is not one of " + gallery_page_names(", "));
    }
    if (o.theme != "dark" && o.theme != "light")
        throw wrong_option("--theme", "\"" + o.theme + "\" is neither dark nor light");
    state.light = o.theme == "light";
    state.bare = o.bare;
    state.reduced_motion = o.reduced_motion;
}

/// A UI without a window, with a clock that advances by frames, so that the picture is always the same.
class Still {
  public:
    Still(const GalleryOptions& o, glm::ivec2 size) : size_(size), scale_(o.scale > 0 ? o.scale : 1.0F) {
        set_up(state_, o);
        state_.reduced_motion = true;
        state_.scale = scale_;
        settle();
        if (o.focus.empty()) return;
        try {
            ui_.set_focus(ui_.tree()[ui::find(ui_.tree(), o.focus)].id, true);
        } catch (const std::invalid_argument& error) {
            throw wrong_option("--focus", error.what());
        }
        settle();
    }

    std::span<const ui::Node> tree() const { return ui_.tree(); }

    /// With a current context.
    Image picture() {
        const app::Target target(size_);
        ui::Renderer().draw(*output_->list, fonts_, &images_, target.framebuffer());
        return target.read();
    }

  private:
    /// Runs frames until none is requested soon; an endless request is stopped after a while.
    void settle() {
        for (int i = 0; i < 20; ++i) {
            time_ += 1.0 / 60;
            output_ = &ui_.frame({.size = size_, .scale = scale_, .time = time_},
                                 [&](ui::Ui& u) { gallery::build(u, state_); });
            if (output_->wake_at > time_ + 0.1) return;
        }
    }

    ui::ImageStore images_;
    gallery::State state_{images_};
    glm::ivec2 size_;
    float scale_;
    double time_ = 0;
    ui::Fonts fonts_{{.hinting = ui::Hinting::slight}};  // whatever the host prefers
    ui::Ui ui_{fonts_, {.images = &images_, .shortcuts = &state_.commands}};
    const ui::FrameOutput* output_ = nullptr;
};

void make_files(const GalleryOptions& o) {
    const glm::ivec2 size = parse_size(o.size);
    check_output("--screenshot", o.screenshot);
    check_output("--dump", o.dump);
    if (!o.screenshot.empty()) check_picture_name("--screenshot", o.screenshot);
    Still still(o, size);
    if (!o.dump.empty()) write_dump(o.dump, still.tree());
    if (o.screenshot.empty()) return;
    const Context context = Context::create(parse_backend(o.backend));
    output::write_png(o.screenshot, still.picture());
}

void show_window(const GalleryOptions& o) {
    ui::ImageStore images;
    gallery::State state(images);
    set_up(state, o);
    check_output("--dump-on-close", o.dump_on_close);
    window::UiWindow window({.title = "lapfx gallery",
                             .size = parse_size(o.size),
                             .scale = o.scale,
                             .theme = state.light ? &ui::light_theme() : &ui::dark_theme(),
                             .reduced_motion = o.reduced_motion,
                             .shortcuts = &state.commands,
                             .images = &images,
                             .log = o.statistics ? &std::cerr : nullptr});
    window.run([&](ui::Ui& u) {
        state.scale = window.scale();
        gallery::build(u, state);
        if (state.scale != window.scale()) window.set_scale(state.scale);
        if (state.close) window.close();
    });
    if (!o.dump_on_close.empty()) write_dump(o.dump_on_close, window.ui().tree());
    const window::WindowStatistics& s = window.statistics();
    if (o.statistics)
        std::cerr << "lapfx: " << s.frames << " frames, " << s.drawn << " drawn, " << s.waits << " waits\n";
}

void run(const GalleryOptions& o) {
    if (o.screenshot.empty() && o.dump.empty()) return show_window(o);
    make_files(o);
}

}  // namespace

}  // namespace lapfx::gallery

int main(int argc, char** argv) {
    return lapfx::commands::run_verb(argc, argv, [] { return lapfx::commands::gallery_verb(lapfx::gallery::run); });
}
