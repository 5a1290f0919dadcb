#version 450 core
// A speck of fat: a lump of its own shape, wet and lit by the lamp, glowing while it is young (paper: future work,
// "tiny fat particles" made "at the fragment shader level").
#include "view.glsl"

layout(binding = 1) uniform sampler2D u_scene_depth;  // window depth of what has been drawn

layout(location = 0) in vec2 v_corner;
layout(location = 1) in vec3 v_camera;
layout(location = 2) in flat vec4 v_look;
layout(location = 3) in flat vec3 v_center;

layout(location = 0) out vec4 o_color;  // premultiplied

uniform vec3 u_color;  // linear

const vec3 glow_color = vec3(1.0, 0.36, 0.08);  // linear; soot in a small flame, about 1900 K

// Radius of the outline in a direction, 0..1: three waves around the lump, rotated at random.
float outline(float angle, float chance) {
    float turn = 6.2831853 * chance;
    float wave = 0.5 * sin(2.0 * angle + turn) + 0.3 * sin(3.0 * angle + 5.0 * turn) + 0.2 * sin(5.0 * angle + 11.0 * turn);
    return 0.78 + 0.22 * wave;
}

void main() {
    float radius = length(v_corner);
    float share = radius / outline(atan(v_corner.y, v_corner.x + 1e-6), v_look.z);
    float coverage = 1.0 - smoothstep(0.75, 1.0, share);
    float window = texelFetch(u_scene_depth, ivec2(gl_FragCoord.xy), 0).r;
    float scene = u_projection[3][2] / (2.0 * window - 1.0 + u_projection[2][2]);  // mm from the camera plane
    float alpha = scene > -v_camera.z ? coverage * v_look.x : 0.0;
    // A lump: its middle faces the lamp, which is at the camera; its rim is turned away.
    float facing = sqrt(max(1.0 - share * share, 0.0));
    vec3 lit = u_color * (0.35 + 0.65 * facing) * min(lapfx_lamp(v_center), 1.6);
    vec3 gleam = vec3(0.5 * pow(facing, 16.0)) * min(lapfx_lamp(v_center), 1.6);  // molten fat is wet
    o_color = vec4(lapfx_drawn_light(lit + gleam + 1.5 * v_look.y * glow_color) * alpha, alpha);
}
