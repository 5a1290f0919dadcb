// A scene as a picture: what `lapfx render` and the editor's viewport show. One scene, preset, seed, size and time
// always give the same pixels, also when a host draws them with Effects (samples/host/host.cpp).
//
//     auto context = lapfx::Context::create(lapfx::Backend::automatic);
//     lapfx::Preview preview(scene, preset, {.clip_folders = {"samples/clips"}, .wait_for_clips = true});
//     lapfx::Image image = preview.image(6.0, {1280, 1024});
//
// Render thread only, context current. draw() binds its own framebuffers, programs and textures and leaves them bound:
// a host that needs its state uses Effects, which restores everything.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "lapfx/authoring/prepared_scene.h"
#include "lapfx/effects.h"
#include "lapfx/scene.h"

namespace lapfx {

struct PreviewOptions {
    std::vector<std::filesystem::path> clip_folders;
    bool wait_for_clips = false;
    Overlay overlay = Overlay::none;
    StreamingOptions streaming = {};
    std::shared_ptr<ClipCache> clip_cache = nullptr;
};

/// What is in the pixels of a frame, exactly: for measures that have to be checked. Rows from the top.
struct Layers {
    std::vector<std::uint8_t> view;   ///< 255 within the round view, not on an instrument; all 0 if no organ is seen
    std::vector<std::uint8_t> blood;  ///< 255 where blood changes the light of the tissue by more than a tenth, else 0
    std::vector<float> veil;          ///< 1 - transmission of the smoke, mean of the three colours, 0..1
};

/// The amounts that are matched with those of a video: what measuring a frame should find.
struct ShownAmounts {
    double blood = 0.0;  ///< share of the view that is blood, 0..1
    double veil = 0.0;   ///< mean over the view, in linear light, 0..1
    double view = 0.0;   ///< share of the picture that is the view; the others are 0 where it is
};
ShownAmounts amounts_of(const Layers& layers);

class Preview {
  public:
    /// Loads the scene's organ and tool and the preset's clips. Throws Error.
    Preview(const Scene& scene, const Preset& preset, const PreviewOptions& options = {});
    /// The same with an organ that prepare_organ(scene, ...) has prepared: only sending it to the GPU and opening the
    /// clips remain. Throws Error (bad_input) when it was prepared for another scene.
    Preview(const Scene& scene, const Preset& preset, std::shared_ptr<const PreparedOrgan> organ,
            const PreviewOptions& options);
    Preview(Preview&&) noexcept;
    Preview& operator=(Preview&&) noexcept;
    ~Preview();

    /// Draws the frame at `time` into `framebuffer` (0 = the window's), filling `size` pixels, sRGB-encoded.
    void draw(double time, glm::ivec2 size, unsigned framebuffer = 0);
    /// The same, read back. Throws Error (runtime) when the driver cannot make the frame.
    Image image(double time, glm::ivec2 size);
    /// The layers of that image, without the camera's response. Blood and veil are given beyond the view as well. Draws
    /// the frame six times. Throws Error (runtime) as image().
    Layers layers(double time, glm::ivec2 size);

    void set_preset(const Preset& preset);
    void set_parameters(const Preset& preset);  ///< as Effects::set_parameters
    void set_parameters(const Preset& preset, unsigned changed);
    /// Changes colour of the organ, camera, light, gravity, seed, events and port of the tool. The next frame is that
    /// of a new Preview of this scene. Throws Error (bad_input), and changes nothing, when gravity has no direction or
    /// when organ or tool differ: those need a new Preview.
    void set_scene(const Scene& scene);
    /// Whether set_scene() accepts this scene: organ and tool are the same.
    bool takes(const Scene& scene) const;
    void reload_shaders(const std::filesystem::path& folder);  ///< as Effects::reload_shaders
    void set_overlay(Overlay overlay);
    void set_camera(const SceneCamera& camera);
    void set_haze_shown(bool shown);  ///< false: pictures leave it out, and amounts() do not
    void set_curves(const Curves& curves);
    /// These work as in Effects: all contacts at once, or samples of a tool as it moves, and what has happened so far.
    void set_contacts(std::span<const ToolContact> contacts);
    ToolQueue& tool_queue();
    std::span<const ToolContact> contacts() const;
    const SceneCamera& camera() const;
    const Organ& organ() const;  ///< like PreparedOrgan::organ(): its images have sizes but no pixels
    Amounts amounts() const;
    std::span<const ClipStatus> clips() const;  ///< as Effects::clips
    StreamingTimes streaming_times() const;
    bool late() const;  ///< as Effects::late
    /// Memory of the Effects, of the targets that are drawn into, of the instrument, and of the organ's data, which may
    /// be shared.
    MemoryUse memory_use() const;
    std::size_t memory() const { return memory_use().total(); }
    TissueSample tissue(const glm::dvec3& position) const;  ///< as Effects::tissue

    /// The point of the organ under a pixel (origin top left) of a frame of `size`.
    std::optional<OrganHit> pick(glm::dvec2 pixel, glm::ivec2 size) const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace lapfx
