// The vertex stage of organs and instruments. It passes the bleed value on to be interpolated, as in the paper's figure
// 6.
#include "view.glsl"

layout(location = 0) in vec3 a_position;  // mm, as the organ is now
layout(location = 1) in vec3 a_normal;
layout(location = 2) in vec4 a_tangent;
layout(location = 3) in vec2 a_uv;
layout(location = 4) in vec4 a_color;     // linear
layout(location = 5) in vec2 a_blood;     // bleed value, mm; how far the blood has clotted, 0..1
layout(location = 6) in vec2 a_marks;     // char, 0..1; how far the tissue is divided, 0..1
layout(location = 7) in vec3 a_rest;      // mm, rest shape: noise and textures stay on the tissue when it moves
layout(location = 8) in vec2 a_density;   // vessels and fat, 0..1, times the density texture; for the overlay

uniform mat4 u_model;  // organ space to scene space; rigid

layout(location = 0) out vec3 v_position;  // scene space, mm
layout(location = 1) out vec3 v_rest;      // organ space, mm, rest shape
layout(location = 2) out vec3 v_normal;
layout(location = 3) out vec4 v_tangent;
layout(location = 4) out vec2 v_uv;
layout(location = 5) out vec4 v_color;
layout(location = 6) out vec2 v_blood;
layout(location = 7) out vec2 v_marks;
layout(location = 8) out vec2 v_density;

// Both programs must place a vertex identically to the last bit: see OrganGpu::draw.
invariant gl_Position;

void pass_vertex() {
    vec4 position = u_model * vec4(a_position, 1.0);
    v_position = position.xyz;
    v_rest = a_rest;
    v_normal = mat3(u_model) * a_normal;
    v_tangent = vec4(mat3(u_model) * a_tangent.xyz, a_tangent.w);
    v_uv = a_uv;
    v_color = a_color;
    v_blood = a_blood;
    v_marks = a_marks;
    v_density = a_density;
    gl_Position = u_projection * (u_view * position);
}
