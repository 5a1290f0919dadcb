#version 450 core
// Source smoke over the scene, hidden by what is in front of it and soft where it meets the tissue.
#include "smoke.glsl"
#include "plume.glsl"

layout(location = 0) in vec2 v_uv;
layout(location = 1) in vec3 v_camera;

void main() {
    vec3 light, place = lapfx_plume_place(v_uv, u_layers[0].mask_count.zw, u_layers[0].chroma_scale.w);
    vec2 uv = place.xy;
    float alpha = smoke_opacity(0, uv, smoke_noise(uv).x, light);
    float soft = clamp((scene_depth() + v_camera.z) / u_layers[0].amount.y, 0.0, 1.0);
    // An opacity of 1 would be infinite thickness; half a code value remains.
    float thickness = -log(max(1.0 - alpha * soft, 0.002));
    // Clips are rarely empty at their border, but the border of the cropped quad must not show. Thickness fades,
    // because fading opacity would leave thick smoke almost opaque up to the end of the ramp. Below, the fade ends
    // where the smoke starts, however close to the border that is: at the tip the smoke is complete.
    float below = clamp(u_layers[0].chroma_scale.z, 0.002, 0.15);
    vec2 near = smoothstep(vec2(0.0), vec2(0.15), uv - u_layers[0].part.xy);
    vec2 far = smoothstep(vec2(0.0), vec2(0.15, below), u_layers[0].part.zw - uv);
    thickness = bounded(thickness * near.x * near.y * far.x * far.y * place.z * u_layers[0].amount.x);
    vec3 position = u_eye.xyz + transpose(mat3(u_view)) * v_camera;
    put(vec4(light * min(lapfx_lamp(position), 1.6), 1.0) * thickness);
}
