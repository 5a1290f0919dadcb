// What is edited: a scene and a preset, with everything that was done to them. No UI, no OpenGL.
//
//     document.change("Speed", [](Content& c) { c.preset.bleeding.speed = 6; });  // one undo step
//     document.take(edit, "Speed", [&](Content& c) { c.preset.bleeding.speed = speed; });  // a gesture: one step
//     document.undo();
//
// A step is the whole content before and after, which makes undo as simple as it can be; steps share what they have in
// common. Files are named from the folder that the scene or the preset has, and both are one value: nothing but writing
// a file names them anew. Values may break a rule between them while they are edited (faults()); they are kept, and
// told. UI thread.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lapfx/preset.h"
#include "lapfx/scene.h"

namespace lapfx::document {

struct Content {
    Scene scene;
    Preset preset;
};

/// Whether both would be written as the same files; clips are the same when their files are, however each names them.
bool same(const Content& a, const Content& b);
bool same(const Preset& a, const Preset& b);

/// `wanted` without what breaks a rule: such values, or where that is not enough all of their group, are as in `good`,
/// which breaks none; so is a clip that `good` has in the same place, and others are left out. For showing all that can
/// be shown.
Preset mended(Preset wanted, const Preset& good);

/// What lies on the disk under a document's name, to tell when another program has written there.
struct OnDisk {
    bool exists = false;
    std::uint64_t hash = 0;  ///< of its bytes
    friend bool operator==(const OnDisk&, const OnDisk&) = default;

    /// As it is now. What cannot be read counts as not there.
    static OnDisk of(const std::filesystem::path& file);
};

/// The document `file` is written to lies in this folder.
std::filesystem::path folder_of(const std::filesystem::path& file);
/// How a document in `to` has to name what one in `from` calls `file`. Names without a folder are looked up on the
/// search path and stay what they are unless the file lies beside the old document.
std::string moved_path(const std::string& file, const std::filesystem::path& from, const std::filesystem::path& to);
/// The file of a clip that a preset in this folder names, symbolic links followed; its name where no such file lies
/// there. Looks at the disk.
std::filesystem::path real_clip(const std::string& file, const std::filesystem::path& folder);
/// Names all clips, some of which may be whole paths, from one folder that holds them, symbolic links followed: `home`
/// if it does, else the preset's own, else the deepest. Those in `shipped`, the folders of the search path, get bare
/// names.
void gather_clips(Preset& preset, const std::filesystem::path& home, const std::vector<std::filesystem::path>& shipped);

/// A content that is kept: scene and preset may be those of other steps.
struct KeptContent {
    std::shared_ptr<const Scene> scene;
    std::shared_ptr<const Preset> preset;
    Content copy() const { return {.scene = *scene, .preset = *preset}; }
};

/// One thing that was done.
struct Step {
    std::uint64_t id = 0;  ///< no other step of this document has it
    std::string name;      ///< "Speed", "Move event"
    KeptContent before, after;
};

class Document {
  public:
    /// What goes beyond either is forgotten, the oldest first; the newest step never is.
    static constexpr std::size_t most_steps = 500, most_step_bytes = std::size_t{32} << 20;

    /// An empty one, of which nothing would be lost.
    Document();
    const Content& content() const { return content_; }
    const Scene& scene() const { return content_.scene; }
    const Preset& preset() const { return content_.preset; }
    /// Grows with every change, also undone ones; for those who follow.
    std::uint64_t version() const { return version_; }

    /// Another content from these files (empty: none yet), whose folders become absolute; what was done before is
    /// forgotten.
    void open(Content content, std::filesystem::path scene_file = {}, std::filesystem::path preset_file = {});
    /// Another preset on the same scene; whether that one is saved stays what it is.
    void open_preset(Preset preset, std::filesystem::path preset_file = {});
    /// What was kept of an editor that ended before all was saved: what was not still is not. It is one undo step after
    /// what lies in the files, as far as that is known, so that it is seen what would be lost.
    struct Recovered {
        Content content;
        std::optional<Scene> scene_in_file;  ///< none: there is no file, or it cannot be read, or it was changed since
        std::optional<Preset> preset_in_file;  ///< the same
        std::filesystem::path scene_file, preset_file;
        OnDisk scene_disk, preset_disk;  ///< what lay there when it was opened or saved last
        bool scene_unsaved = false, preset_unsaved = false;
    };
    void recover(Recovered recovered);

