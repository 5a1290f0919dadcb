// The preview as the editor has it: it follows the document, and draws into a texture that the UI shows. The one place
// of the editor that draws effects; its pixels are those of `lapfx render`. Render thread, context current. No OpenGL
// in this header.
//
// Nothing here waits: organs are made ready and clips looked through by jobs, and what was shown before stays, live,
// until they are done.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/base/jobs.h"
#include "app/preview/driver_watch.h"
#include "app/preview/early_load.h"
#include "app/preview/held_tool.h"
#include "app/preview/target.h"
#include "document/document.h"
#include "lapfx/authoring/preview.h"
#include "lapfx/clip_cache.h"
#include "ui/draw/draw_list.h"

namespace lapfx::app {

/// What one picture shows; its size is that of resize().
struct Shot {
    double time = 0;  ///< s
    SceneCamera camera;
    Overlay overlay = Overlay::none;
    bool haze = true;  ///< false: it is left out
    double scale = 1;  ///< below 1: it is drawn with so much less width and height, and stretched
};

/// Another texture that it can be drawn into, of a size of its own, and what was drawn there last.
struct PreviewCopy {
    Target target;
    Shot shot;
    std::uint64_t revision = 0;  ///< the host's revision that was copied; 0: nothing yet
};

/// What is being loaded for the preview.
struct Loading {
    std::string name;      ///< "stomach.glb"
    double progress = -1;  ///< 0..1; negative: nobody knows
    const Job* job = nullptr;
};

class PreviewHost {
  public:
    /// `early`: what load_early() has begun, or null.
    PreviewHost(const PreviewOptions& options, Jobs& jobs, std::shared_ptr<EarlyLoad> early = nullptr);
    ~PreviewHost();
    PreviewHost(const PreviewHost&) = delete;
    PreviewHost& operator=(const PreviewHost&) = delete;

    /// Shows the document from the next draw() on, or when its files are loaded; with PreviewOptions::wait_for_clips
    /// this waits for them. Parts that cannot be shown (values that contradict each other, a clip or an organ that is
    /// missing) stay as they were before. All else is shown, and the faults below say what is wrong.
    void follow(const document::Document& document);
    /// From the next follow() on only this clip of the preset smokes, by its number; none: all do. The document does
    /// not know of it.
    void play_alone(std::optional<std::size_t> clip) { alone_ = clip; }
    const std::optional<std::size_t>& alone() const { return alone_; }
    /// Pictures have this size from now on, px; picture() is another texture then. Call it before the list that shows
    /// the picture is drawn.
    void resize(glm::ivec2 size);
    /// Draws if the picture would differ from the last one; gives whether it did. Nothing is drawn without an organ, or
    /// once the driver has failed.
    bool draw(const Shot& shot);
    /// The same into `copy`, whose target has a size.
    bool draw_into(PreviewCopy& copy, const Shot& shot);
    /// One picture of what is shown, as `change` makes it; what is shown stays. Values that take no other organ and no
    /// other clips. Only where can_try(): there is a preview of a scene without a fault, and no
    /// tool works in it.
    Image picture_with(const std::function<void(document::Content&)>& change, const Shot& shot, glm::ivec2 size);
    bool can_try() const { return preview_ && !driver_.lost() && !tool_.on() && !scene_fault_; }
    /// The shot of the last draw().
    const Shot& shown() const { return last_; }
    /// While time stands, a clip may still be late: whether another draw() could give a better picture.
    bool late() const;

    bool ready() const { return preview_ != nullptr; }
    /// The picture of the last draw(); 0: none yet. Texture name of the UI's renderer.
    ui::ImageHandle picture() const;
    glm::ivec2 size() const;
    /// Read back: what the texture holds.
    Image read() const { return target_.read(); }
    /// The same for those that ask in each frame: read back, which waits for the GPU, once for each picture. Valid
    /// until the next draw() or resize().
    const Image& pixels();
    std::uint64_t read_back() const { return read_back_; }  ///< how many pictures pixels() has read

    // --- loading -----------------------------------------------------------------------------------------------------
    /// What is on its way: an organ, else clips; none when all is there.
    std::optional<Loading> loading() const;
    void cancel_loading();  ///< what was shown stays; the document, which asks for another, does too
    /// Reads again what has changed on disk: clips that these paths name (empty: all), the organ with all that belongs
    /// to it. What cannot be read leaves what is shown.
    void reload_clips(const std::vector<std::filesystem::path>& changed = {});
    void reload_organ();
    /// A clip's file has gone: it plays on as it is known, and the next change of the preset looks for it and tells.
    void look_for_clips() { clips_shown_ = false; }
    /// Compiles the shaders of this folder. Throws Error, with file and line, and keeps those that it had.
    void reload_shaders(const std::filesystem::path& folder);
    /// Files that the picture is made of: where clips are or would be, the organ's with textures and tool.
    std::vector<std::filesystem::path> clip_files(const Preset& preset) const;
    std::vector<std::filesystem::path> organ_files(const Scene& scene) const;

