#version 450 core
// Clips of a clip applier: one mesh, placed on the tissue once for each.
#include "view.glsl"

layout(location = 0) in vec3 a_position;  // mm: x along the clip, y away from the tissue
layout(location = 1) in vec3 a_normal;
layout(location = 2) in vec3 a_place;     // the instance lies there, mm, organ space
layout(location = 3) in vec3 a_along;
layout(location = 4) in vec3 a_up;

layout(location = 0) out vec3 v_position;  // mm, organ space
layout(location = 1) out vec3 v_normal;
layout(location = 2) out vec3 v_up;
layout(location = 3) out float v_height;  // mm above the tissue

void main() {
    mat3 frame = mat3(a_along, a_up, cross(a_along, a_up));
    v_position = a_place + frame * a_position;
    v_normal = frame * a_normal;
    v_up = a_up;
    v_height = a_position.y;
    gl_Position = u_projection * u_view * vec4(v_position, 1.0);
}
