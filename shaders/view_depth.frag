#version 450 core
// The scene's distance from the camera plane, mm, at the middle of each pixel of a smaller target.
#include "view.glsl"

layout(location = 0) in vec2 v_uv;

layout(binding = 13) uniform sampler2D u_scene_depth;  // window depth, the size of the frame
uniform vec4 u_viewport;                              // xy: lower left corner, zw: size; pixels of the frame

layout(location = 0) out float o_depth;

void main() {
    o_depth = lapfx_view_depth(texelFetch(u_scene_depth, ivec2(u_viewport.xy + v_uv * u_viewport.zw), 0).r);
}
