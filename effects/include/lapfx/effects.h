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
// A host with its own organ shader draws the organ itself and adds lapfx's blood to that shader:
//
//     const std::string text = "#version 450 core\n" + lapfx::bleeding_shader() + my_fragment_shader;  // see there
//     glVertexArrayVertexBuffer(my_vertex_array, 5, effects.bleed_buffer(), 0, sizeof(glm::vec2));
//     effects.bind_bleeding();  // then draw, instead of draw_organ
//     effects.draw_metal_clips(view);
//
// samples/host/host.cpp (installed below share/lapfx) is a whole program that does so, samples/host/vtk.cpp is one in
// VTK. They draw refine(organ): where triangles are longer than 2 mm (refine.h), Effects splits them for itself.
//
// CMake: find_package(lapfx COMPONENTS effects), target lapfx::effects; or pkg-config lapfx, with C++20 and GLM.
//
// Lengths mm, times s, organ space = the space of Organ::positions. One thread: that of the context. Constructor and
// set_preset throw lapfx::Error; seek and the draw calls are noexcept, allocate nothing in steady state (while blood
// spreads or samples arrive they may; out of memory then ends the process) and leave the GL state as they found it
// (program, vertex array, blending, depth, culling, scissor test, draw framebuffer, viewport, 2D and 2D array textures
// of units 0-13, uniform bindings 0-2). They expect GL's initial front face, colour mask, stencil, polygon mode and
// clip control, no sampler objects on units 0 to 13, one draw buffer, and the same blending and scissor test for all
// draw buffers and viewports: lapfx saves those of the first one and restores them for all. Output is linear light:
// draw into a float or an sRGB framebuffer with GL_FRAMEBUFFER_SRGB. A frame whose texture holds sRGB without saying so
// (VTK's) is copied into one that says so and back, glCopyImageSubData.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "lapfx/amounts.h"
#include "lapfx/api.h"
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
    std::uint32_t seed = 1;                                ///< every random choice depends on it alone
    glm::dvec3 gravity{0.0, -1.0, 0.0};                    ///< direction in organ space; blood runs down, smoke rises
    std::vector<std::filesystem::path> clip_folders = {};  ///< where bare clip names are looked up
    bool wait_for_clips = false;  ///< true: exact frames, for offline rendering; false: never wait, repeat the last
    StreamingOptions streaming = {};
    std::shared_ptr<ClipCache> clip_cache = nullptr;  ///< what was read of clips before (clip_cache.h); may be null
};

/// A point on the organ under a ray.
struct OrganHit {
    glm::dvec3 position{0.0};  ///< mm
    double distance = 0.0;     ///< mm from the ray's origin
};

class LAPFX_API Effects {
  public:
    /// Uploads the organ and opens the preset's clips, in the context that is current. Throws Error; no_gl if none is.
    Effects(const Organ& organ, const Preset& preset, const EffectsOptions& options = {});
    /// The same with an organ that was prepared on another thread (prepared_organ.h); mip levels and sending it to the
    /// GPU remain, and take long: while frames are drawn, set_organ() brings another one. Textures that another Effects
    /// has already sent are decoded again. Densities are computed again when the preset has other vessel parameters
    /// than the organ was prepared with.
    Effects(std::shared_ptr<const PreparedOrgan> organ, const Preset& preset, const EffectsOptions& options = {});
    Effects(Effects&&) noexcept;
    Effects& operator=(Effects&&) noexcept;
    ~Effects();

