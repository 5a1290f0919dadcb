// The editor without its panels: the document, what is shown of it, and the parts that panels work on. Panels
// (editor/panels) are functions on those parts; panels/workspace.cpp hands them out. A test drives them without a
// window.
//
//     ui::ImageStore images;
//     app::Editor editor(images, {.data_folder = "..."});
//     panels::set_up(editor);
//     editor.files().open({"samples/lagb.scene.json"});
//     each frame:  editor.frame(now, [&] { ui.frame(input, [&](ui::Ui& u) { panels::workspace(u, editor); }); });
//
// UI thread, context current.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "app/base/editor_options.h"
#include "app/base/jobs.h"
#include "app/base/notices.h"
#include "app/base/screen.h"
#include "app/preview/looking.h"
#include "app/preview/preview_host.h"
#include "app/preview/scene_pace.h"
#include "app/preview/timeline.h"
#include "app/preview/tool_hold.h"
#include "document/document.h"
#include "ui/shell/commands.h"
#include "ui/widgets/color_field.h"

namespace lapfx::app {

class AmountsOverTime;
class Autosave;
class Browser;
class ClipShelf;
class Exports;
class FileChooser;
class FilePreviews;
class FitReporting;
class Fitting;
class Files;
class HotReload;
class KeyingBench;
class Layouts;
class MeasureBench;
class Measuring;
class Meter;
class OrganChoice;
class PreviewMeasuring;
class Reference;
class Saved;
class SeenColors;
class Settings;
class SnapshotPreviews;
class Snapshots;
class Tuning;

/// The steps of a frame that Editor::frame() takes, in their order.
enum class FrameStep : std::uint8_t { updated, built, followed, drawn };

struct FrameOptions {
    bool visible = true;                        ///< false: nobody sees it, so nothing is drawn
    std::function<void(FrameStep)> after = {};  ///< called when each has been taken; to measure what they cost
};

class Editor {
  public:
    /// `early`: what load_early() has begun of the document that will be opened first, or null.
    Editor(ui::ImageStore& images, EditorOptions options, std::shared_ptr<EarlyLoad> early = nullptr);
    ~Editor();
    Editor(const Editor&) = delete;
    Editor& operator=(const Editor&) = delete;

    // --- what is edited ---------------------------------------------------------------------------------------------
    document::Document document;
    Looking looking;
    ToolInHand tool;
    Timeline timeline{document};
    std::vector<std::size_t> selected;  ///< of the scene's events, ascending
    ui::Eyedropper eyedropper;  ///< while wanted_by, pictures give a colour for a click (app/preview/pick_color.h)

    // --- parts ------------------------------------------------------------------------------------------------------
    // Each is constructed with what it works on, and reaches nothing else.
    Jobs jobs;
    PreviewHost preview;
    ui::CommandTable commands;
    Notices toasts;
    ToolHold hold;  ///< while the tool works on the organ
    ui::ImageStore& images;

    Settings& settings() { return *settings_; }     ///< what the user chose: theme, recent files, keys
    FileChooser& chooser() { return *chooser_; }    ///< asks for files
    Saved& saved() { return *saved_; }              ///< the document as it was opened or saved
    Tuning& tuning() { return *tuning_; }           ///< locks, favourites, randomise, copied groups
    Snapshots& snapshots() { return *snapshots_; }  ///< A to D
    SnapshotPreviews& snapshot_previews() { return *snapshot_previews_; }
    SeenColors& seen_colors() { return *seen_colors_; }  ///< colours that were picked, solved for
    AmountsOverTime& amounts() { return *amounts_; }     ///< of the whole scene
    Autosave& autosave() { return *autosave_; }
    Layouts& layouts() { return *layouts_; }
    Browser& browser() { return *browser_; }  ///< presets with thumbnails
    ClipShelf& clips() { return *clips_; }    ///< of the preset, as files; and which one panels show
    KeyingBench& keying() { return *keying_; }
    Reference& reference() { return *reference_; }
    Measuring& measuring() { return *measuring_; }                         ///< of the whole reference
    PreviewMeasuring& preview_measuring() { return *preview_measuring_; }  ///< of the whole scene, as the reference
    MeasureBench& measure_bench() { return *measure_bench_; }              ///< of the frame of it that is shown
    FitReporting& fit_reporting() { return *fit_reporting_; }              ///< what that has found, as a file
    Fitting& fitting() { return *fitting_; }                               ///< the preview to the reference
    OrganChoice& organ_choice() { return *organ_choice_; }                 ///< of the organ dialog
    Exports& exports() { return *exports_; }
    Meter& meter() { return *meter_; }                         ///< what a frame costs
    FilePreviews& file_previews() { return *file_previews_; }  ///< of the file dialog
    Files& files() { return *files_; }                         ///< new, open, save, close, and what they ask
    HotReload& hot_reload() { return *hot_reload_; }
    const EditorOptions& options() const { return options_; }

