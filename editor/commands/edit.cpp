// lapfx edit: the editor, in a window or as a picture of it.
#include <malloc.h>

#include <chrono>
#include <iostream>
#include <utility>

#include "app/base/layouts.h"
#include "app/base/settings.h"
#include "app/files/autosave.h"
#include "app/files/files.h"
#include "app/files/hot_reload.h"
#include "app/files/open.h"
#include "app/memory.h"
#include "app/meter.h"
#include "commands/command.h"
#include "commands/dump.h"
#include "commands/headless_editor.h"
#include "commands/options.h"
#include "commands/say.h"
#include "commands/session.h"
#include "lapfx/authoring/file_guard.h"
#include "lapfx/authoring/formats.h"
#include "output/files.h"
#include "panels/panels.h"
#include "ui/core/node.h"
#include "window/ui_window.h"

namespace lapfx::commands {

namespace {

struct Options {
    std::vector<std::string> files;
    std::string screenshot, dump, dump_on_close, layout, size, theme = "", backend = "auto";
    double at = -1;
    float scale = 0;
    bool statistics = false;
};

constexpr glm::ivec2 standard_size{1440, 900};
constexpr double sample_moment = 6;  // s of the sample scene, when there is blood and smoke

glm::ivec2 size_of(const Options& o) {
    return o.size.empty() ? standard_size : parse_size(o.size);
}

/// Runs before there is a window, so that a file that cannot be opened is reported on the command line. What `videos`
/// are for takes longer to find out.
app::Opened open_all(const std::vector<std::string>& files, std::vector<std::string>& videos) {
    app::Opened opened = app::open_sample(data_folder());
    videos = app::open_files(opened, files);
    for (const std::string& warning : opened.warnings) warn(warning);
    return opened;
}

void set_up(app::Editor& editor, app::Opened opened, const Options& o) {
    editor.document.open(std::move(opened.content), opened.scene_file, opened.preset_file);
    editor.looking.camera = editor.document.scene().camera;
    if (opened.unit) editor.files().propose_unit(*opened.unit);
    if (!o.theme.empty()) editor.settings().light = o.theme == "light";
    if (!o.layout.empty() && !editor.layouts().choose(o.layout)) {
        std::string names;
        for (const std::string& name : editor.layouts().names()) names += (names.empty() ? "" : ", ") + name;
        throw wrong_option("--layout", "\"" + o.layout + "\" is not one of " + names);
    }
    if (o.at >= 0) editor.timeline.seek(o.at);
    if (o.at < 0 && !o.screenshot.empty() && o.files.empty()) editor.timeline.seek(sample_moment);
}

/// The editor as a picture, and the tree of its widgets.
void write_files(const Options& o) {
    guard_files(FileGuard::refuse);  // nobody saves anything here
    const glm::ivec2 size = size_of(o);
    if (!o.screenshot.empty()) check_picture_name("--screenshot", o.screenshot);
    check_output("--screenshot", o.screenshot);
    check_output("--dump", o.dump);
    std::vector<std::string> videos;
    app::Opened opened = open_all(o.files, videos);
    const auto early = app::load_early(opened.content.scene, opened.content.preset, clip_folders());
    HeadlessEditor headless(size, o.scale, o.backend, true, early);
    set_up(headless.editor(), std::move(opened), o);
    headless.editor().files().bring_videos(videos);
    headless.settle();
    if (!o.dump.empty()) write_dump(o.dump, headless.ui().tree());
    if (!o.screenshot.empty()) output::write_png(o.screenshot, headless.picture());
}

/// Keys of the window and the settings can both change the scale: the one that differs from `agreed` counts.
void follow_scale(window::UiWindow& window, app::Settings& settings, float& agreed) {
    if (settings.scale != agreed)
        window.set_scale(settings.scale);
    else
        settings.scale = window.chosen_scale();
    agreed = settings.scale;
}

/// Memory other than that of the clips has no budget, so tests get a line on stderr about once a second.
class MemoryLog {
  public:
    void tell(app::Editor& editor, double now) {
        if (now - told_ < 1) return;
        told_ = now;
        const std::size_t bytes = app::ProcessMemory::now().all;
        if (bytes == 0) return;
        std::cerr << "memory at " << now << " s: " << bytes << " bytes, " << editor.preview.memory_use().clips
                  << " of clips\n";
    }

  private:
    double told_ = -1e9;
};

/// Jobs and compiled shaders fragment the heap: without trimming a tenth of it would never be returned.
class HeapKeeper {
  public:
    /// Call it after each frame.
    void tidy(bool busy) {
        constexpr std::chrono::seconds now_and_then{10}, at_most{2};  // jobs may be short and many
        const auto now = std::chrono::steady_clock::now();
        done_ |= std::exchange(busy_, busy) && !busy;
        if (now - last_ < (done_ ? at_most : now_and_then)) return;
        done_ = false;
        last_ = now;
        malloc_trim(0);
    }

