// lapfx in C: blood on an organ and surgical smoke over a frame, for hosts that are not written in C++20, and for all
// languages that can call C. C99 and C++. lapfx.py is the same for Python.
//
//     lapfx_context* context;
//     lapfx_organ* organ;
//     lapfx_preset* preset;
//     lapfx_effects* effects;
//     const char* folders[] = {"clips"};
//     lapfx_effects_options options = LAPFX_EFFECTS_OPTIONS;
//     options.clip_folders = folders;
//     options.clip_folder_count = 1;
//     if (lapfx_context_external(my_get_proc_address, &context) != LAPFX_OK ||  // your OpenGL 4.5 context, current
//         lapfx_organ_load("stomach.glb", NULL, &organ) != LAPFX_OK ||
//         lapfx_preset_load("tuned.json", &preset) != LAPFX_OK ||
//         lapfx_effects_create(context, organ, preset, &options, &effects) != LAPFX_OK)
//         fail(lapfx_last_message());
//
//     lapfx_effects_push_sample(effects, &sample);        // the haptic thread, 1000 times a second
//
//     lapfx_effects_seek(effects, now);                   // once per frame; s, in any order
//     lapfx_effects_draw_organ(effects, &view);           // into the framebuffer that you have bound
//     lapfx_effects_draw_smoke(effects, &view, depth);    // over the frame, after everything else
//
// CMake: find_package(lapfx COMPONENTS c), target lapfx::c; or pkg-config lapfx-c. Outside of the system's folders the
// program also needs -Wl,-rpath, or LD_LIBRARY_PATH. samples/host/host.c (below share/lapfx) is a whole program.
//
// UNITS. Lengths mm, times s, angles degrees, in organ space: that of the organ's positions, right-handed. Colours of a
// lamp and of an organ are sRGB 0..1; frames are drawn in linear light. A vector is an array of 3. A matrix is an array
// of 16, column by column (as OpenGL takes it: the translation is in 12, 13 and 14). An engine that is left-handed or
// counts in metres converts what it passes: positions, contacts, and the view, which leads from organ space (so the
// organ's own placement is in it) to that of a camera that looks along -z, without scaling.
//
// STRUCTS begin with their size: set it to sizeof. A library of this version takes no other size; a later one will take
// that of this version, too. Those that you fill have an initialiser with all defaults, LAPFX_VIEW for lapfx_view
// (whose matrices show nothing yet); of those that lapfx fills set the size alone.
//
// OWNERSHIP. What a ..._create or ..._load gives is yours until you destroy it. lapfx copies what it is given: arrays,
// texts and other objects may go when the call returns. Any order of destroying is fine, the context first, too: the
// last object that was made in it frees it. Destroying NULL does nothing. A handle is no address: one that is NULL,
// destroyed, or of another type is told as LAPFX_MISUSE. Pointers that lapfx gives are read-only; each says how long
// it is valid.
//
// THREADS. What is made in a context (effects, frames) belongs to the thread on which the context was made, and so does
// the context: all its calls are on that thread, asking for amounts and destroying, too. In an engine that is its
// render thread (in Unity: the callback of GL.IssuePluginEvent). Destroy before that thread ends.
// lapfx_effects_push_sample alone may be called on one other thread; it never waits. Organs, presets and scenes need no
// context: any thread, one at a time for each object.
//
// OPENGL alone: an engine has to run with it, not with Vulkan or Direct3D. A context that lapfx made is made current by
// each call that needs it, and stays so: make yours current again. One of yours has to be current before each call.
// seek and the draw calls leave its state as they found it. They expect the initial front face, colour mask, stencil,
// polygon mode and clip control (z from -1 to 1, not reversed), no sampler objects on units 0 to 13, and a float or an
// sRGB framebuffer with GL_FRAMEBUFFER_SRGB, because they draw linear light (the whole list: lapfx/effects.h). The
// calls of a frame bind its own framebuffer, set the viewport, and leave both so (lapfx/frame.h).
//
// STATUSES. Every call that can fail returns one. When that is not LAPFX_OK, nothing has changed, nothing was drawn, a
// handle to be made is NULL, and lapfx_last_message() tells the value that was found and what is allowed. Enumerators
// are passed as int, so that others can be refused. No exception leaves lapfx. Only when memory ends in the middle of
// seek or of drawing, the process ends, too.
#ifndef LAPFX_H
#define LAPFX_H

