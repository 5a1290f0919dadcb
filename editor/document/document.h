// What is edited: a scene and a preset, with everything that was done to them. No UI, no OpenGL.
//
//     document.change("Speed", [](Content& c) { c.preset.bleeding.speed = 6; });  // one undo step
//     document.take(edit, "Speed", [&](Content& c) { c.preset.bleeding.speed = speed; });  // a gesture: one step
//     document.undo();
//
// A step holds what differs before and after it (document/delta.h), so it is as large as the change, however large the
// document is. Names of files are relative to the folder of the scene or of the preset; the two change together, and
// only writing a file changes how the others are named. Values may break a rule between them while they are edited:
// they are kept, and faults() lists them. UI thread.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "document/content.h"
#include "document/delta.h"

namespace lapfx::document {

/// Whether both would be written as the same files. Two clips are the same when they name the same file, even from
/// different folders.
bool same(const Content& a, const Content& b);
bool same(const Preset& a, const Preset& b);

/// `wanted` without what breaks a rule, so that the rest of it can be shown. Each value that breaks one is taken from
/// `good`, which breaks none; where that does not help, its whole group is. A faulty clip is taken from the same place
/// of `good`, and left out if there is none.
Preset mended(Preset wanted, const Preset& good);

/// The file of a document as it is on the disk, to notice when another program has written it.
struct OnDisk {
    bool exists = false;
    std::uint64_t hash = 0;  ///< of its bytes
    friend bool operator==(const OnDisk&, const OnDisk&) = default;

    /// As the file is now. A file that cannot be read counts as missing.
    static OnDisk of(const std::filesystem::path& file);
};

/// The folder that `file` is in, as an absolute path.
std::filesystem::path folder_of(const std::filesystem::path& file);
/// The name that a document in folder `to` has to use for what a document in `from` calls `file`. A name that is not
/// found in `from` stays as it is: it is looked up on the search path.
std::string moved_path(const std::string& file, const std::filesystem::path& from, const std::filesystem::path& to);
/// The scene as a document in another folder: moved_path() of every file that it names.
void move_scene(Scene& scene, const std::filesystem::path& folder);
/// The file of a clip that a preset in this folder names, with symbolic links followed; only its name if the folder has
/// no such file. Reads the disk.
std::filesystem::path real_clip(const std::string& file, const std::filesystem::path& folder);
/// Makes all clips, some of which may be absolute paths, relative to one folder, and makes it the preset's. It is
/// `home` if all clips are in it (with symbolic links followed), else the preset's present folder, else the deepest
/// folder that holds them all. Clips in `shipped`, the folders of the search path, are named without a folder.
void gather_clips(Preset& preset, const std::filesystem::path& home, const std::vector<std::filesystem::path>& shipped);

/// One thing that was done.
struct Step {
    std::uint64_t id = 0;  ///< no other step of this document has it
    std::string name;      ///< "Speed", "Move event"
    std::string change;    ///< in words (document/words.h): "4 to 8.3 mm/s"; empty when nothing can be seen of it
    Delta scene, preset;
};

class Document {
  public:
    /// Beyond either limit the oldest steps are forgotten; the newest one always stays.
    static constexpr std::size_t most_steps = 500, most_step_bytes = std::size_t{32} << 20;

    /// An empty document, which counts as saved.
    Document();
    const Content& content() const { return content_; }
    const Scene& scene() const { return content_.scene; }
    const Preset& preset() const { return content_.preset; }
    /// Grows with every change, also with undo and redo. Whoever keeps something that was made from the document
    /// compares versions to see whether it has changed.
    std::uint64_t version() const { return version_; }
    /// What has to be done again because of changes since `version`: the redo bits of the rows that changed
    /// (lapfx/parameter.h), and those of all files when the folder changed. There may be bits too many, never too few:
    /// while a gesture is open, what it changed once counts as changing with each edit.
    unsigned scene_changes_since(std::uint64_t version) const { return scene_changed_.since(version); }
    unsigned preset_changes_since(std::uint64_t version) const { return preset_changed_.since(version); }
    unsigned changes_since(std::uint64_t version) const {
        return scene_changes_since(version) | preset_changes_since(version);
    }