  private:
    bool busy_ = false;
    bool done_ = false;  ///< a job has ended since
    std::chrono::steady_clock::time_point last_{};
};

/// The window saves what it has opened, so nothing else refuses this.
void require_own_dump(const Options& o) {
    if (!o.dump_on_close.empty() && is_read(o.dump_on_close))
        throw wrong_option("--dump-on-close", '"' + o.dump_on_close + "\" is a file that is read here");
}

void show_window(const Options& o) {
    check_output("--dump-on-close", o.dump_on_close);
    std::vector<std::string> videos;
    app::Opened opened = open_all(o.files, videos);
    for (const std::string& video : videos) note_read(video);  // it is opened later
    require_own_dump(o);
    const auto early = app::load_early(opened.content.scene, opened.content.preset, clip_folders());
    ui::ImageStore images;
    window::UiWindow window({.title = "lapfx",
                             .size = size_of(o),
                             .scale = o.scale,
                             .images = &images,
                             .log = o.statistics ? &std::cerr : nullptr});
    // Destroyed before the window, because its pictures are in the window's context and its threads wake the window's
    // UI.
    const auto editor = std::make_unique<app::Editor>(images,
                                                      app::EditorOptions{.data_folder = data_folder(),
                                                                         .clip_folders = clip_folders(),
                                                                         .folders = document::Folders::of_user(),
                                                                         .exact = false,
                                                                         .renderer = window.context().renderer(),
                                                                         .software = window.context().software(),
                                                                         .files = nullptr},
                                                      early);
    panels::set_up(*editor);
    set_up(*editor, std::move(opened), o);
    window.ui().set_shortcuts(&editor->commands);
    editor->hot_reload().set_ui_shaders([&](std::string_view vertex, std::string_view fragment, std::string& fault) {
        return window.reload_shaders(vertex, fragment, fault);
    });
    app::Settings& settings = editor->settings();
    for (const std::string& file : o.files) settings.note_recent(file);
    if (o.scale <= 0) window.set_scale(settings.scale);
    float scale = settings.scale;
    if (o.size.empty()) window.put(settings.window);
    editor->files().note_opened();
    editor->files().bring_videos(videos);
    editor->autosave().find();
    if (o.at < 0) editor->timeline.speed = 1;  // plays at once, so that blood and smoke are visible
    double touched = -1;                       // s, time of the last input known to the editor
    MemoryLog memory_log;
    HeapKeeper heap;
    const auto before = [&](double now) {
        if (o.scale <= 0) follow_scale(window, settings, scale);
        settings.window = window.place();
        if (window.last_input() > touched) editor->touch(now);
        touched = window.last_input();
        editor->meter().ui = window.statistics().ui_seconds;
        if (o.statistics) memory_log.tell(*editor, now);
    };
    const auto after = [&] {
        window.set_title(editor->files().title());
        window.set_busy(editor->jobs.busy());
        heap.tidy(editor->jobs.busy());
        if (editor->files().closed()) window.close();
    };
    const window::UiProgram program{.build = [&](ui::Ui& u) { panels::workspace(u, *editor); },
                                    .frame =
                                        [&](const window::UiFrame& f) {
                                            before(f.now);
                                            const bool changed = editor->frame(f.now, f.build, {.visible = f.visible});
                                            after();
                                            return changed;
                                        },
                                    .may_close =
                                        [&] {
                                            editor->files().close();
                                            return editor->files().closed();
                                        }};
    try {
        window.run(program);
    } catch (...) {
        editor->autosave().write_now();
        throw;
    }
    require_own_dump(o);
    if (!o.dump_on_close.empty()) write_dump(o.dump_on_close, window.ui().tree());
}

void run(const Options& o) {
    if (o.theme != "" && o.theme != "dark" && o.theme != "light")
        throw wrong_option("--theme", "\"" + o.theme + "\" is neither dark nor light");
    if (o.screenshot.empty() && o.dump.empty()) return show_window(o);
    write_files(o);
}

}  // namespace

Verb edit_verb() {
    const auto o = std::make_shared<Options>();
    Verb verb{.name = "edit",
              .help = "Open the editor; on the sample scene if no file is given",
              .footer = "Example:\n  lapfx edit samples/lagb.scene.json --layout Key --screenshot key.png",
              .run = [o] { run(*o); }};
    verb.argument("FILE",
                  "A scene or preset (.json), an organ (" + listed(Content::mesh, ", ") +
                      "), a video or image of smoke (added to the preset's clips) or of a surgery (the reference), "
                      "numbered images (smoke_%04d.png)",
                  &o->files);
    verb.option("--screenshot", "FILE", "Write a PNG of the editor instead of opening a window", &o->screenshot);
    verb.option("--size", "WxH",
                "Size in pixels, of a window at scale 1; default: the size at which the window was last closed, "
                "for files 1440x900",
                &o->size);
    verb.option("--layout", "Tune|Key|Compare|Stage|NAME", "How panels are arranged; NAME is a layout of your own",
                &o->layout);
    verb.option("--theme", "dark|light", "Colours of the user interface", &o->theme);
    verb.option("--at", "SECONDS", "The time that is shown", &o->at, {.range = Range{0.0, 86400.0}});
    verb.option("--scale", "NUMBER", "Scale of the user interface, 0.75 to 3", &o->scale, {.range = Range{0.75, 3.0}});
    verb.option("--backend", "egl|osmesa|auto", "For --screenshot: the OpenGL that draws; auto is EGL, else OSMesa",
                &o->backend, {.shows_default = true});
    verb.option("--dump", "FILE",
                "Write all widgets with names, values and places instead of opening a window: .json, or one line "
                "per widget",
                &o->dump);
    verb.option("--dump-on-close", "FILE", "Like --dump, but when the window is closed", &o->dump_on_close);
    verb.flag("--statistics",
              "Print a line on stderr for every frame of the window and why it was drawn, and the memory that the "
              "window uses",
              &o->statistics);
    return verb;
}

}  // namespace lapfx::commands
