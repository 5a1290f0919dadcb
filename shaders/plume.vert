#version 450 core
// Source smoke: a quad that faces the camera, anchored where the clip's smoke starts, at the tool tip.
#include "view.glsl"

uniform vec3 u_anchor;   // organ space, mm
uniform vec2 u_extent;   // width and height of the whole clip at the tip, mm
uniform vec2 u_source;   // where in the clip (0..1, origin top left) the smoke starts
uniform vec2 u_up;       // unit, camera plane: where smoke rises to
uniform float u_lean;    // mm towards the camera per mm of rise

layout(location = 0) out vec2 v_uv;      // clip coordinates, origin top left
layout(location = 1) out vec3 v_camera;  // camera space, mm

void main() {
    vec2 uv = vec2(gl_VertexID & 1, gl_VertexID >> 1);
    vec2 offset = vec2(uv.x - u_source.x, u_source.y - uv.y) * u_extent;
    vec2 right = vec2(u_up.y, -u_up.x);
    vec4 center = u_view * vec4(u_anchor, 1.0);
    v_uv = uv;
    v_camera = center.xyz + vec3(right * offset.x + u_up * offset.y, u_lean * max(offset.y, 0.0));
    // Leaning over must not bring the smoke to the lens, where it would fill the view.
    v_camera.z = min(v_camera.z, 0.45 * center.z);
    gl_Position = u_projection * vec4(v_camera, 1.0);
}