    /// Replaces the content by one that was read from these files (an empty path: no file yet). Its folders become
    /// absolute. The history is forgotten.
    void open(Content content, std::filesystem::path scene_file = {}, std::filesystem::path preset_file = {});
    /// Replaces the preset only. A scene that was not saved still counts as not saved.
    void open_preset(Preset preset, std::filesystem::path preset_file = {});
    /// Work that was kept when an editor ended without saving. What was not saved then still counts as not saved. The
    /// recovered work is one undo step after the content of the files, where that is known, so that the history shows
    /// what would be lost.
    struct Recovered {
        Content content;
        std::optional<Scene> scene_in_file;  ///< none: there is no file, or it cannot be read, or it was changed since
        std::optional<Preset> preset_in_file;  ///< the same
        std::filesystem::path scene_file, preset_file;
        OnDisk scene_disk, preset_disk;  ///< the files as they were when they were last opened or saved
        bool scene_unsaved = false, preset_unsaved = false;
    };
    void recover(Recovered recovered);

    // --- changing --------------------------------------------------------------------------------------------------
    /// Between begin() and commit() any number of edits make one step. A gesture that is still open is committed first.
    /// A gesture that changes nothing leaves no step.
    void begin(std::string name);
    template <typename F>
    void edit(F&& change) {
        change(content_);
        touched();
    }
    void commit();
    void cancel();  ///< the document is again as it was at begin()
    bool in_gesture() const { return open_; }
    template <typename F>
    void change(std::string name, F&& change) {
        begin(std::move(name));
        edit(std::forward<F>(change));
        commit();
    }
    /// Applies what a widget reports in one frame (anything with the members of ui::Edit): it may begin, change, cancel
    /// and commit a gesture.
    template <typename Edit, typename F>
    void take(const Edit& widget, std::string_view name, F&& change) {
        if (widget.began) begin(std::string(name));
        if (widget.changed) {
            if (!open_) begin(std::string(name));
            edit(std::forward<F>(change));
        }
        if (widget.cancelled)
            cancel();
        else if (widget.committed)
            commit();
    }

    // --- history ---------------------------------------------------------------------------------------------------
    bool can_undo() const { return open_ || done_ > 0; }
    bool can_redo() const { return !open_ && done_ < steps_.size(); }
    void undo();  ///< while a gesture is open this is cancel()
    void redo();
    /// All steps, also those that were undone; the first done() of them are in effect.
    const std::vector<Step>& steps() const { return steps_; }
    std::size_t step_memory() const;  ///< bytes that steps take
    std::size_t done() const { return done_; }
    void go_to(std::size_t done);  ///< undoes or redoes until so many are in effect
    enum class Named { scene, preset };
    /// Renames the scene or preset in all steps as well, so that undoing them keeps the new name. It is no step itself.
    void rename(Named what, const std::string& name);

