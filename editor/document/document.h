// What is edited: a scene and a preset, with everything that was done to them. No UI, no OpenGL.
//
//     document.change("Speed", [](Content& c) { c.preset.bleeding.speed = 6; });  // one undo step
//     document.take(edit, "Speed", [&](Content& c) { c.preset.bleeding.speed = speed; });  // a widget's gesture: one step
//     document.undo();
//
// A step is the whole content before and after: both are small, and undo is then as simple as it can be. Values may break a
// rule between them while they are edited (faults()); they are kept, and told. UI thread.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
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

/// Whether both would be written as the same files.
bool same(const Content& a, const Content& b);

/// One thing that was done.
struct Step {
    std::string name;  ///< "Speed", "Move event"
    Content before, after;
};

class Document {
  public:
    static constexpr std::size_t most_steps = 500;

    const Content& content() const { return content_; }
    const Scene& scene() const { return content_.scene; }
    const Preset& preset() const { return content_.preset; }
    /// Grows with every change, also undone ones; for those who follow.
    std::uint64_t version() const { return version_; }

    /// Another content from these files (empty: none yet); what was done before is forgotten.
    void open(Content content, std::filesystem::path scene_file = {}, std::filesystem::path preset_file = {});

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
    std::size_t done() const { return done_; }
    void go_to(std::size_t done);  ///< undoes or redoes until so many are in effect

    // --- files -----------------------------------------------------------------------------------------------------
    const std::filesystem::path& scene_file() const { return scene_file_; }
    const std::filesystem::path& preset_file() const { return preset_file_; }
    bool scene_unsaved() const;  ///< differs from what was opened or saved
    bool preset_unsaved() const;
    bool unsaved() const { return scene_unsaved() || preset_unsaved(); }
    /// Write, and note the file. Throw Error; then nothing changes but an open gesture, which is committed. Paths in them are
    /// made to fit the new folder.
    void save_preset(const std::filesystem::path& file);
    void save_scene(const std::filesystem::path& file);

    /// As it is on disk now: one undo step, and what is on disk counts as saved.
    void reload(Preset preset);
    void reload(Scene scene);

    /// What is wrong with the values as they are; places are JSON pointers. Of a preset, of a scene.
    std::vector<Fault> preset_faults() const;
    std::vector<Fault> scene_faults() const;

  private:
    void touched() { ++version_; }
    void set(const Content& content);

    Content content_;
    std::uint64_t version_ = 1;
    std::vector<Step> steps_;
    std::size_t done_ = 0;
    bool open_ = false;
    std::string name_;
    Content before_;
    std::filesystem::path scene_file_, preset_file_;
    std::string saved_scene_, saved_preset_;  ///< their texts
    mutable std::uint64_t compared_ = 0;      ///< version for which the two below hold
    mutable bool scene_differs_ = false, preset_differs_ = false;
    void compare() const;
};

}  // namespace lapfx::document
