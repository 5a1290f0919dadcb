#version 450 core
// Specks of fat: one small quad each that faces the camera. Filled from effects/smoke/particles_gpu.h.
#include "view.glsl"

layout(std140, binding = 2) uniform LapfxSpecks {
    vec4 u_specks[512];  // in pairs: xyz mm and diameter; opacity, glow, shape 0..1, unused
};

layout(binding = 1) uniform sampler2D u_scene_depth;

layout(location = 0) out vec2 v_corner;       // -1..1 across the quad
layout(location = 1) out vec3 v_camera;       // camera space, mm
layout(location = 2) out flat vec4 v_look;
layout(location = 3) out flat vec3 v_center;  // organ space, mm

void main() {
    vec4 place = u_specks[2 * gl_InstanceID];
    v_look = u_specks[2 * gl_InstanceID + 1];
    v_center = place.xyz;
    vec4 center = u_view * vec4(place.xyz, 1.0);
    // A speck of less than a few pixels would flicker from sample to sample, so it keeps that size and pales instead.
    float pixel = 2.0 * max(-center.z, 0.0) / (u_projection[1][1] * float(textureSize(u_scene_depth, 0).y));
    float radius = max(0.5 * place.w, 2.0 * pixel);
    v_look.x *= min(0.25 * place.w * place.w / (radius * radius), 1.0);
    v_corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
    v_camera = center.xyz + vec3(v_corner * radius, 0.0);
    gl_Position = u_projection * vec4(v_camera, 1.0);
}
