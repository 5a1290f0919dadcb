#version 450 core
// The Perlin noise on the opacity of one to four layers, a channel each (paper: "perturb alpha using a Perlin noise
// texture"), computed for every frame, so that it drifts without ever repeating. Two octaves. Filled from
// effects/smoke/noise_tiles_gpu.cpp.
#include "noise.glsl"

layout(location = 0) in vec2 v_uv;

uniform vec2 u_texels;  // of this tile
uniform vec2 u_lobes;   // across the clip and down
uniform vec4 u_drift;   // how far the noise has moved, lobes within 0..1: y, z of the first octave, y, z of the second
uniform ivec4 u_from;   // and the whole lobes of the same
uniform ivec4 u_seeds;
uniform int u_count;

layout(location = 0) out vec4 o_noise;  // 0..1 is -1..1

void main() {
    // The middles of the outermost texels lie on the clip's borders, so that filtering never reads from another tile.
    vec2 place = (v_uv * u_texels - 0.5) / (u_texels - 1.0);
    vec3 p = vec3(place * u_lobes, 0.0);
    vec4 noise = vec4(0.0);
    float value = 0.0;
    for (int i = 0; i < u_count; ++i) {
        uint seed = uint(u_seeds[i]);
        // Both halves of a cross-fade are next to each other and share their noise.
        if (i == 0 || u_seeds[i] != u_seeds[i - 1]) {
            float large = lapfx_perlin_from(ivec3(0, u_from.xy), p + vec3(0.0, u_drift.xy), seed).x;
            float small = lapfx_perlin_from(ivec3(0, u_from.zw), 2.0 * p + vec3(0.0, u_drift.zw), seed + 1u).x;
            value = (large + 0.5 * small) / 1.5;
        }
        noise += value * vec4(equal(ivec4(0, 1, 2, 3), ivec4(i)));
    }
    o_noise = 0.5 + 0.5 * noise;
}
