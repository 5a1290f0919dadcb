#version 450 core
// Source smoke over the scene, hidden by what is in front of it and soft where it meets the tissue.
#include "smoke.glsl"

layout(location = 0) in vec2 v_uv;
layout(location = 1) in vec3 v_camera;

void main() {
    vec3 code;
    float alpha = smoke_opacity(0, v_uv, smoke_noise(v_uv).x, code);
    // Clips are rarely empty at their border; the quad's must not show.
    vec2 border = smoothstep(vec2(0.0), vec2(0.08), v_uv) * smoothstep(vec2(0.0), vec2(0.08), 1.0 - v_uv);
    float soft = clamp((scene_depth() + v_camera.z) / u_layers[0].amount.y, 0.0, 1.0);
    // Whole opacity would be endless thickness; half a code value is left.
    float left = max(1.0 - alpha * border.x * border.y * soft, 0.002);
    float thickness = bounded(-log(left) * u_layers[0].amount.x);
    vec3 position = u_eye.xyz + transpose(mat3(u_view)) * v_camera;
    put(vec4(tint(0, code) * min(lapfx_lamp(position), 1.6), 1.0) * thickness);
}