    /// Live: the next frame shows it as if it had been so from the start, so that blood which has spread already
    /// changes at once (from one moment on: set_curves()). Throws Error for a clip that cannot be used, and keeps the
    /// previous preset.
    void set_preset(const Preset& preset);
    /// The same, but the clips that play continue: none is opened or closed, and clips of the preset with another file
    /// are ignored. This is for a preset whose clips do not exist, or have not been read yet (clip_cache.h).
    void set_parameters(const Preset& preset);
    /// The same for a caller that knows what has changed since the last call of this or of set_preset(): the redo bits
    /// of the rows whose values differ (parameter.h). Nothing is compared, and only that is done again. Too many bits
    /// cost time; too few show something else.
    void set_parameters(const Preset& preset, unsigned changed);
    /// What is shown: the parameters in use, with the clips that play. Name, description and folder are empty.
    Preset preset() const;
    /// These replace the values of EffectsOptions, also for what has already happened: blood runs again from its
    /// wounds. Blood that set_topology() carried over is lost. set_gravity throws Error (bad_input) for a vector
    /// without direction.
    void set_gravity(const glm::dvec3& gravity);
    void set_seed(std::uint32_t seed);
    /// All contacts so far, past and running. What happens is a function of this list and the time. The list replaces
    /// the samples that the tool queue has brought so far.
    void set_contacts(std::span<const ToolContact> contacts);
    /// Factors over time on cautery power, bleeding and smoke, also for what has already happened. There are none at
    /// first. A simulator needs them only for what changes from one moment on, such as stronger bleeding.
    void set_curves(const Curves& curves);
    /// The queue for samples of a haptic thread; seek() takes the samples that have arrived. The reference is valid as
    /// long as this Effects lives, also after a move.
    ToolQueue& tool_queue() noexcept;
    /// What has happened so far, to be saved as the events of a scene: the contacts that were set, then those that came
    /// through the queue. tool_queue.h says how samples become contacts. Valid until the next seek() or set_contacts().
    std::span<const ToolContact> contacts() const noexcept;

    /// Deforms the organ: new positions, mm, and unit normals for every vertex, with the same connectivity. Empty
    /// normals are computed, smooth. A coarse organ (refine.h) takes the vertices that it was given with; the added
    /// ones stay midway between them. Blood, burns and wounds stay on the tissue: distances, areas and contacts refer
    /// to the rest shape, drawing and picking to the moved shape. O(vertices), no allocation after the first call.
    /// Sizes must fit (assert).
    void set_shape(std::span<const glm::vec3> positions, std::span<const glm::vec3> normals = {});
    /// Carries a place on the moved shape back to the rest shape, where contacts are given. Without set_shape() it is
    /// the place itself.
    glm::dvec3 to_rest(const glm::dvec3& place) const noexcept;

    /// Cuts the organ: another surface replaces it, at rest, with the materials and textures of `organ`. An image with
    /// a size but without pixels, such as those of PreparedOrgan::organ(), takes the pixels of the previous image with
    /// the same index, name and size; if there is none it is white, or flat for a normal map. `origin[v]` is the vertex
    /// of the previous organ that vertex v was, or `new_vertex`. Blood on surviving vertices stays there until it is
    /// cleared, and clots with the wounds of that time. Wounds and burns stay at their places, and blood continues to
    /// spread over the new surface. Times before this call show the new surface with the blood that would have spread
    /// over it. This rebuilds what depends on the mesh, which takes as long as the constructor, and changes buffer
    /// names. Throws Error (runtime) and then keeps the previous organ.
    void set_topology(const Organ& organ, std::span<const std::uint32_t> origin);
    static constexpr std::uint32_t new_vertex = 0xffffffff;

    /// Another organ takes the place of this one, and `contacts` are all that has happened to it so far. It comes
    /// without a frame that takes long: its mip levels and the simulation of `contacts` are made on another thread,
    /// then each seek() sends a part of its textures to the GPU, some twenty of them 80 MB, and one all its vertices:
    /// with a software renderer .6 ms for a MB of them. Until all is there the present organ is shown, and samples of
    /// the tool, set_shape() and set_topology() are for that; what else is set meanwhile holds for both,
    /// set_contacts(), too: where places differ, set contacts when it is shown. Gravity, vessel parameters or earlier
    /// contacts that are set meanwhile cost their time again in the frame that shows the organ. Haze, too, is that of
    /// `contacts`. The seek() that shows it ends organ_coming(); from then on buffer names and the number of vertices
    /// are those of the new organ, and it is at rest. With EffectsOptions::wait_for_clips that is the next one. A
    /// second call replaces an organ that is still coming. `organ` is not null. Out of memory ends the process, as in
    /// seek(), except in this call itself (std::exception): then none comes. Destroying Effects waits for the step that
    /// the other thread is in.
    void set_organ(std::shared_ptr<const PreparedOrgan> organ, std::span<const ToolContact> contacts = {});
    bool organ_coming() const noexcept;

