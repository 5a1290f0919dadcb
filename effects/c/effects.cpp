// Effects of the C API: what does not draw is in effects_state.cpp.
#include <algorithm>
#include <glm/gtc/matrix_access.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "c/calls.h"
#include "c/objects.h"
#include "gl/gl.h"

namespace lapfx::c {

namespace {

lapfx::EffectsOptions options_of(const lapfx_effects_options* options) {
    if (options == nullptr) return {};
    const lapfx_effects_options& o = LAPFX_SIZED(lapfx_effects_options, options);
    finite("options.gravity", o.gravity);
    at_most("options.clip_folder_count", o.clip_folder_count, 1024);
    if (o.clip_folder_count > 0) given(o.clip_folders, "options.clip_folders");
    EffectsOptions out;
    out.seed = o.seed;
    out.gravity = {o.gravity[0], o.gravity[1], o.gravity[2]};
    out.wait_for_clips = o.wait_for_clips != 0;
    out.streaming.memory = o.clip_memory;
    for (std::size_t i = 0; i < o.clip_folder_count; ++i)
        out.clip_folders.emplace_back(given(o.clip_folders[i], "an element of options.clip_folders"));
    return out;
}

glm::mat4 matrix_of(const float (&elements)[16], const char* argument) {
    finite(argument, elements);
    const glm::mat4 matrix = glm::make_mat4(elements);
    if (glm::determinant(glm::dmat4(matrix)) == 0.0)
        refuse_value(argument, "has the determinant 0; expected a matrix that can be inverted");
    return matrix;
}

/// One whose rows are given as columns is not, unless it moves nothing.
glm::mat4 rigid_of(const float (&elements)[16], const char* argument) {
    const glm::mat4 matrix = matrix_of(elements, argument);
    const glm::mat3 turn(matrix), error = glm::transpose(turn) * turn - glm::mat3(1.0F);
    const bool last_row = glm::row(matrix, 3) == glm::vec4(0.0F, 0.0F, 0.0F, 1.0F);
    const float most = std::max({glm::length(error[0]), glm::length(error[1]), glm::length(error[2])});
    if (!last_row || !(most < 1e-3F) || glm::determinant(turn) < 0.0F)
        refuse_value(argument, "is not rigid; expected a rotation and a translation, without scale, column by column");
    return matrix;
}

lapfx::View view_of(const lapfx_view* view) {
    const lapfx_view& v = LAPFX_SIZED(lapfx_view, view);
    not_negative("view.lamp_intensity", v.lamp_intensity);
    positive("view.lamp_focus_distance", v.lamp_focus_distance);
    positive("view.lamp_beam_angle", v.lamp_beam_angle);
    not_negative("view.lamp_ambient", v.lamp_ambient);
    finite("view.lamp_color", v.lamp_color);
    return {.view = rigid_of(v.view, "view.view"),
            .projection = matrix_of(v.projection, "view.projection"),
            .lamp = {.intensity = v.lamp_intensity,
                     .focus_distance = v.lamp_focus_distance,
                     .beam_angle = v.lamp_beam_angle,
                     .ambient = v.lamp_ambient,
                     .color = {v.lamp_color[0], v.lamp_color[1], v.lamp_color[2]}},
            .haze = v.haze != 0};
}

lapfx::Effects effects_of(const OrganObject& organ, const Preset& preset, const EffectsOptions& options) {
    return organ.prepared ? Effects(organ.prepared, preset, options) : Effects(organ.organ, preset, options);
}

void warn_of_clips(const char* function, const Effects& effects) {
    for (const ClipStatus& clip : effects.clips())
        if (!clip.warning.empty()) warn(function, clip.file + ": " + clip.warning);
}

/// Calls that draw something at a view.
template <typename Draw>
lapfx_status draw(const char* function, lapfx_effects* effects, const lapfx_view* view, const Draw& body) noexcept {
    return call(function, [&] {
        const Held<EffectsObject> held(effects, "effects");
        const View seen = view_of(view);
        held->shared->require_drawing();
        body(held->effects, seen);
    });
}

}  // namespace
}  // namespace lapfx::c

using namespace lapfx::c;

lapfx_status lapfx_effects_create(lapfx_context* context, const lapfx_organ* organ, const lapfx_preset* preset,
                                  const lapfx_effects_options* options, lapfx_effects** effects) {
    return make<EffectsObject>(__func__, effects, "effects", [&, function = __func__] {
        const Held<ContextObject> in(context, "context");
        const Held<OrganObject> of(organ, "organ");
        const Held<PresetObject> looks(preset, "preset");
        const lapfx::EffectsOptions wanted = options_of(options);
        in->shared->require_current();
        auto object = std::make_unique<EffectsObject>(in->shared, effects_of(*of, looks->preset, wanted),
                                                      of->organ.positions.size());
        warn_of_clips(function, object->effects);
        return object;
    });
}

lapfx_status lapfx_effects_set_preset(lapfx_effects* effects, const lapfx_preset* preset) {
    return call(__func__, [&, function = __func__] {
        const Held<EffectsObject> held(effects, "effects");
        const Held<PresetObject> looks(preset, "preset");
        held->shared->require_current();
        held->effects.set_preset(looks->preset);
        warn_of_clips(function, held->effects);
    });
}

lapfx_status lapfx_effects_draw_organ(lapfx_effects* effects, const lapfx_view* view) {
    return draw(__func__, effects, view, [](lapfx::Effects& e, const lapfx::View& seen) { e.draw_organ(seen); });
}

lapfx_status lapfx_effects_draw_metal_clips(lapfx_effects* effects, const lapfx_view* view) {
    return draw(__func__, effects, view, [](lapfx::Effects& e, const lapfx::View& seen) { e.draw_metal_clips(seen); });
}

lapfx_status lapfx_effects_draw_smoke(lapfx_effects* effects, const lapfx_view* view, unsigned depth) {
    return draw(__func__, effects, view, [&](lapfx::Effects& e, const lapfx::View& seen) {
        if (glIsTexture(depth) == GL_FALSE)
            refuse_value("depth", std::to_string(depth) + " is no texture of the context");
        e.draw_smoke(seen, depth);
    });
}

lapfx_status lapfx_bleeding_shader(const char** text) {
    return call(__func__, [&] {
        given(text, "text");
        static const std::string& kept = *new std::string(lapfx::bleeding_shader());
        *text = kept.c_str();
    });
}

lapfx_status lapfx_effects_bleed_buffer(lapfx_effects* effects, unsigned* buffer) {
    return call(__func__, [&] {
        const Held<EffectsObject> held(effects, "effects");
        held->shared->require_thread();
        *given(buffer, "buffer") = held->effects.bleed_buffer();
    });
}

lapfx_status lapfx_effects_bind_bleeding(lapfx_effects* effects) {
    return call(__func__, [&] {
        const Held<EffectsObject> held(effects, "effects");
        held->shared->require_drawing();
        held->effects.bind_bleeding();
    });
}

lapfx_status lapfx_effects_destroy(lapfx_effects* effects) {
    return destroy<EffectsObject>(__func__, effects, "effects",
                                  [](const EffectsObject& object) { object.shared->require_current(); });
}
