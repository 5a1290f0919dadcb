// The editor without its panels: the document, what is shown of it, and everything that panels share. Panels
// (editor/panels) are functions on this; a test drives them without a window.
//
//     ui::ImageStore images;
//     app::Editor editor(images, {.data_folder = "..."});
//     editor.open({"samples/lagb.scene.json"});
//     each frame:  editor.update(now);  ui.frame(input, [&](ui::Ui& u) { panels::workspace(u, editor); });
//         editor.draw();
//
// UI thread, context current.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/jobs.h"
#include "app/preview_host.h"
#include "app/scene_pace.h"
#include "app/tool_hold.h"
#include "document/document.h"
#include "document/folders.h"
#include "ui/canvas/timeline.h"
#include "ui/shell/commands.h"
#include "ui/shell/file_dialog.h"
#include "ui/shell/toast.h"
#include "ui/widgets/color_field.h"

namespace lapfx::app {

class AmountsOverTime;
class Autosave;
class Browser;
class Exports;
class FilePreviews;
class Files;
class HotReload;
class KeyingBench;
class Layouts;
class Meter;
class OrganChoice;
class Reference;
class Settings;
class Snapshots;
class Tuning;

struct EditorOptions {
    std::filesystem::path data_folder;                ///< of the shipped presets, samples and shaders
    std::vector<std::filesystem::path> clip_folders;  ///< where bare clip names are looked up
    document::Folders folders;                        ///< of the user: settings, state, cache
    /// For pictures and tests: clips and references are decoded exactly, jobs waited for, nothing is autosaved.
    bool exact = false;
    std::string renderer;                        ///< GL_RENDERER, for the status bar
    bool software = false;                       ///< no GPU
    std::function<double()> clock{};             ///< s, for what pictures cost; empty: this computer's
    ui::FileSystem* files = nullptr;             ///< of file dialogs; null: this computer's
    std::shared_ptr<EarlyLoad> early = nullptr;  ///< of the document that will be opened first
};

/// How the organ is looked at.
struct Looking {
    /// True: through the scene's camera, with its vignette, and fixed: what `lapfx render` shows. False: freely, by
    /// `camera`.
    bool endoscope = true;
    SceneCamera camera;
    Overlay overlay = Overlay::none;
};

/// What the left button does on the organ.
struct ToolInHand {
    std::optional<ToolAction> action;  ///< none: it looks around
    double power = 1, strength = 1;
};

class Editor {
  public:
    Editor(ui::ImageStore& images, EditorOptions options);
    ~Editor();
    Editor(const Editor&) = delete;
    Editor& operator=(const Editor&) = delete;

    // --- what is edited ---------------------------------------------------------------------------------------------
    document::Document document;
    Looking looking;
    ToolInHand tool;
    ToolHold hold;                      ///< while the tool works on the organ
    ui::TimelineState timeline;         ///< time, speed, range of play
    double play_speed = 1;              ///< of play.toggle
    std::vector<std::size_t> selected;  ///< of the scene's events, ascending
    std::size_t clip = 0;               ///< of the preset's clips, the one that panels show
    ui::Eyedropper eyedropper;          ///< while wanted_by, pictures give a colour for a click (app/pick_color.h)

    // --- parts ------------------------------------------------------------------------------------------------------
    Jobs jobs;
    PreviewHost preview;
    ui::CommandTable commands;
    ui::Toasts toasts;
    ui::FileDialog file_dialog;
    ui::ImageStore& images;

    Settings& settings() { return *settings_; }       ///< what the user chose: theme, recent files, keys
    Tuning& tuning() { return *tuning_; }             ///< locks, favourites, randomise, copied groups
    Snapshots& snapshots() { return *snapshots_; }    ///< A to D
    AmountsOverTime& amounts() { return *amounts_; }  ///< of the whole scene
    Autosave& autosave() { return *autosave_; }
    Layouts& layouts() { return *layouts_; }
    Browser& browser() { return *browser_; }  ///< presets with thumbnails
    KeyingBench& keying() { return *keying_; }
    Reference& reference() { return *reference_; }
    OrganChoice& organ_choice() { return *organ_choice_; }  ///< of the organ dialog
    Exports& exports() { return *exports_; }
    Meter& meter() { return *meter_; }                         ///< what a frame costs
    FilePreviews& file_previews() { return *file_previews_; }  ///< of the file dialog
    Files& files() { return *files_; }                         ///< new, open, save, close, and what they ask
    HotReload& hot_reload() { return *hot_reload_; }
    const EditorOptions& options() const { return options_; }