    // --- files -----------------------------------------------------------------------------------------------------
    /// The search path of clips. A clip that is in one of these folders is named without a folder wherever the preset
    /// is saved.
    void set_clip_folders(std::vector<std::filesystem::path> folders) { clip_folders_ = std::move(folders); }
    /// Makes `preset` one of another folder, with the same clips.
    void move(Preset& preset, const std::filesystem::path& folder) const;
    /// document::gather_clips() with the folder of the preset's file as `home`. Clips outside of it are allowed until
    /// the preset is saved: then the user is asked about them.
    void gather_clips(Preset& preset) const;
    const std::filesystem::path& scene_file() const { return scene_file_; }
    const std::filesystem::path& preset_file() const { return preset_file_; }
    bool scene_unsaved() const;  ///< the scene differs from what was opened or saved last
    bool preset_unsaved() const;
    bool unsaved() const { return scene_unsaved() || preset_unsaved(); }
    /// The documents as they were last opened or saved; null when there is no file or it could not be read. Each saving
    /// makes a new object, so pointers can be compared.
    const std::shared_ptr<const Scene>& saved_scene() const { return saved_scene_; }
    const std::shared_ptr<const Preset>& saved_preset() const { return saved_preset_; }
    /// Writes the file, reads it back, compares, and makes it the document's file. Paths in the document are made
    /// relative to the file's folder; a scene gets the preset's file as the one it opens with. An open gesture is
    /// committed first. Throws Error; then the document and its files are as before.
    void save_preset(const std::filesystem::path& file);
    void save_scene(const std::filesystem::path& file);
    /// The clips that a preset in this folder must not name because they are outside of it.
    std::vector<std::string> clips_outside(const std::filesystem::path& folder) const;
    /// The files as they were when they were last opened or saved.
    const OnDisk& scene_on_disk() const { return scene_disk_; }
    const OnDisk& preset_on_disk() const { return preset_disk_; }
    /// Takes the files as they are now as known, so that the next saving does not ask about them.
    void note_disk();
    /// The scene or preset no longer belongs to its file and counts as not saved.
    void forget_scene_file();
    void forget_preset_file();

    /// Takes over what another program wrote to the file. This is one undo step, and the document then counts as saved.
    void reload(Preset preset);
    void reload(Scene scene);

    /// What is wrong with the present values; places are JSON pointers.
    const std::vector<Fault>& preset_faults() const;
    std::vector<Fault> scene_faults() const;
    /// Whether undoing the last step takes this fault of the preset away: the fault came with it. `fault` is one of
    /// preset_faults(), or of a file that a value names.
    bool undo_mends(const Fault& fault) const;
    /// Whether the last step chose the scene's organ, or how it is read.
    bool undo_changes_organ() const;

  private:
    /// For each redo bit, the version in which something with this bit changed last.
    struct Changed {
        std::array<std::uint64_t, 32> at{};
        unsigned open = 0;  ///< bits of the rows that differ from the last step

        void note(unsigned differing, std::uint64_t version);
        unsigned since(std::uint64_t version) const;
    };
    void touched();
    void all_touched();
    void settle();
    void take_back();
    template <typename Apply>
    void step(Apply apply);
    void describe_again(std::string_view place);
    template <typename Part, typename Change>
    void sew(Part Content::*part, Delta Step::*delta, const Table& table, Change change);
    void forget_oldest();
    void forget_steps();
    std::string moved_clip(const std::string& file, const std::filesystem::path& from,
                           const std::filesystem::path& to) const;

    Content content_;
    Content settled_;  ///< the last step left it so; it differs from content_ in an open gesture only
    Changed scene_changed_, preset_changed_;
    std::vector<std::filesystem::path> clip_folders_;
    std::uint64_t version_ = 1;
    std::vector<Step> steps_;
    std::size_t done_ = 0;
    std::uint64_t last_step_ = 0;
    bool open_ = false;
    std::string name_;
    std::filesystem::path scene_file_, preset_file_;
    OnDisk scene_disk_, preset_disk_;
    std::shared_ptr<const Scene> saved_scene_;
    std::shared_ptr<const Preset> saved_preset_;
    mutable std::uint64_t compared_ = 0;  ///< the version for which scene_differs_ and preset_differs_ were found
    mutable std::shared_ptr<const Scene> compared_scene_;  ///< the documents that it was compared with
    mutable std::shared_ptr<const Preset> compared_preset_;
    mutable bool scene_differs_ = true, preset_differs_ = true;
    mutable std::uint64_t checked_ = 0;  ///< the version that preset_faults_ belongs to
    mutable std::vector<Fault> preset_faults_;
    void compare() const;
};

}  // namespace lapfx::document
