#include <algorithm>
#include <glm/gtc/type_ptr.hpp>

#include "c/calls.h"
#include "c/objects.h"
#include "render/camera.h"

namespace lapfx::c {

namespace {

void put(double (&out)[3], const glm::dvec3& vector) {
    for (int i = 0; i < 3; ++i) out[i] = vector[i];
}
void put(float (&out)[16], const glm::mat4& matrix) {
    std::copy_n(glm::value_ptr(matrix), 16, out);
}

void fill(lapfx_view& out, const View& view) {
    put(out.view, view.view);
    put(out.projection, view.projection);
    out.lamp_intensity = view.lamp.intensity;
    out.lamp_focus_distance = view.lamp.focus_distance;
    out.lamp_beam_angle = view.lamp.beam_angle;
    out.lamp_ambient = view.lamp.ambient;
    put(out.lamp_color, view.lamp.color);
    out.haze = view.haze ? 1 : 0;
}

std::string opened(const Scene& scene, const std::string& file) {
    return file.empty() ? std::string() : (scene.folder / file).string();
}

}  // namespace

SceneObject::SceneObject(Scene given)
    : scene(std::move(given)),
      preset(opened(scene, scene.preset)),
      organ_file(opened(scene, scene.organ.file)),
      organ_texture(opened(scene, scene.organ.texture)) {
    std::ranges::stable_sort(scene.events, {}, &ToolContact::time);
}

void fill(lapfx_contact& out, const ToolContact& contact) {
    out.action = static_cast<int>(contact.action);
    out.time = contact.time;
    out.duration = contact.duration;
    put(out.position, contact.position);
    put(out.to, contact.to);
    out.power = contact.power;
    out.strength = contact.strength;
}

}  // namespace lapfx::c

using namespace lapfx::c;

lapfx_status lapfx_scene_load(const char* path, lapfx_scene** scene) {
    return make<SceneObject>(__func__, scene, "scene",
                             [&] { return std::make_unique<SceneObject>(lapfx::load_scene(given(path, "path"))); });
}

lapfx_status lapfx_scene_get_info(const lapfx_scene* scene, lapfx_scene_info* info) {
    return call(__func__, [&] {
        const Held<SceneObject> held(scene, "scene");
        const lapfx::Scene& s = held->scene;
        lapfx_scene_info& out = LAPFX_SIZED(lapfx_scene_info, info);
        out.name = s.name.c_str();
        out.preset = held->preset.c_str();
        out.duration = s.duration;
        out.seed = static_cast<std::uint32_t>(s.seed);
        put(out.gravity, s.gravity);
        out.organ_file = held->organ_file.c_str();
        out.organ_scale = s.organ.scale;
        put(out.organ_rotation, s.organ.rotation);
        out.organ_texture = held->organ_texture.c_str();
        put(out.organ_color, s.organ.color);
        put(out.eye, s.camera.eye);
        put(out.target, s.camera.target);
        put(out.up, s.camera.up);
        out.field_of_view = s.camera.field_of_view;
        out.exposure = s.camera.exposure;
        out.vignette = s.camera.vignette;
        out.lamp_intensity = s.light.intensity;
        out.lamp_focus_distance = s.light.focus_distance;
        out.lamp_beam_angle = s.light.beam_angle;
        put(out.lamp_color, s.light.color);
        out.event_count = s.events.size();
    });
}

lapfx_status lapfx_scene_get_event(const lapfx_scene* scene, size_t index, lapfx_contact* contact) {
    return call(__func__, [&] {
        const Held<SceneObject> held(scene, "scene");
        lapfx_contact& out = LAPFX_SIZED(lapfx_contact, contact);
        fill(out, held->scene.events[index_below(index, held->scene.events.size(), "events")]);
    });
}

lapfx_status lapfx_scene_get_view(const lapfx_scene* scene, int width, int height, lapfx_view* view) {
    return call(__func__, [&] {
        const Held<SceneObject> held(scene, "scene");
        lapfx_view& out = LAPFX_SIZED(lapfx_view, view);
        positive_size(width, height);
        const lapfx::Scene& s = held->scene;
        fill(out, lapfx::render::view_of(s.camera, s.light, {width, height}));
    });
}

lapfx_status lapfx_scene_get_response(const lapfx_scene* scene, lapfx_response* response) {
    return call(__func__, [&] {
        const Held<SceneObject> held(scene, "scene");
        lapfx_response& out = LAPFX_SIZED(lapfx_response, response);
        const lapfx::CameraResponse shown = held->scene.camera.response();
        out.exposure = shown.exposure;
        out.vignette = shown.vignette;
        put(out.white_balance, shown.white_balance);
        out.sharpening = shown.sharpening;
        out.saturation = shown.saturation;
        out.lens_falloff = shown.lens_falloff;
        out.curve = static_cast<int>(shown.curve);
        out.toe = shown.toe;
        out.knee = shown.knee;
        out.white = shown.white;
    });
}

lapfx_status lapfx_scene_load_organ(const lapfx_scene* scene, lapfx_organ** organ) {
    return make<OrganObject>(__func__, organ, "organ", [&, function = __func__] {
        const Held<SceneObject> held(scene, "scene");
        if (held->scene.plate.use)
            refuse_value("scene",
                         "shows a plate, a frame of its reference, instead of an organ: only lapfx itself can");
        const lapfx::SceneOrgan& from = held->scene.organ;
        return organ_object(function,
                            lapfx::load_organ(held->organ_file, {from.scale, from.rotation, held->organ_texture}));
    });
}

lapfx_status lapfx_scene_destroy(lapfx_scene* scene) {
    return destroy<SceneObject>(__func__, scene, "scene", [](const SceneObject&) {});
}