    // --- files ------------------------------------------------------------------------------------------------------
    /// Scenes, presets, organs, clips, whatever they are (editor/app/open.h). What is wrong is told by toasts. Asks
    /// first when work would be lost, or another editor has the file (app/files.h).
    void open(const std::vector<std::string>& files);
    /// The same for files that a person brings (dropped, chosen, recent): a video may be a smoke clip or the reference,
    /// and is asked about.
    void bring(const std::vector<std::string>& files);
    /// An organ, by the dialog that sets its unit and orientation.
    void open_organ(const std::filesystem::path& file);
    /// Opens the file dialog; `then` gets the paths that were chosen, of save one that may exist (the person was
    /// asked). While the UI is built: ui() must be there.
    void ask_file(ui::FileRequest request, std::function<void(const std::vector<std::string>&)> then);
    /// Where something is written unless the person says otherwise: where it was last (`title` of the dialog), in
    /// `beside`, among the user's documents; never among the files that came with the program.
    std::filesystem::path own_folder(const std::string& title, const std::filesystem::path& beside = {}) const;
    /// Once a frame, by the workspace.
    void build_file_dialog();
    /// A toast for each fault, and a line in the log of faults.
    void tell(const std::vector<Fault>& faults);
    void tell(const Error& error) { tell(error.faults()); }

    /// Another document, or preset alone, has been opened: what was selected, held or on its way for the former one
    /// goes.
    void forget_document(bool scene_too = true);

    // --- a frame ----------------------------------------------------------------------------------------------------
    /// Once before each frame: time goes on, results of jobs are applied. `now`: s, any origin.
    void update(double now);
    /// A person does something, at the `now` of the update() that follows: what is drawn without a GPU makes room.
    void touch(double now) { pace_.touch(now); }
    /// While the UI is built: the one UI that this editor has; for commands that open dialogs.
    void set_ui(ui::Ui& ui);
    ui::Ui& ui() { return *ui_; }
    /// The preview takes what has changed in the document. draw() begins with it; again, it does nothing.
    void follow();
    /// Once after each frame: draws what the panels asked for. Gives whether a picture has changed, so that the window
    /// has to be drawn although its list is the same.
    bool draw();
    Shot shot() const;                                                             ///< of the viewport, as it is now
    double scene_scale() const { return options_.exact ? 1 : pace_.scale(now_); }  ///< Shot::scale
    /// When a scene that was drawn coarsely, to make room, is to be drawn whole, s; infinite: it is.
    double whole_at() const { return pace_.whole_at(); }
    bool playing() const { return timeline.speed != 0; }
    double duration() const;  ///< s, of the scene
    void seek(double time);
    /// The next frame comes at once: something moves by itself.
    bool wants_frame() const;

    /// Closing: the workspace then asks what is not saved (Files::close), or closes.
    void ask_to_close() { closing_ = true; }
    bool closing() const { return closing_; }
    void stay() { closing_ = false; }
    void close() { closed_ = true; }
    bool closed() const { return closed_; }  ///< the window is to close

  private:
    void advance(double seconds);
    bool draw_pictures();
    bool draw_in_turn();
    double clock() const;
    void tidy_gesture();
    void tidy_selection();
    void tidy_eyedropper();

    EditorOptions options_;
    ui::Ui* ui_ = nullptr;
    std::unique_ptr<Settings> settings_;
    std::unique_ptr<Tuning> tuning_;
    std::unique_ptr<Snapshots> snapshots_;
    std::unique_ptr<AmountsOverTime> amounts_;
    std::unique_ptr<Autosave> autosave_;
    std::unique_ptr<Layouts> layouts_;
    std::unique_ptr<Browser> browser_;
    std::unique_ptr<KeyingBench> keying_;
    std::unique_ptr<OrganChoice> organ_choice_;
    std::unique_ptr<Reference> reference_;
    std::unique_ptr<Exports> exports_;
    std::unique_ptr<FilePreviews> file_previews_;
    std::unique_ptr<Files> files_;
    std::unique_ptr<HotReload> hot_reload_;
    std::unique_ptr<Meter> meter_;
    std::function<void(const std::vector<std::string>&)> file_asked_;
    double now_ = -1;
    ScenePace pace_;
    bool closing_ = false, closed_ = false;
    // As they were at the last update().
    std::size_t events_before_ = 0;
    std::vector<std::size_t> selected_before_;
    bool picked_before_ = false;
};

}  // namespace lapfx::app
