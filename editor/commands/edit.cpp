// lapfx edit: the editor, in a window or as a picture of it.
#include <iostream>

#include "app/hot_reload.h"
#include "app/layouts.h"
#include "app/open.h"
#include "app/settings.h"
#include "app/target.h"
#include "commands/command.h"
#include "commands/options.h"
#include "commands/output.h"
#include "commands/session.h"
#include "panels/panels.h"
#include "ui/gl/renderer.h"
#include "window/ui_window.h"

namespace lapfx::commands {

namespace {

struct Options {
    std::vector<std::string> files;
    std::string screenshot, layout, size = "1440x900", theme = "", backend = "auto";
    double at = -1;
    float scale = 0;
    bool statistics = false;
};

/// Before there is a window: a file that cannot be opened is told on the command line.
app::Opened open_all(const std::vector<std::string>& files) {
    app::Opened opened = app::open_sample(data_folder());
    app::open_files(opened, files);
    for (const std::string& warning : opened.warnings) std::cerr << "lapfx: warning: " << warning << '\n';
    return opened;
}

void set_up(app::Editor& editor, app::Opened opened, const Options& o) {
    panels::add_commands(editor);
    editor.document.open(std::move(opened.content), opened.scene_file, opened.preset_file);
    editor.looking.camera = editor.document.scene().camera;
    if (!o.theme.empty()) editor.settings().light = o.theme == "light";
    if (!o.layout.empty() && !editor.layouts().choose(o.layout)) {
        std::string names;
        for (const std::string& name : editor.layouts().names()) names += (names.empty() ? "" : ", ") + name;
        throw wrong_option("--layout", "\"" + o.layout + "\" is none of " + names);
    }
    if (o.at >= 0) editor.seek(o.at);
}

/// Frames until no other is asked for, with a clock that goes by frames: the same picture every time.
void write_screenshot(const Options& o) {
    const glm::ivec2 size = parse_size(o.size);
    if (!o.screenshot.ends_with(".png")) throw wrong_option("--screenshot", "\"" + o.screenshot + "\" is no .png");
    check_folder(o.screenshot);
    app::Opened opened = open_all(o.files);
    const auto early = app::load_early(opened.content.scene, opened.content.preset, clip_folders());
    const Context context = Context::create(parse_backend(o.backend));
    ui::ImageStore images;
    app::Editor editor(images, {.data_folder = data_folder(),
                                .clip_folders = clip_folders(),
                                .folders = {},
                                .exact = true,
                                .renderer = context.renderer(),
                                .software = context.software(),
                                .files = nullptr,
                                .early = early});
    if (o.at < 0 && o.files.empty()) editor.timeline.time = 6;
    set_up(editor, std::move(opened), o);
    ui::Fonts fonts({.hinting = ui::Hinting::slight});  // whatever the host prefers
    ui::Ui ui(fonts, {.images = &images, .shortcuts = &editor.commands, .reduced_motion = true});
    const ui::FrameOutput* output = nullptr;
    double time = 0;
    for (int i = 0; i < 20; ++i) {
        time += 1.0 / 60;
        editor.update(time);
        output = &ui.frame({.size = size, .scale = o.scale > 0 ? o.scale : 1.0F, .time = time},
                           [&](ui::Ui& u) { panels::workspace(u, editor); });
        const bool changed = editor.draw();
        if (!changed && output->wake_at > time + 0.1 && !editor.jobs.busy()) break;
    }
    const app::Target target(size);
    ui::Renderer().draw(*output->list, fonts, &images, target.framebuffer());
    write_png(o.screenshot, target.read());
}

void show_window(const Options& o) {
    app::Opened opened = open_all(o.files);
    const auto early = app::load_early(opened.content.scene, opened.content.preset, clip_folders());
    ui::ImageStore images;
    std::unique_ptr<app::Editor> editor;
    window::UiWindow window({.title = "lapfx",
                             .size = parse_size(o.size),
                             .scale = o.scale,
                             .images = &images,
                             .log = o.statistics ? &std::cerr : nullptr});
    editor = std::make_unique<app::Editor>(images, app::EditorOptions{.data_folder = data_folder(),
                                                                      .clip_folders = clip_folders(),
                                                                      .folders = document::Folders::of_user(),
                                                                      .exact = false,
                                                                      .renderer = window.context().renderer(),
                                                                      .software = window.context().software(),
                                                                      .files = nullptr,
                                                                      .early = early});
    set_up(*editor, std::move(opened), o);
    window.ui().set_shortcuts(&editor->commands);
    editor->hot_reload().set_ui_shaders([&](std::string_view vertex, std::string_view fragment, std::string& fault) {
        return window.reload_shaders(vertex, fragment, fault);
    });
    window.run({.update = [&](double now) { editor->update(now); },
                .build =
                    [&](ui::Ui& u) {
                        panels::workspace(u, *editor);
                        if (editor->closed()) window.close();
                    },
                .draw =
                    [&] {
                        const bool changed = editor->draw();
                        window.set_busy(editor->jobs.busy());
                        return changed;
                    },
                .may_close =
                    [&] {
                        editor->ask_to_close();
                        return editor->closed();
                    }});
}

void run(const Options& o) {
    if (o.theme != "" && o.theme != "dark" && o.theme != "light")
        throw wrong_option("--theme", "\"" + o.theme + "\" is neither dark nor light");
    if (o.screenshot.empty()) return show_window(o);
    write_screenshot(o);
}

}  // namespace

void add_edit(CLI::App& app) {
    auto o = std::make_shared<Options>();
    CLI::App* verb = app.add_subcommand("edit", "Open the editor; on the sample scene if no file is given");
    verb->add_option("FILE", o->files,
                     "A scene or preset (.json), an organ (.glb, .gltf, .obj, .ply, .stl, .off), a smoke video or "
                     "image, numbered images (smoke_%04d.png)");
    verb->add_option("--screenshot", o->screenshot, "Write a PNG of the editor instead of opening a window");
    verb->add_option("--size", o->size, "WxH in pixels; of a window, at scale 1")->capture_default_str();
    verb->add_option("--layout", o->layout, "How panels are arranged: Tune, Key, Compare, Stage, or one of your own");
    verb->add_option("--theme", o->theme, "dark or light");
    verb->add_option("--at", o->at, "Time it stands at, s")->check(finite_number())->check(CLI::Range(0.0, 86400.0));
    verb->add_option("--scale", o->scale, "Of the user interface, 0.75 to 3")
        ->check(finite_number())
        ->check(CLI::Range(0.75, 3.0));
    verb->add_option("--backend", o->backend, "Of --screenshot: egl, osmesa or auto (EGL, else OSMesa)")
        ->capture_default_str();
    verb->add_flag("--statistics", o->statistics, "A line on stderr for every frame that the window makes, and why");
    verb->footer("Example: lapfx edit samples/lagb.scene.json --layout Key --screenshot key.png");
    verb->callback([o] { run(*o); });
    // `lapfx` alone opens the sample scene.
    app.callback([&app] {
        if (app.get_subcommands().empty()) run({});
    });
}

}  // namespace lapfx::commands
