// New, open, save, close: what each asks first, and what it says when it fails. A question is data here;
// panels/closing_dialog.cpp shows it. Nothing is lost without an answer that says so.
//
//     editor.files().save_preset();                    // asks for a name where there is none
//     if (const auto* q = editor.files().question()) ...  // "tuned.json has been changed by another program"
//     editor.files().answer(0);
//
// A document that is open is locked (document/lock.h): a second editor is told. UI thread.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/files/open.h"
#include "document/lock.h"
#include "lapfx/authoring/suggest.h"

namespace lapfx::ui {
class CommandTable;
}

namespace lapfx::app {

class Autosave;
class ClipShelf;
class Exports;
class FileChooser;
class Jobs;
class Layouts;
class Notices;
class OrganChoice;
class Reference;
class Settings;
class Snapshots;
struct EditorOptions;
struct Looking;

class Files {
  public:
    using Then = std::function<void()>;

    /// What is opened, saved and closed concerns many parts.
    struct Parts {
        document::Document& document;
        std::vector<std::size_t>& selected;  ///< of the scene's events
        Looking& looking;
        Autosave& autosave;
        ClipShelf& clips;
        Exports& exports;
        FileChooser& chooser;
        Layouts& layouts;
        OrganChoice& organ_choice;
        Reference& reference;
        Settings& settings;
        Snapshots& snapshots;
        ui::CommandTable& commands;  ///< a question may lead to the export of a bundle
        Notices& notices;
        Jobs& jobs;
        const EditorOptions& options;
        /// Another document, or another preset alone, is open: whoever works on the former one lets go of it.
        std::function<void(bool scene_too)> forget_document;
    };
    explicit Files(Parts parts) : parts_(std::move(parts)) {}

    // --- commands: each asks what it has to --------------------------------------------------------------------------
    void make_new();  ///< the sample's organ with the default preset, without events
    void open_dialog();
    /// `then` follows when it has been saved.
    void save_preset(Then then = {});
    void save_preset_as(Then then = {});
    void save_scene(Then then = {});
    void save_scene_as(Then then = {});
    void save_all(Then then = {});
    /// Ends the editor, or asks what is not saved.
    void close();
    bool closed() const { return closed_; }  ///< the window is to close

    // --- opening -----------------------------------------------------------------------------------------------------
    /// Scenes, presets, organs, videos, whatever they are (app/files/open.h). What is wrong is told by notices. Asks
    /// first when work would be lost, or another editor has the file.
    void open(const std::vector<std::string>& files);
    /// The same for files that a person brings (dropped, chosen, recent): an organ is opened by the dialog that sets
    /// its unit and orientation.
    void bring(const std::vector<std::string>& files);
    /// Does the same as open(), but discards unsaved changes: the person has been asked.
    void open_anyway(const std::vector<std::string>& files);
    /// Makes the work that an editor left when it crashed (Autosave::offers) the document.
    void recover(std::size_t offer);
    /// The program itself has put something into the document, at its start or recovered: asks the same question
    /// afterwards.
    void note_opened();
    /// A notice that offers that unit for an organ which was opened without the dialog.
    void propose_unit(const UnitProposal& unit);

    // --- videos (files_videos.cpp)
    // ------------------------------------------------------------------------------------
    /// Looks by a job at what is in them. Smoke is added to the clips of the preset, the first surgery becomes the
    /// reference, and a notice offers the other way; what is neither for certain is asked about. Nothing else of the
    /// preset or the scene changes, and each change can be undone.
    void bring_videos(const std::vector<std::string>& videos) { look_at(videos, {}); }
    /// The same for videos that were brought to a place that says what for: done without a word, but asked first where
    /// what is in them contradicts it for certain.
    void bring_clips(const std::vector<std::string>& videos) { look_at(videos, VideoUse::smoke); }
    void bring_reference(const std::string& video) { look_at({video}, VideoUse::reference); }

    // --- what is asked -----------------------------------------------------------------------------------------------
    struct Answer {
        std::string label;
        std::string tip{};
        Then act{};
        bool standard = false, cancel = false;
    };
    struct Question {
        std::string title, text;
        std::vector<std::string> lines{};  ///< details, a line each
        std::vector<Answer> answers{};
        std::uint64_t serial = 0;  ///< another one for each question
    };
    const Question* question() const { return question_ ? &*question_ : nullptr; }
    void answer(std::size_t index);

    /// "my_bleed.json* - lagb.scene.json - lapfx"; an asterisk: not saved.
    const std::string& title();

  private:
    enum class Kind { scene, preset };
    const std::filesystem::path& file(Kind kind) const;
    bool needs_name(Kind kind) const;
    struct LookedAt {
        std::string file;
        UseSuggestion found;
        std::vector<Fault> faults;  ///< it cannot be looked at
    };
    void look_at(const std::vector<std::string>& videos, std::optional<VideoUse> meant);
    void sort_videos(std::vector<LookedAt> videos, std::optional<VideoUse> meant);
    void ask_what_for(const std::vector<LookedAt>& videos, std::function<void(std::optional<VideoUse>)> then);
    void put_to_use(const std::vector<std::string>& videos, VideoUse as);
    void tell_what_for(const std::vector<std::string>& videos, VideoUse as, const std::string& reason);
    /// False: there is unsaved work that would go; it is asked, and open() called again after the answer.
    bool ready_to_open(const std::vector<std::string>& files);
    /// What was opened becomes the document; asks first when it is open in another editor.
    void put(Opened opened, const std::vector<std::string>& files);
    void ask(Question question);
    void ask_unsaved(std::string title, Then then, Then otherwise, bool scene_too = true);
    void ask_running(Then then);
    void ask_failed(Kind kind, const std::filesystem::path& file, const std::vector<Fault>& faults, Then then);
    void ask_outside(const std::filesystem::path& file, const std::vector<std::string>& clips, Then then);
    void ask_in_use(const std::vector<Kind>& used, const std::vector<std::filesystem::path>& files, Then go_on,
                    Then otherwise);
    void save(Kind kind, Then then);
    void save_as(Kind kind, Then then);
    void save_to(Kind kind, const std::filesystem::path& file, Then then);
    std::string name_for(Kind kind, const std::filesystem::path& to) const;
    void write(Kind kind, const std::filesystem::path& file, const Then& then);
    struct Kinds {
        bool scene = false, preset = false;
    };
    static Kinds kinds_of(const std::vector<std::string>& files);
    void become(Opened opened, const std::vector<std::string>& files, Kinds kinds);
    void relock();
    /// False: another editor has locked it. A file that cannot be locked at all counts as ours; that is told once.
    bool lock(Kind kind, const std::filesystem::path& file);
    std::string holder(const std::filesystem::path& file) const;
    std::vector<std::string> unsaved_words(bool scene_too) const;
    std::string shipped_words(bool scene_too) const;

    Parts parts_;
    std::optional<Question> question_;
    std::vector<Then> after_question_;  ///< what has come meanwhile and may ask, too
    std::uint64_t serial_ = 0;
    bool agreed_ = false, lock_told_ = false, closed_ = false;
    std::optional<document::Lock> locks_[2];
    std::string title_;
    std::uint64_t title_version_ = 0;
};

}  // namespace lapfx::app
