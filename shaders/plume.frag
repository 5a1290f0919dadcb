#version 450 core
// Source smoke over the scene, hidden by what is in front of it and soft where it meets the tissue.
#include "smoke.glsl"

layout(location = 0) in vec2 v_uv;
layout(location = 1) in vec3 v_camera;

void main() {
    vec3 light;
    float alpha = smoke_opacity(0, v_uv, smoke_noise(v_uv).x, light);
    float soft = clamp((scene_depth() + v_camera.z) / u_layers[0].amount.y, 0.0, 1.0);
    // Whole opacity would be endless thickness; half a code value is left.
    float thickness = -log(max(1.0 - alpha * soft, 0.002));
    // Clips are rarely empty at their border; that of the quad, or of what the crop leaves of it, must not show.
    // Thickness is what fades: fading opacity would leave thick smoke nearly whole up to the end of the ramp. Below, it
    // ends where the smoke starts, however near to the border that is: on the tip there is all of it.
    float below = clamp(u_layers[0].chroma_scale.z, 0.002, 0.15);
    vec2 near = smoothstep(vec2(0.0), vec2(0.15), v_uv - u_layers[0].part.xy);
    vec2 far = smoothstep(vec2(0.0), vec2(0.15, below), u_layers[0].part.zw - v_uv);
    thickness = bounded(thickness * near.x * near.y * far.x * far.y * u_layers[0].amount.x);
    vec3 position = u_eye.xyz + transpose(mat3(u_view)) * v_camera;
    put(vec4(light * min(lapfx_lamp(position), 1.6), 1.0) * thickness);
}
