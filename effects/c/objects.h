// What the handles of the C API lead to.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "c/handles.h"
#include "gl/context_hold.h"
#include "lapfx.h"
#include "lapfx/context.h"
#include "lapfx/effects.h"
#include "lapfx/frame.h"
#include "lapfx/organ.h"
#include "lapfx/prepared_organ.h"
#include "lapfx/preset.h"
#include "lapfx/scene.h"

namespace lapfx::c {

/// Shared by all that was made in it: the last one frees it.
struct SharedContext {
    Context context;
    bool external;
    std::thread::id thread = std::this_thread::get_id();
    std::string renderer = context.renderer();
    std::weak_ptr<Context::Owner> current_at_first = gl::current_owner();  ///< null: none of lapfx's own

    /// Throws Misuse on another thread.
    void require_thread() const;
    /// Throws Misuse on another thread, and where the host's context is not current; makes one of lapfx's own current.
    void require_current() const;
    /// The same, and a frame that was begun in another context must be finished.
    void require_drawing() const;
};

struct ContextObject : Object {
    using Handle = lapfx_context;
    static constexpr Kind kind = Kind::context;
    std::shared_ptr<SharedContext> shared;
};

struct OrganObject : Object {
    using Handle = lapfx_organ;
    static constexpr Kind kind = Kind::organ;
    explicit OrganObject(Organ given) : organ(std::move(given)) {}
    Organ organ;
    std::shared_ptr<const PreparedOrgan> prepared;  ///< may be null
};
/// Tells what was repaired.
std::unique_ptr<OrganObject> organ_object(const char* function, Organ organ);

struct PresetObject : Object {
    using Handle = lapfx_preset;
    static constexpr Kind kind = Kind::preset;
    explicit PresetObject(Preset given) : preset(std::move(given)) {}
    Preset preset;
    std::string json;  ///< as it was written last
};

struct SceneObject : Object {
    using Handle = lapfx_scene;
    static constexpr Kind kind = Kind::scene;
    explicit SceneObject(Scene given);
    Scene scene;                                    ///< events in the order of time
    std::string preset, organ_file, organ_texture;  ///< paths that can be opened
};

struct EffectsObject : Object {
    using Handle = lapfx_effects;
    static constexpr Kind kind = Kind::effects;
    EffectsObject(std::shared_ptr<SharedContext> context, Effects made, std::size_t vertex_count)
        : shared(std::move(context)), effects(std::move(made)), vertices(vertex_count), coming_vertices(vertex_count) {}
    std::shared_ptr<SharedContext> shared;  // before what is made in it
    Effects effects;
    std::size_t vertices;               ///< of the organ as it was given
    std::size_t coming_vertices;        ///< the same, of the organ that comes
    std::vector<ToolContact> contacts;  // kept, so that setting them allocates nothing
};

struct FrameObject : Object {
    using Handle = lapfx_frame;
    static constexpr Kind kind = Kind::frame;
    explicit FrameObject(std::shared_ptr<SharedContext> context) : shared(std::move(context)) {}
    ~FrameObject() override;

    enum class Stage { none, scene, smoke };
    std::shared_ptr<SharedContext> shared;  // before what is made in it
    Frame frame;
    glm::ivec2 size{0};
    Stage stage = Stage::none;
};

void set_open_frame(const SharedContext* context) noexcept;  ///< null: none
bool is_open_frame(const SharedContext* context) noexcept;

/// A contact as C has it.
void fill(lapfx_contact& out, const ToolContact& contact);

}  // namespace lapfx::c