    // --- changing --------------------------------------------------------------------------------------------------
    /// A gesture that is open already is committed first. Without any change no step is left.
    void begin(std::string name);
    template <typename F>
    void edit(F&& change) {
        change(content_);
        touched();
    }
    void commit();
    void cancel();  ///< as it was at begin()
    bool in_gesture() const { return open_; }
    template <typename F>
    void change(std::string name, F&& change) {
        begin(std::move(name));
        edit(std::forward<F>(change));
        commit();
    }
    /// A gesture of a widget (anything with ui::Edit's members), in the order in which its parts belong.
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
    void undo();  ///< an open gesture is given up
    void redo();
    /// Steps done and undone; the first done() of them are in effect.
    const std::vector<Step>& steps() const { return steps_; }
    std::size_t step_memory() const;  ///< bytes that steps take
    std::size_t done() const { return done_; }
    void go_to(std::size_t done);  ///< undoes or redoes until so many are in effect
    enum class Named { scene, preset };
    /// Called so from now on, in what was done and undone as well: it is no step, and undoing others keeps the name.
    void rename(Named what, const std::string& name);

    // --- files -----------------------------------------------------------------------------------------------------
    /// Where bare names of clips are looked up: a clip that lies there is named so, wherever the preset goes.
    void set_clip_folders(std::vector<std::filesystem::path> folders) { clip_folders_ = std::move(folders); }
    /// The same preset for another folder: its clips are found from there.
    void move(Preset& preset, const std::filesystem::path& folder) const;
    /// The same, from where the preset's file lies if that folder holds them. What lies outside of it is asked about
    /// when the preset is saved.
    void gather_clips(Preset& preset) const;
    const std::filesystem::path& scene_file() const { return scene_file_; }
    const std::filesystem::path& preset_file() const { return preset_file_; }
    bool scene_unsaved() const;  ///< differs from what was opened or saved
    bool preset_unsaved() const;
    bool unsaved() const { return scene_unsaved() || preset_unsaved(); }
    /// As they were opened or saved; null: they have no file, or it could not be read. Another one is another pointer.
    const std::shared_ptr<const Scene>& saved_scene() const { return saved_scene_; }
    const std::shared_ptr<const Preset>& saved_preset() const { return saved_preset_; }
    /// Write, load back, compare, and note the file. Throw Error; then nothing changes but an open gesture, which is
    /// committed. Paths in them are made to fit the new folder; a scene names the preset's file as the one it opens
    /// with.
    void save_preset(const std::filesystem::path& file);
    void save_scene(const std::filesystem::path& file);
    /// Clips that a preset in this folder could not name, because they lie outside of it.
    std::vector<std::string> clips_outside(const std::filesystem::path& folder) const;
    /// As it was when it was opened or saved.
    const OnDisk& scene_on_disk() const { return scene_disk_; }
    const OnDisk& preset_on_disk() const { return preset_disk_; }
    /// What lies there now is known and meant: the next saving does not ask.
    void note_disk();
    /// Left behind: they become documents without a file, which are not saved.
    void forget_scene_file();
    void forget_preset_file();

    /// As it is on disk now: one undo step, and what is on disk counts as saved and known.
    void reload(Preset preset);
    void reload(Scene scene);

    /// What is wrong with the values as they are; places are JSON pointers. Of a preset, of a scene.
    std::vector<Fault> preset_faults() const;
    std::vector<Fault> scene_faults() const;

  private:
    void touched() { ++version_; }
    void set(const Content& content);
    KeptContent kept(const Content& content, const KeptContent* like) const;
    void forget_oldest();
    void forget_steps();
    std::string moved_clip(const std::string& file, const std::filesystem::path& from,
                           const std::filesystem::path& to) const;

    Content content_;
    std::vector<std::filesystem::path> clip_folders_;
    std::uint64_t version_ = 1;
    std::vector<Step> steps_;
    std::size_t done_ = 0;
    std::uint64_t last_step_ = 0;
    bool open_ = false;
    std::string name_;
    Content before_;
    std::filesystem::path scene_file_, preset_file_;
    OnDisk scene_disk_, preset_disk_;
    std::shared_ptr<const Scene> saved_scene_;
    std::shared_ptr<const Preset> saved_preset_;
    mutable std::uint64_t compared_ = 0;  ///< version for which the two below hold
    mutable bool scene_differs_ = false, preset_differs_ = false;
    void compare() const;
};

}  // namespace lapfx::document
