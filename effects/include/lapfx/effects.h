// The effects core: blood on an organ and smoke over the frame, for a host with an OpenGL 4.5 core context.
//
//     auto context = lapfx::Context::external(my_get_proc_address);          // the host's context, current
//     lapfx::Organ organ = lapfx::load_organ("stomach.glb");
//     lapfx::Effects effects(organ, lapfx::load_preset("tuned.json"), {.clip_folders = {"clips"}});
//
//     effects.set_contacts(contacts);          // whenever the tool does something; or push samples, see tool_queue.h
//     effects.seek(now);                       // once per frame; s, any order
//     effects.draw_organ(view);                // into the bound framebuffer, tested against its depth
//     effects.draw_smoke(view, depth_texture); // over the frame, when all else has been drawn
//
// Lengths mm, times s, organ space = the space of Organ::positions. One thread: that of the context.
// Constructor and set_preset throw lapfx::Error; seek and the draw calls are noexcept, allocate nothing in steady
// state and leave the GL state as they found it (program, vertex array, blending, depth, culling, texture units 0-1,
// uniform bindings 0-2). They expect GL's initial front face, colour mask, stencil, polygon mode and clip control, and
// no sampler objects on units 0 and 1. Output is linear light: draw into a float or an sRGB framebuffer with
// GL_FRAMEBUFFER_SRGB.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "lapfx/context.h"
#include "lapfx/error.h"
#include "lapfx/organ.h"
#include "lapfx/preset.h"
#include "lapfx/tool.h"
#include "lapfx/tool_queue.h"
#include "lapfx/view.h"

namespace lapfx {

struct EffectsOptions {
    std::uint32_t seed = 1;                           ///< all chance comes from it
    glm::dvec3 gravity{0.0, -1.0, 0.0};               ///< direction in organ space; blood runs down, smoke rises
    std::vector<std::filesystem::path> clip_folders;  ///< where bare clip names are looked up
    bool wait_for_clips = false;  ///< true: exact frames, for offline rendering; false: never wait, repeat the last
};

/// Amounts at the current time, without reading back from the GPU.
struct Amounts {
    double blood_area = 0.0;  ///< mm2 of organ surface whose bleed value is above the threshold
    int bleeding_wounds = 0;  ///< wounds that still grow
    double haze = 0.0;        ///< E, optical thickness at the focus distance
};

/// A point on the organ under a ray.
struct OrganHit {
    glm::dvec3 position{0.0};  ///< mm
    double distance = 0.0;     ///< mm from the ray's origin
};

class Effects {
  public:
    /// Uploads the organ and opens the preset's clips. Throws Error.
    Effects(const Organ& organ, const Preset& preset, const EffectsOptions& options = {});
    Effects(Effects&&) noexcept;
    Effects& operator=(Effects&&) noexcept;
    ~Effects();

    /// Live: the next frame shows it. Throws Error for a clip that cannot be used, and keeps the former
    /// preset.
    void set_preset(const Preset& preset);
    /// All contacts so far, past and running; what happened is a function of this list and the time.
    /// They take the place of what the tool queue has brought so far.
    void set_contacts(std::span<const ToolContact> contacts);
    /// Samples of a haptic thread; seek() takes what has come. Valid as long as the Effects that it came from, also when
    /// that is moved.
    ToolQueue& tool_queue() noexcept;
    /// What has happened so far: what was set, and what came through the queue since; for saving as a scene's events.
    /// Samples become contacts as effects/cautery/recorder.h says: a running contact grows, bad samples are dropped.
    /// Valid until the next seek() or set_contacts().
    std::span<const ToolContact> contacts() const noexcept;

    void seek(double time) noexcept;
    void draw_organ(const View& view) noexcept;
    /// `scene_depth`: a depth texture of the frame, the size of the viewport, not attached to the bound
    /// framebuffer.
    void draw_smoke(const View& view, unsigned scene_depth) noexcept;

    Amounts amounts() const noexcept;
    /// Where a ray first meets the organ. `direction` need not be unit.
    std::optional<OrganHit> pick(glm::dvec3 origin, glm::dvec3 direction) const noexcept;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace lapfx
