#version 450 core
// Source smoke: a quad that faces the camera, anchored where the clip's smoke starts, at the tool tip. Its corners come
// from effects/smoke/plume.h.
#include "view.glsl"
#include "smoke_layer.glsl"

layout(location = 0) out vec2 v_uv;      // drawn coordinates, origin top left
layout(location = 1) out vec3 v_camera;  // camera space, mm

void main() {
    v_uv = vec2(gl_VertexID & 1, gl_VertexID >> 1);
    v_camera = u_layers[0].corners[gl_VertexID].xyz;
    gl_Position = u_projection * vec4(v_camera, 1.0);
}
