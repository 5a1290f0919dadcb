#version 450 core
// Titanium under the endoscope's lamp. A metal reflects its surroundings: the lamp as a highlight, and lit tissue below
// and beyond.
#include "view.glsl"

layout(location = 0) in vec3 v_position;
layout(location = 1) in vec3 v_normal;
layout(location = 2) in vec3 v_up;
layout(location = 3) in float v_height;

layout(location = 0) out vec4 o_color;

const vec3 titanium = vec3(0.55, 0.53, 0.51);  // reflectance head on, linear
const float pi = 3.14159265;

// GGX with Smith's visibility (Hammon 2017); without Fresnel, which hardly matters for a metal.
float lobe(vec3 n, vec3 v, vec3 l, float roughness) {
    vec3 h = normalize(v + l);
    float a = roughness * roughness, nh = max(dot(n, h), 0.0), nl = max(dot(n, l), 0.0), nv = max(dot(n, v), 1e-3);
    float d = nh * nh * (a * a - 1.0) + 1.0;
    return a * a / (pi * d * d) * 0.5 / max(mix(2.0 * nl * nv, nl + nv, a), 1e-3) * nl;
}

// Light from a direction, as a share of the lamp's light on the clip: tissue next to it gets the same light, tissue
// beyond is farther away.
vec3 surroundings(vec3 direction, vec3 up) {
    const vec3 near = vec3(0.20, 0.05, 0.04), far = vec3(0.11, 0.08, 0.075);
    return mix(near, far, smoothstep(-0.3, 0.5, dot(direction, up)));
}

void main() {
    vec3 normal = normalize(v_normal), up = normalize(v_up), view = normalize(u_eye.xyz - v_position);
    // Beside the lens, as for tissue.
    vec3 light = normalize(u_eye.xyz - v_position + 4.0 * vec3(u_view[0][1], u_view[1][1], u_view[2][1]));
    vec3 lamp = lapfx_lamp(v_position);
    vec3 fresnel = titanium + (1.0 - titanium) * pow(1.0 - max(dot(normal, view), 0.0), 5.0);
    // Ground titanium: a sharp highlight within a broad one.
    float shine = 0.45 * lobe(normal, view, light, 0.24) + 0.3 * lobe(normal, view, light, 0.5);
    float open = smoothstep(-0.1, 0.6, v_height);  // the gap and the foot are in the shade
    vec3 mirrored = surroundings(reflect(-view, normal), up) * mix(0.2, 1.0, open);
    o_color = vec4(lapfx_drawn_light(fresnel * lamp * (mirrored + pi * shine * mix(0.25, 1.0, open))), 1.0);
}