    /// Another document, or another preset alone, has been opened: forgets what was selected, held or under way for the
    /// former one.
    void forget_document(bool scene_too = true);

    // --- a frame ----------------------------------------------------------------------------------------------------
    /// One frame from beginning to end. `now`: s, any origin. `build` takes the events that have come and builds the
    /// panels (ui::Ui::frame with panels::workspace). Gives whether a picture has changed, so that the window has to be
    /// drawn although its list is the same.
    bool frame(double now, const std::function<void()>& build, const FrameOptions& options = {});
    /// A person did something, at the `now` of the frame() that follows: without a GPU the scene then gets less time.
    void touch(double now) { pace_.touch(now); }
    /// Call it while the UI is built. It is the one UI that this editor has, for commands that open dialogs.
    void set_ui(ui::Ui& ui);
    ui::Ui& ui() { return *screen_.ui(); }
    ui::Clipboard* clipboard() const { return screen_.clipboard(); }  ///< null: there is none
    Shot shot() const;                                                ///< of the viewport, as it is now
    /// s: when a scene that was drawn coarsely to save time will be drawn whole; infinite where it is whole.
    double whole_at() const { return pace_.whole_at(); }
    /// The next frame comes at once: something moves by itself.
    bool wants_frame() const;

  private:
    void use_tool();
    void check_driver(double now);
    void follow();
    bool draw_pictures();
    double scene_scale() const { return options_.exact ? options_.exact_scale : pace_.scale(now_); }  ///< Shot::scale
    bool draw_in_turn();
    double clock() const;
    void tidy_gesture();
    void tidy_selection();
    void tidy_eyedropper();

    EditorOptions options_;
    Screen screen_;
    ScenePace pace_;
    std::unique_ptr<Settings> settings_;
    std::unique_ptr<FileChooser> chooser_;
    std::unique_ptr<Saved> saved_;
    std::unique_ptr<SeenColors> seen_colors_;
    std::unique_ptr<Tuning> tuning_;
    std::unique_ptr<Snapshots> snapshots_;
    std::unique_ptr<AmountsOverTime> amounts_;
    std::unique_ptr<Autosave> autosave_;
    std::unique_ptr<Layouts> layouts_;
    std::unique_ptr<Browser> browser_;
    std::unique_ptr<ClipShelf> clips_;
    std::unique_ptr<KeyingBench> keying_;
    std::unique_ptr<OrganChoice> organ_choice_;
    std::unique_ptr<SnapshotPreviews> snapshot_previews_;
    std::unique_ptr<Reference> reference_;
    std::unique_ptr<Measuring> measuring_;
    std::unique_ptr<MeasureBench> measure_bench_;
    std::unique_ptr<PreviewMeasuring> preview_measuring_;
    std::unique_ptr<Fitting> fitting_;
    std::unique_ptr<FitReporting> fit_reporting_;
    std::unique_ptr<Exports> exports_;
    std::unique_ptr<Files> files_;
    std::unique_ptr<FilePreviews> file_previews_;
    std::unique_ptr<HotReload> hot_reload_;
    std::unique_ptr<Meter> meter_;
    double now_ = -1;
    // The state at the last frame.
    std::size_t events_before_ = 0;
    std::vector<std::size_t> selected_before_;
    bool picked_before_ = false;
};

}  // namespace lapfx::app