#include <stddef.h>
#include <stdint.h>

#ifdef __GNUC__
#define LAPFX_API __attribute__((visibility("default")))
#else
#define LAPFX_API  // lapfx is for Linux; others may read this header
#endif

#ifdef __cplusplus
extern "C" {
#endif

typedef struct lapfx_context lapfx_context;  ///< OpenGL
typedef struct lapfx_organ lapfx_organ;      ///< a mesh with its textures
typedef struct lapfx_preset lapfx_preset;    ///< how blood and smoke look: what the editor saves
typedef struct lapfx_scene lapfx_scene;      ///< organ, camera, light and tool events to show a preset on
typedef struct lapfx_effects lapfx_effects;  ///< blood and smoke of one organ
typedef struct lapfx_frame lapfx_frame;      ///< the editor's frame, for hosts that have none

typedef enum lapfx_status {
    LAPFX_OK = 0,
    LAPFX_RUNTIME = 1,    ///< it failed while running: memory, disk, driver
    LAPFX_BAD_INPUT = 2,  ///< a file or a value has to change: an enumerator, an index or a size, too
    LAPFX_NO_GL = 3,      ///< no usable OpenGL on this machine
    LAPFX_MISUSE = 4      ///< the program has to change: order of calls, thread, handle, NULL, size of a struct
} lapfx_status;

/// "0.1.0". Never fails.
LAPFX_API const char* lapfx_version(void);

// Messages.

/// What was wrong in the last call on this thread that failed, a line for each fault; empty before there was one. Valid
/// until the next call on this thread that fails.
LAPFX_API const char* lapfx_last_message(void);

enum { LAPFX_LOG_ERROR = 0, LAPFX_LOG_WARNING = 1 };  ///< a call failed; it went on, but something is not as it should
/// Told each line on the thread of the call, one at a time: other threads that have something to tell wait, so it does
/// not wait for them. `message` is valid during the call. It calls no function of lapfx but lapfx_last_message:
/// LAPFX_MISUSE.
typedef void (*lapfx_log)(void* user, int level, const char* message);
/// NULL, as at first: nothing is told. Any thread. The previous one is not called any more when this returns.
LAPFX_API void lapfx_set_log(lapfx_log log, void* user);

// Contexts (lapfx/context.h).

enum {
    LAPFX_BACKEND_AUTOMATIC = 0,  ///< EGL, else OSMesa
    LAPFX_BACKEND_EGL = 1,        ///< EGL without a surface: a GPU, or Mesa's software renderer
    LAPFX_BACKEND_OSMESA = 2      ///< Mesa's off-screen software renderer
};
typedef void (*lapfx_function)(void);
typedef lapfx_function (*lapfx_get_proc_address)(const char* name);

/// A context of its own, without a window, current on this thread. There may be several, of one backend: LAPFX_NO_GL
/// for one whose functions are others than those of a context that is in use.
LAPFX_API lapfx_status lapfx_context_create(int backend, lapfx_context** context);
/// Yours, OpenGL 4.5 or later, current on this thread. It stays yours.
LAPFX_API lapfx_status lapfx_context_external(lapfx_get_proc_address get_proc_address, lapfx_context** context);
/// GL_RENDERER; valid until the context is destroyed.
LAPFX_API lapfx_status lapfx_context_renderer(const lapfx_context* context, const char** text);
/// Finds the context's functions, for your own drawing.
LAPFX_API lapfx_status lapfx_context_functions(const lapfx_context* context, lapfx_get_proc_address* get_proc_address);
/// Only before your own OpenGL calls. LAPFX_MISUSE for one of yours: your window system makes it current.
LAPFX_API lapfx_status lapfx_context_make_current(lapfx_context* context);
LAPFX_API lapfx_status lapfx_context_destroy(lapfx_context* context);

// Organs (lapfx/organ.h).

typedef struct lapfx_organ_options {
    size_t size;
    double scale;         ///< mm per unit of the file; 0 = by format: 1000 for glTF (metres), 1 for others
    double rotation[3];   ///< degrees about x, then y, then z, after the scale
    const char* texture;  ///< a picture in place of all base colour textures; NULL: the organ's own
} lapfx_organ_options;
#define LAPFX_ORGAN_OPTIONS \
    { sizeof(lapfx_organ_options), 0.0, {0.0, 0.0, 0.0}, NULL }

/// Triangles in memory. Vertices keep their order and number.
typedef struct lapfx_mesh {
    size_t size;
    size_t vertex_count;
    const float* positions;   ///< 3 per vertex, mm
    size_t index_count;       ///< 3 per triangle
    const uint32_t* indices;  ///< counter-clockwise from outside
    const float* normals;     ///< 3 per vertex; NULL: computed, smooth
    const float* uvs;         ///< 2 per vertex, origin top left; NULL: made
    const float* colors;      ///< 4 per vertex, linear RGBA, 0..1; NULL: white
} lapfx_mesh;
#define LAPFX_MESH \
    { sizeof(lapfx_mesh), 0, NULL, 0, NULL, NULL, NULL, NULL }

/// What a host needs to draw an organ itself; valid until the organ is destroyed.
typedef struct lapfx_organ_data {
    size_t size;
    size_t vertex_count;
    size_t index_count;
    const float* positions;   ///< 3 per vertex, mm
    const float* normals;     ///< 3 per vertex, unit
    const float* uvs;         ///< 2 per vertex
    const float* colors;      ///< 4 per vertex
    const uint32_t* indices;  ///< 3 per triangle
} lapfx_organ_data;

/// glTF 2.0 (.glb, .gltf), OBJ, PLY, STL, OFF. `options` may be NULL: its defaults. What was repaired is told as
/// warnings.
LAPFX_API lapfx_status lapfx_organ_load(const char* path, const lapfx_organ_options* options, lapfx_organ** organ);
LAPFX_API lapfx_status lapfx_organ_create(const lapfx_mesh* mesh, lapfx_organ** organ);
/// Another organ of the same shape, with triangles fine enough for blood; the given vertices come first. Only for hosts
/// that draw the organ themselves: then create the effects of `refined` (lapfx/refine.h).
LAPFX_API lapfx_status lapfx_organ_refine(const lapfx_organ* organ, lapfx_organ** refined);
/// Does now, on this thread, most of what makes lapfx_effects_create take long, for presets with vessels as in `preset`
/// (NULL: as in a preset without values): mip levels and sending it to the GPU remain. lapfx_effects_set_organ wants
/// it.
LAPFX_API lapfx_status lapfx_organ_prepare(lapfx_organ* organ, const lapfx_preset* preset);
LAPFX_API lapfx_status lapfx_organ_get_data(const lapfx_organ* organ, lapfx_organ_data* data);
LAPFX_API lapfx_status lapfx_organ_destroy(lapfx_organ* organ);

// Presets (lapfx/preset.h; every key: presets/REFERENCE.md).

LAPFX_API lapfx_status lapfx_preset_load(const char* path, lapfx_preset** preset);
/// `json` ends with a zero; `folder` is where its clips are looked up first, NULL: in clip_folders alone.
LAPFX_API lapfx_status lapfx_preset_parse(const char* json, const char* folder, lapfx_preset** preset);
/// Sets one value from text: "bleeding.speed" and "8", "bleeding.color_deep" and "#5d0f11". Effects take it with
/// lapfx_effects_set_preset, which checks the rules between values.
LAPFX_API lapfx_status lapfx_preset_set(lapfx_preset* preset, const char* key, const char* value);
/// The whole preset as JSON; valid until the next call of this function for it, and until it is destroyed.
LAPFX_API lapfx_status lapfx_preset_write(lapfx_preset* preset, const char** json);
LAPFX_API lapfx_status lapfx_preset_destroy(lapfx_preset* preset);

// Tools (lapfx/tool.h, lapfx/tool_queue.h).

enum {
    LAPFX_CAUTERISE = 0,   ///< heat that closes wounds, chars and divides tissue; smokes
    LAPFX_CUT = 1,         ///< divides tissue: bleeds at once
    LAPFX_COAGULATE = 2,   ///< gentle heat that closes wounds; smokes
    LAPFX_TEAR = 3,        ///< blunt: bleeds at once, less than a cut
    LAPFX_SUCTION = 4,     ///< removes blood and haze
    LAPFX_IRRIGATION = 5,  ///< rinses blood away
    LAPFX_CLIP = 6         ///< sets a metal clip, under which bleeding stops
};

/// The tool touches the organ from `time` for `duration`, its tip moving straight from `position` to `to`. With values
/// that are absurd (a path over 1000 mm, a coordinate beyond 1e5 mm, a time beyond 1e7 s, a negative duration) it does
/// nothing, and nothing is told: count seconds from the start of the exercise. A tip that is farther than 5 mm from the
/// organ touches nothing; a fast one does not burn (lapfx/tool.h). `to` is not `position` by default: set both, also
/// for a tip that stands still.
typedef struct lapfx_contact {
    size_t size;
    int action;
    double time;
    double duration;
    double position[3];
    double to[3];
    double power;     ///< 0..1, of heat
    double strength;  ///< of the wound, a factor on the preset's speed
} lapfx_contact;
#define LAPFX_CONTACT \
    { sizeof(lapfx_contact), LAPFX_CAUTERISE, 0.0, 1.0, {0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, 1.0, 1.0 }

/// Where the tip is at one moment, and what it does there. Samples come later and later; others are dropped, and
/// counted as lost (lapfx_amounts). Those that touch, at most 0.1 s apart, make contacts: another one where the tip
/// turns.
typedef struct lapfx_sample {
    size_t size;
    double time;
    double position[3];
    int touching;  ///< not 0: the tool touches the organ and acts (pedal down, blades closed)
    int action;
    double power;
    double strength;
} lapfx_sample;
#define LAPFX_SAMPLE \
    { sizeof(lapfx_sample), 0.0, {0.0, 0.0, 0.0}, 0, LAPFX_CAUTERISE, 1.0, 1.0 }

// Where a frame is seen from, and how light becomes a picture (lapfx/view.h, lapfx/frame.h).

typedef struct lapfx_view {
    size_t size;
    float view[16];              ///< organ space to camera space, column by column; rigid, or it is refused
    float projection[16];        ///< OpenGL's clip space, z in -1..1, perspective
    double lamp_intensity;       ///< a white surface at the focus distance is lit to this
    double lamp_focus_distance;  ///< mm
    double lamp_beam_angle;      ///< degrees, the whole angle within which the light is above half
    double lamp_ambient;         ///< light from all around, as a share of the lamp's
    double lamp_color[3];        ///< sRGB
    int haze;                    ///< 0: left out, as of a look from far away
} lapfx_view;
#define LAPFX_IDENTITY \
    { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 }
#define LAPFX_VIEW \
    { sizeof(lapfx_view), LAPFX_IDENTITY, LAPFX_IDENTITY, 1.0, 100.0, 75.0, 0.02, {1.0, 1.0, 1.0}, 1 }

typedef struct lapfx_response {
    size_t size;
    double exposure;
    double vignette;          ///< 0 = whole rectangle, 1 = the round picture of an endoscope
    double white_balance[3];  ///< factors on red, green and blue
    double sharpening;        ///< 0..2
    double saturation;        ///< 0 = grey
    double lens_falloff;      ///< 0..1
    int curve;                ///< 0 = shoulder, 1 = film
    double toe, knee, white;  ///< of film
} lapfx_response;
#define LAPFX_RESPONSE \
    { sizeof(lapfx_response), 1.0, 1.0, {1.0, 1.0, 1.0}, 0.0, 1.0, 0.45, 0, 0.2, 0.6, 3.0 }

// Scenes (lapfx/scene.h). A simulator has its own; these are for previews, tests and pictures by the thousand.

/// Texts are valid until the scene is destroyed, and empty where the scene has none. Paths can be opened as they are.
typedef struct lapfx_scene_info {
    size_t size;
    const char* name;
    const char* preset;  ///< path of the preset that it opens with
    double duration;
    uint32_t seed;
    double gravity[3];
    const char* organ_file;
    double organ_scale;
    double organ_rotation[3];
    const char* organ_texture;
    double organ_color[3];  ///< sRGB, multiplies the organ's own colours
    double eye[3];
    double target[3];
    double up[3];
    double field_of_view;  ///< vertical, degrees
    double exposure;
    double vignette;
    double lamp_intensity;
    double lamp_focus_distance;
    double lamp_beam_angle;
    double lamp_color[3];
    size_t event_count;
} lapfx_scene_info;

LAPFX_API lapfx_status lapfx_scene_load(const char* path, lapfx_scene** scene);
LAPFX_API lapfx_status lapfx_scene_get_info(const lapfx_scene* scene, lapfx_scene_info* info);
/// What the tool does, 0 to event_count - 1, in the order of time.
LAPFX_API lapfx_status lapfx_scene_get_event(const lapfx_scene* scene, size_t index, lapfx_contact* contact);
/// The scene's camera and lamp for a frame of so many pixels.
LAPFX_API lapfx_status lapfx_scene_get_view(const lapfx_scene* scene, int width, int height, lapfx_view* view);
LAPFX_API lapfx_status lapfx_scene_get_response(const lapfx_scene* scene, lapfx_response* response);
/// Loads the scene's organ, with its scale, rotation and texture. LAPFX_BAD_INPUT for a scene that shows a plate (a
/// frame of its reference) instead: only lapfx itself draws that.
LAPFX_API lapfx_status lapfx_scene_load_organ(const lapfx_scene* scene, lapfx_organ** organ);
LAPFX_API lapfx_status lapfx_scene_destroy(lapfx_scene* scene);

// Effects (lapfx/effects.h).

typedef struct lapfx_effects_options {
    size_t size;
    uint32_t seed;                    ///< every random choice depends on it alone
    double gravity[3];                ///< direction; blood runs down, smoke rises
    const char* const* clip_folders;  ///< where bare names of clips are looked up
    size_t clip_folder_count;
    int wait_for_clips;  ///< not 0: exact frames, for pictures; 0: never wait, repeat the last frame of a clip
    size_t clip_memory;  ///< bytes for frames of clips, on the GPU and in main memory together
} lapfx_effects_options;
#define LAPFX_EFFECTS_OPTIONS \
    { sizeof(lapfx_effects_options), 1, {0.0, -1.0, 0.0}, NULL, 0, 0, (size_t)1 << 30 }

/// Amounts at the time of the last seek (lapfx/amounts.h).
typedef struct lapfx_amounts {
    size_t size;
    double blood_area;      ///< mm2
    double blood_volume;    ///< mm3
    double burnt_area;      ///< mm2
    double haze;            ///< optical thickness at the focus distance
    double emission;        ///< smoke made at this moment; one tool at full power on lean tissue makes 1
    uint64_t lost_samples;  ///< pushed, and no room or not usable
    int wounds;             ///< that have opened by now
    int bleeding_wounds;
    int left_out_wounds;  ///< did not open, because there were 4096 already
} lapfx_amounts;

enum {
    LAPFX_WOUND_WAITING = 0,   ///< not open yet
    LAPFX_WOUND_BLEEDING = 1,  ///< open
    LAPFX_WOUND_SPENT = 2,     ///< open, its blood spreads no further
    LAPFX_WOUND_CLOTTING = 3,  ///< coagulated: the flow dies down
    LAPFX_WOUND_CLOSED = 4
};
/// A place that bleeds (lapfx/wound.h).
typedef struct lapfx_wound {
    size_t size;
    int state;
    int bleeds;          ///< its blood spreads or fills again now
    double position[3];  ///< mm, on the organ at rest
    double start;        ///< s
    double stop;         ///< s, when coagulation begins; infinite: never
    double strength;
    double extent;  ///< mm that its blood has travelled
} lapfx_wound;

typedef struct lapfx_hit {
    size_t size;
    int found;  ///< 0: the ray meets no tissue
    double position[3];
    double distance;  ///< mm from the ray's origin
} lapfx_hit;

/// Bytes, by purpose (lapfx/memory.h).
typedef struct lapfx_memory_use {
    size_t size;
    size_t surface, pixels, densities;          ///< main memory
    size_t geometry, textures, clips, targets;  ///< GPU
    size_t total;
} lapfx_memory_use;

/// `options` may be NULL: its defaults.
LAPFX_API lapfx_status lapfx_effects_create(lapfx_context* context, const lapfx_organ* organ,
                                            const lapfx_preset* preset, const lapfx_effects_options* options,
                                            lapfx_effects** effects);
/// Live: the next frame shows it as if it had been so from the start, so that blood which has spread already changes at
/// once. Of a preset that cannot be used nothing is taken.
LAPFX_API lapfx_status lapfx_effects_set_preset(lapfx_effects* effects, const lapfx_preset* preset);
/// All contacts so far, past and running. They replace the samples that came so far.
LAPFX_API lapfx_status lapfx_effects_set_contacts(lapfx_effects* effects, const lapfx_contact* contacts, size_t count);
/// Another organ takes the place of this one, and `contacts` are all that has happened to it so far (NULL with 0:
/// none):
///
///     lapfx_organ_prepare(next, preset);                 // on another thread
///     lapfx_effects_set_organ(effects, next, NULL, 0);   // then seek and draw as ever; `next` may be destroyed
///     lapfx_effects_get_organ_coming(effects, &coming);  // 0: it is shown
///
/// No frame takes long: what is left to do is done on another thread and, a part in each lapfx_effects_seek, on the
/// GPU: textures in parts, all vertices in one seek. With wait_for_clips the next seek does it all. Until the organ is
/// there the present one is shown, and samples and lapfx_effects_set_shape are for that; what else is set meanwhile
/// holds for both, lapfx_effects_set_contacts, too: where places differ, set contacts when it is shown. Gravity,
/// vessels and earlier contacts that are set meanwhile cost their time again in the seek that shows it. That seek ends
/// lapfx_effects_get_organ_coming; from then on the bleed buffer, its uniform block and the number of vertices are the
/// new organ's, which is at rest: bind both again. A second call replaces an organ that is still coming. What is
/// refused changes nothing; when memory ends, none comes. Destroying waits for the step that the other thread is in.
LAPFX_API lapfx_status lapfx_effects_set_organ(lapfx_effects* effects, const lapfx_organ* organ,
                                               const lapfx_contact* contacts, size_t count);
/// 1 until the organ of lapfx_effects_set_organ is shown, else 0.
LAPFX_API lapfx_status lapfx_effects_get_organ_coming(lapfx_effects* effects, int* coming);
/// One thread, any: wait-free, allocates nothing unless it fails. LAPFX_RUNTIME when the queue is full (8192 samples):
/// the sample is lost, and not logged. A sample that touches nothing costs nothing.
LAPFX_API lapfx_status lapfx_effects_push_sample(lapfx_effects* effects, const lapfx_sample* sample);
/// The curves of a scene: factors over time. NULL: none, as at first.
LAPFX_API lapfx_status lapfx_effects_set_curves(lapfx_effects* effects, const lapfx_scene* scene);
/// Deforms the organ: 3 floats for each vertex of the organ that is shown (lapfx_organ_get_data), mm, at most 1e9.
/// `normals` may be NULL: computed.
LAPFX_API lapfx_status lapfx_effects_set_shape(lapfx_effects* effects, size_t vertex_count, const float* positions,
                                               const float* normals);
LAPFX_API lapfx_status lapfx_effects_set_gravity(lapfx_effects* effects, const double gravity[3]);
LAPFX_API lapfx_status lapfx_effects_set_seed(lapfx_effects* effects, uint32_t seed);
/// Multiplies the colours of the organ; sRGB, white at first.
LAPFX_API lapfx_status lapfx_effects_set_organ_color(lapfx_effects* effects, const double color[3]);

/// The state at a time; takes the samples that have been pushed. Any number of views may be drawn of it, such as one
/// for each eye.
LAPFX_API lapfx_status lapfx_effects_seek(lapfx_effects* effects, double time);
LAPFX_API lapfx_status lapfx_effects_draw_organ(lapfx_effects* effects, const lapfx_view* view);
/// Metal clips on the tissue, for hosts that draw the organ themselves; lapfx_effects_draw_organ includes them.
LAPFX_API lapfx_status lapfx_effects_draw_metal_clips(lapfx_effects* effects, const lapfx_view* view);
/// `depth`: a depth texture of the frame, of the size of the viewport, not attached to the bound framebuffer.
LAPFX_API lapfx_status lapfx_effects_draw_smoke(lapfx_effects* effects, const lapfx_view* view, unsigned depth);

/// For your own organ shader (lapfx/effects.h, bleeding_shader): its text, valid for ever,
LAPFX_API lapfx_status lapfx_bleeding_shader(const char** text);
/// For a frame that you finish yourself (lapfx/camera.h, post_shader): its text, valid for ever,
LAPFX_API lapfx_status lapfx_post_shader(const char** text);
/// and what its uniform array `vec4 lapfx_camera[4]` is set to, for a frame of so many pixels.
LAPFX_API lapfx_status lapfx_post_values(const lapfx_response* response, int width, int height, float values[16]);
/// the OpenGL buffer of two floats per vertex that it reads,
LAPFX_API lapfx_status lapfx_effects_bleed_buffer(lapfx_effects* effects, unsigned* buffer);
/// and its uniform block, at binding 1. Both are those of the organ that is shown: bind them again when another one is.
LAPFX_API lapfx_status lapfx_effects_bind_bleeding(lapfx_effects* effects);

LAPFX_API lapfx_status lapfx_effects_get_amounts(lapfx_effects* effects, lapfx_amounts* amounts);
LAPFX_API lapfx_status lapfx_effects_get_wound_count(lapfx_effects* effects, size_t* count);
/// 0 to the count - 1, as at the last seek.
LAPFX_API lapfx_status lapfx_effects_get_wound(lapfx_effects* effects, size_t index, lapfx_wound* wound);
/// What has happened so far, to be kept: contacts that were set, and those that samples have made.
LAPFX_API lapfx_status lapfx_effects_get_contact_count(lapfx_effects* effects, size_t* count);
LAPFX_API lapfx_status lapfx_effects_get_contact(lapfx_effects* effects, size_t index, lapfx_contact* contact);
/// Where a ray first meets the organ; the direction need not be unit.
LAPFX_API lapfx_status lapfx_effects_pick(lapfx_effects* effects, const double origin[3], const double direction[3],
                                          lapfx_hit* hit);
/// 1 when the last smoke showed an older frame of a clip than the one that was due.
LAPFX_API lapfx_status lapfx_effects_get_late(lapfx_effects* effects, int* late);
LAPFX_API lapfx_status lapfx_effects_get_memory(lapfx_effects* effects, lapfx_memory_use* use);
LAPFX_API lapfx_status lapfx_effects_destroy(lapfx_effects* effects);

// Frames (lapfx/frame.h): linear light, four samples a pixel, the camera's response. In this order:
//
//     lapfx_frame_begin(frame, 1280, 1024);                       // bound and cleared
//     lapfx_effects_draw_organ(effects, &view);                   // and all else
//     lapfx_frame_begin_smoke(frame);
//     lapfx_frame_get_depth(frame, &depth);
//     lapfx_effects_draw_smoke(effects, &view, depth);
//     lapfx_frame_finish(frame, 0, &response);                    // into the window, or lapfx_frame_read

LAPFX_API lapfx_status lapfx_frame_create(lapfx_context* context, lapfx_frame** frame);
/// Until it is finished, nothing of another context can be drawn.
LAPFX_API lapfx_status lapfx_frame_begin(lapfx_frame* frame, int width, int height);
LAPFX_API lapfx_status lapfx_frame_begin_smoke(lapfx_frame* frame);
/// The depth texture for lapfx_effects_draw_smoke; valid until a frame of another size begins.
LAPFX_API lapfx_status lapfx_frame_get_depth(lapfx_frame* frame, unsigned* depth);
/// Writes the picture into `framebuffer` (0 = the window's), after begin_smoke even where there is no smoke; it can be
/// written and read again until the next frame begins. `response` may be NULL: its defaults.
LAPFX_API lapfx_status lapfx_frame_finish(lapfx_frame* frame, unsigned framebuffer, const lapfx_response* response);
/// The same into memory: RGBA, a byte each, rows from the top; `bytes` = width * height * 4.
LAPFX_API lapfx_status lapfx_frame_read(lapfx_frame* frame, const lapfx_response* response, uint8_t* rgba,
                                        size_t bytes);
LAPFX_API lapfx_status lapfx_frame_destroy(lapfx_frame* frame);

#ifdef __cplusplus
}
#endif

#endif