    /// For editors, while somebody works on shaders: compiles all programs from the files in `folder`; a file that is
    /// missing there comes from the built-in ones. The new programs replace the previous ones, also for every Effects
    /// that this process makes later. Throws Error (runtime) with file and line, and then changes nothing.
    void reload_shaders(const std::filesystem::path& folder);

    /// Multiplies the organ's own colours where draw_organ() shows tissue; sRGB, white at first. It is meant for meshes
    /// without colours. It does not change where vessels and fat are found.
    void set_organ_color(const glm::dvec3& color);

    /// Draws false colour over the tissue from the next frame on; Overlay::none at first. Uploads what it needs.
    void set_overlay(Overlay overlay);

    /// The state at a time. Any number of views may be drawn of it, such as one for each eye; all show the same frames
    /// of the clips.
    void seek(double time) noexcept;
    void draw_organ(const View& view) noexcept;
    /// Draws the metal clips on the tissue (ToolAction::clip), lit and tested against the depth, for a host that draws
    /// the organ itself. draw_organ() includes them.
    void draw_metal_clips(const View& view) noexcept;
    /// `scene_depth`: a depth texture of the frame, the size of the viewport, without multisampling, not attached to
    /// the bound framebuffer.
    void draw_smoke(const View& view, unsigned scene_depth) noexcept;

    /// For a host's own organ shader: the GL buffer of bleed value (mm; it continues below 0, for the noise) and clot
    /// (0..1), one vec2 per organ vertex in the order of Organ::positions. The vertices that refine() adds to a coarse
    /// organ follow. seek() updates it. The name is valid until set_topology(), until an organ of set_organ() is
    /// shown, or the end of this object; do not write to it. It belongs in the vertex array that the organ is drawn
    /// with; a toolkit that makes its vertex arrays anew needs it there again, and may neither reorder, join, shift nor
    /// scale vertices.
    unsigned bleed_buffer() const noexcept;
    /// Binds the uniform block that bleeding_shader() reads at uniform binding 1, and leaves it bound. Unlike the draw
    /// calls it changes the host's state on purpose. The block is that of the organ that is shown: bind it again after
    /// set_topology() and when an organ of set_organ() is shown; that of an organ that goes is unbound.
    void bind_bleeding() const noexcept;

    /// Amounts at the time of the last seek().
    Amounts amounts() const noexcept;
    /// Every wound of the contacts and what it was doing at the last seek(). Wounds of later contacts are waiting.
    /// Valid until the next call that is not const.
    std::span<const WoundStatus> wounds() const noexcept;
    /// The smoke clips of the preset, in its order, and what playing them has cost so far (streaming.h).
    /// Valid until the next call of this function or of one that is not const.
    std::span<const ClipStatus> clips() const;
    StreamingTimes streaming_times() const noexcept;
    /// Whether the last draw_smoke() showed an older frame of a clip than the one that was due, so that seeking the
    /// same time again gives a better picture. Never true with wait_for_clips.
    bool late() const noexcept;
    /// Bytes of main memory and of the GPU, by purpose, and their sum; without those of an organ that is coming or
    /// gone.
    MemoryUse memory_use() const noexcept;
    std::size_t memory() const noexcept { return memory_use().total(); }
    /// Bytes that the last seek sent to the GPU, without those of an organ that is coming.
    std::size_t uploaded() const noexcept;
    /// The tissue around the point of the organ that is nearest to `position`, mm: means over the preset's region of
    /// influence (paper: figure 9). All 0 for coordinates that are NaN or infinite. About 0.1 ms.
    TissueSample tissue(const glm::dvec3& position) const noexcept;
    /// Where a ray first meets the organ. `direction` need not be unit.
    std::optional<OrganHit> pick(glm::dvec3 origin, glm::dvec3 direction) const noexcept;

  private:
    struct LAPFX_HIDDEN State;
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
/// and may use blood.gloss, clot, depth and level. A shader with highlights keeps blood that is far away from
/// glittering by lapfx_blood_film(roughness, strength, blood.spread), which gives the roughness (square root of GGX's
/// alpha) and the strength to draw with. Throws Error (runtime) when a shader folder that the editor set
/// lacks a file. Any thread. (Paper: "Simulation of bleeding", figure 6: "the bleeding code was integrated into the
/// existing shader".)
LAPFX_API std::string bleeding_shader();

}  // namespace lapfx
