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
// A host that has an organ shader of its own draws the organ itself and puts lapfx's blood into that shader:
//
//     const std::string text = "#version 450 core\n" + lapfx::bleeding_shader() + my_fragment_shader;  // see there
//     glVertexArrayVertexBuffer(my_vertex_array, 5, effects.bleed_buffer(), 0, sizeof(glm::vec2));
//     effects.bind_bleeding();  // then draw, instead of draw_organ
//     effects.draw_clips(view);
//
// samples/host/host.cpp is a whole program that does so. It draws refine(organ): where triangles are longer than 4.5 mm
// (refine.h), Effects splits them for itself.
//
// Lengths mm, times s, organ space = the space of Organ::positions. One thread: that of the context.
// Constructor and set_preset throw lapfx::Error; seek and the draw calls are noexcept, allocate nothing in steady
// state (while blood spreads or samples arrive they may; out of memory then ends the process) and leave the GL state as
// they found it (program, vertex array, blending, depth, culling, scissor test, draw framebuffer, viewport, 2D and 2D
// array textures of units 0-13, uniform bindings 0-2). They expect GL's initial front face, colour mask, stencil,
// polygon mode and clip control, no sampler objects on units 0 to 13, one draw buffer, and blending and scissor test
// the same for all draw buffers and viewports: they are saved as those of the first and put back for all. Output is
// linear light: draw into a float or an sRGB framebuffer with GL_FRAMEBUFFER_SRGB.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "lapfx/amounts.h"
#include "lapfx/context.h"
#include "lapfx/curves.h"
#include "lapfx/error.h"
#include "lapfx/memory.h"
#include "lapfx/organ.h"
#include "lapfx/preset.h"
#include "lapfx/streaming.h"
#include "lapfx/tissue.h"
#include "lapfx/tool.h"
#include "lapfx/tool_queue.h"
#include "lapfx/view.h"
#include "lapfx/wound.h"

namespace lapfx {

class ClipCache;
class PreparedOrgan;

struct EffectsOptions {
    std::uint32_t seed = 1;                           ///< all chance comes from it
    glm::dvec3 gravity{0.0, -1.0, 0.0};               ///< direction in organ space; blood runs down, smoke rises
    std::vector<std::filesystem::path> clip_folders;  ///< where bare clip names are looked up
    bool wait_for_clips = false;  ///< true: exact frames, for offline rendering; false: never wait, repeat the last
    StreamingOptions streaming = {};
    std::shared_ptr<ClipCache> clip_cache = nullptr;  ///< what is known of clips already (clip_cache.h); may be null
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
    /// The same with an organ that was prepared on another thread (prepared_organ.h): it has to be sent to the GPU.
    /// Textures that another Effects has sent before are decoded once more, and densities are found again for other
    /// vessels than it was prepared for.
    Effects(std::shared_ptr<const PreparedOrgan> organ, const Preset& preset, const EffectsOptions& options = {});
    Effects(Effects&&) noexcept;
    Effects& operator=(Effects&&) noexcept;
    ~Effects();

    /// Live: the next frame shows it. Throws Error for a clip that cannot be used, and keeps the previous
    /// preset.
    void set_preset(const Preset& preset);
    /// The same, but the clips that play go on: none is opened or let go, and those of the preset that have another
    /// file are not heard of. For a preset whose clips are not there, or not yet (clip_cache.h).
    void set_parameters(const Preset& preset);
    /// As in EffectsOptions, for all that has happened and will: blood runs again from its wounds. Blood that
    /// set_topology() had taken over is gone then. set_gravity throws Error (bad_input) for a vector without direction.
    void set_gravity(const glm::dvec3& gravity);
    void set_seed(std::uint32_t seed);
    /// All contacts so far, past and running; what happened is a function of this list and the time.
    /// They take the place of what the tool queue has brought so far.
    void set_contacts(std::span<const ToolContact> contacts);
    /// Factors over time on cautery power, bleeding and smoke; none at first. Also on what has happened already. A
    /// simulator leaves them alone.
    void set_curves(const Curves& curves);
    /// Samples of a haptic thread; seek() takes what has come. Valid as long as the Effects that it came from, also
    /// when that is moved.
    ToolQueue& tool_queue() noexcept;
    /// What has happened so far: what was set, and what came through the queue since; for saving as a scene's events.
    /// Samples become contacts as effects/tool/recorder.h says: a running contact grows, bad samples are dropped.
    /// Valid until the next seek() or set_contacts().
    std::span<const ToolContact> contacts() const noexcept;

    /// The organ moves: new positions, mm, and unit normals for every vertex of the organ (empty: smooth ones are
    /// made), same connectivity. Of a coarse organ (refine.h) those that it was given with: the others stay midway
    /// between them. Blood, burns and wounds stay on the tissue: distances, areas and contacts are those of the rest
    /// shape, what is drawn and picked is the moved one. O(vertices), no allocation after the first call. Sizes must
    /// fit (assert).
    void set_shape(std::span<const glm::vec3> positions, std::span<const glm::vec3> normals = {});
    /// A place on the moved shape, carried back to the rest shape: where a contact there belongs. Unmoved, the place
    /// itself.
    glm::dvec3 to_rest(const glm::dvec3& place) const noexcept;