    // --- what is wrong -----------------------------------------------------------------------------------------------
    /// What keeps the document from being shown: of the preset and its clips, and of the organ.
    const std::vector<Fault>& preset_faults() const { return preset_faults_; }
    const std::vector<Fault>& organ_faults() const { return organ_faults_; }
    /// Looks, at most once a second and only when there was something to draw, whether the driver still works. Gives a
    /// fault the first time that it does not; then nothing is drawn any more. `now`: s.
    std::optional<Fault> check_driver(double now) { return driver_.check(now); }
    bool lost() const { return driver_.lost(); }

    /// Bytes of the preview and of the picture that it is drawn into.
    MemoryUse memory_use() const;
    std::size_t memory() const { return memory_use().total(); }

    /// The facts about clips. Another preview that uses this cache does not examine them again.
    const std::shared_ptr<ClipCache>& clip_cache() const { return options_.clip_cache; }
    /// The organ of this scene as it is shown, for others that work on it; null while it is not loaded or another one
    /// is shown.
    std::shared_ptr<const PreparedOrgan> organ_of(const Scene& scene) const;
    /// Grows whenever another one is shown, or why there is none.
    std::uint64_t organ_version() const { return organ_version_; }

    /// Null before the first organ is there. Do not draw with it.
    Preview* preview() { return preview_.get(); }
    const Preview* preview() const { return preview_.get(); }

    // --- a tool in the hand ------------------------------------------------------------------------------------------
    /// Puts the tip on the organ at `place` from `time` on. The preview shows its effect; the document does not contain
    /// it yet.
    void put_tool(ToolAction action, double power, double strength, double time, glm::dvec3 place);
    void move_tool(double time, glm::dvec3 place);  ///< straight from where it was, at 100 Hz
    /// What it has done since put_tool(): contacts for the scene's events.
    std::vector<ToolContact> take_tool_off(double time);
    bool tool_on() const { return tool_.on(); }

  private:
    void load_organ();
    void keep_organ();
    bool show(const std::shared_ptr<const PreparedOrgan>& organ);
    void take_preset(const document::Document& document, unsigned changed);
    void follow_preset();
    void follow_scene();
    void look_through_clips();
    void examine_again();
    const Preset& shown_preset() const { return shows_wanted_ ? wanted_.preset : good_; }
    void show_wanted(unsigned changed);
    void show_parameters(const Preset& preset);
    bool draw_into(const Target& target, const Shot& shot, Shot& last, std::uint64_t& drawn);
    void draw_stretched(const Target& target, const Shot& shot);

    PreviewOptions options_;
    Jobs& jobs_;
    std::shared_ptr<EarlyLoad> early_;
    std::shared_ptr<Job> organ_job_, clips_job_;
    std::shared_ptr<const PreparedOrgan> organ_;  ///< that is shown
    std::uint64_t organ_version_ = 0;
    std::unique_ptr<Preview> preview_;
    Target target_, small_, tried_;     ///< the one that is shown; the one that is stretched to it; of picture_with()
    std::uint64_t followed_ = 0;        ///< version of the document
    document::Content wanted_;          ///< of that
    std::vector<Fault> wanted_faults_;  ///< of its preset
    std::optional<std::size_t> alone_, wanted_alone_;   ///< the clip that smokes alone; as it is in wanted_
    bool stale_ = false;                                ///< it has to be examined again
    std::shared_ptr<const PreparedOrgan> ready_organ_;  ///< to be shown
    std::optional<Scene> shown_scene_;                  ///< none: it has to be examined again
    bool clips_shown_ = false;                          ///< all of its clips, and it breaks no rule
    bool preset_due_ = true;                            ///< it has to be shown, or to be examined again
    bool shows_wanted_ = false;                         ///< that preset, as it is
    Preset good_;                                       ///< else: that was shown last; it breaks no rule
    std::optional<unsigned> differ_;    ///< redo bits of what the wanted one has and good_ has not; none: not known
    std::optional<Scene> asked_scene_;  ///< of the organ that was asked for last
    std::vector<std::filesystem::path> opening_;  ///< clips that are being examined
    std::vector<std::filesystem::path> organ_files_;
    std::vector<Fault> preset_faults_, organ_faults_;
    bool scene_fault_ = false;  ///< organ_faults_ are about the scene as it is, not about its file
    bool changed_ = true;
    std::uint64_t revision_ = 1, drawn_ = 0;  ///< the revision of what it shows beside the shot; the one in the target
    Image pixels_;                            ///< of the target, where pixels_known_
    bool pixels_known_ = false;
    std::uint64_t read_back_ = 0;
    Shot last_;
    Overlay overlay_ = Overlay::none;  ///< that the preview has

    DriverWatch driver_;
    HeldTool tool_;
};

}  // namespace lapfx::app