    /// The organ has been cut: another surface takes its place, at rest, with the materials and textures of `organ`.
    /// Images that have a size and no pixels, such as PreparedOrgan::organ()'s, have those of the former organ's image
    /// of the same index, name and size; where there is none they are white, or flat. `origin[v]`: the vertex of the
    /// former organ that vertex v was, or `new_vertex`. Blood that lies on surviving vertices stays there until it is
    /// cleared, and clots with the wounds of that time; wounds and burns stay at their places, and blood spreads on
    /// over the new surface. Time before this call shows the new surface, with the blood that would have spread over
    /// it. Rebuilds what depends on the mesh (as long as the constructor took); buffer names change. Throws Error
    /// (runtime); then the former organ stays.
    void set_topology(const Organ& organ, std::span<const std::uint32_t> origin);
    static constexpr std::uint32_t new_vertex = 0xffffffff;

    /// For tools, while shaders are worked on: compiles all programs from the files in `folder`, and what is not there
    /// from those that were built in; then they take the place of the former ones, also for every Effects that is made
    /// later in this process. Throws Error (runtime) with file and line, and changes nothing.
    void reload_shaders(const std::filesystem::path& folder);

    /// Multiplies the organ's own colours where draw_organ() shows tissue; sRGB, white at first. For a mesh without
    /// colours. What the density of vessels and fat is found in stays as it was loaded.
    void set_organ_color(const glm::dvec3& color);

    /// Draws false colour over the tissue from the next frame on; Overlay::none at first. Uploads what it needs.
    void set_overlay(Overlay overlay);

    void seek(double time) noexcept;
    void draw_organ(const View& view) noexcept;
    /// The metal clips on the tissue (ToolAction::clip), lit and tested against the depth; for a host that draws the
    /// organ itself. draw_organ() draws them, too.
    void draw_clips(const View& view) noexcept;
    /// `scene_depth`: a depth texture of the frame, the size of the viewport, not attached to the bound
    /// framebuffer.
    void draw_smoke(const View& view, unsigned scene_depth) noexcept;

    /// For a host's own organ shader: the GL buffer of bleed value (mm; below 0 it runs on, for the noise) and clot
    /// (0..1), a vec2 per organ vertex in the order of Organ::positions; after them, those that refine() adds to a
    /// coarse organ. seek() updates it. The name is valid until set_topology() or the end of this object; do not write
    /// to it.
    unsigned bleed_buffer() const noexcept;
    /// Binds the uniform block that bleeding_shader() reads at uniform binding 1, and leaves it there: unlike the draw
    /// calls it changes the host's state, as it is meant to.
    void bind_bleeding() const noexcept;

    /// At the current time.
    Amounts amounts() const noexcept;
    /// Every wound of the contacts, with what it was doing at the last seek(); those of contacts that are yet to come
    /// are waiting. Valid until the next call that is not const.
    std::span<const WoundStatus> wounds() const noexcept;
    /// The smoke clips of the preset, in its order, and what playing them has cost so far (streaming.h).
    std::vector<ClipStatus> clips() const;
    StreamingTimes streaming_times() const noexcept;
    /// Whether the last draw_smoke() had to show an older frame of a clip than the one that was due (never if it waits
    /// for clips): drawing the same time again then gives a better picture.
    bool late() const noexcept;
    /// Bytes of main memory and of the GPU, by what they are for; and all of them.
    MemoryUse memory_use() const noexcept;
    std::size_t memory() const noexcept { return memory_use().total(); }
    /// Bytes that the last seek sent to the GPU.
    std::size_t uploaded() const noexcept;
    /// The tissue around the place of the organ nearest to `position`, mm: means over the preset's region of influence
    /// (paper: figure 9). Both 0 for NaN or infinite coordinates. About 0.1 ms.
    TissueSample tissue(const glm::dvec3& position) const noexcept;
    /// Where a ray first meets the organ. `direction` need not be unit.
    std::optional<OrganHit> pick(glm::dvec3 origin, glm::dvec3 direction) const noexcept;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

/// The bleeding shader as one text for a host's fragment shader: paste it after #version (420 core or
/// later) and before use. It holds no #version and no #include, and every name in it begins with
/// lapfx_, Lapfx or u_blood_. The host calls, in uniform control flow,
///
///     LapfxBlood blood = lapfx_blood(bleed_and_clot, vec3(0.0), rest_position, normal);  // mm, unit, organ space
///     albedo = mix(albedo, blood.color, blood.coverage * blood.opacity);                 // linear light
///     normal = normalize(normal - blood.coverage * blood.slope);
///
/// and may use blood.gloss, clot, depth and level. Throws Error (runtime) when a shader folder that the editor set
/// lacks a file. Any thread. (Paper: "Simulation of bleeding", figure 6: "the bleeding code was integrated into the
/// existing shader".)
std::string bleeding_shader();

}  // namespace lapfx
