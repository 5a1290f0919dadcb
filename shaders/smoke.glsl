// What plume and haze share: a clip's frame, its keying, and smoke as light added and light let through. Filled from
// effects/smoke/smoke_gpu.cpp.
#include "view.glsl"
#include "color.glsl"
#include "noise.glsl"
#include "keying.glsl"

layout(std140, binding = 2) uniform LapfxSmoke {
    vec4 u_luma_chroma;   // luma low, luma high, chroma low, chroma high; code values
    vec4 u_key_color;     // rgb code values 0..255; a: spill
    vec4 u_vary;          // noise scale (clip heights), strength, drift (clip heights/s), seed
    vec4 u_color;         // rgb linear colour of the smoke; a: 1 = dark polarity
    vec4 u_extinction;    // rgb: exponent of the transmission per channel; a: density
    vec4 u_clip;          // x: aspect (width / height); y: mirror -1 or 1; z: time s; w: soft distance mm
};

layout(binding = 0) uniform sampler2D u_frame;        // RGB in code values / 255, row 0 = top
layout(binding = 1) uniform sampler2D u_scene_depth;  // window depth of what has been drawn

// Dual-source blending: destination * o_transmission + o_light.
layout(location = 0, index = 0) out vec4 o_light;
layout(location = 0, index = 1) out vec4 o_transmission;

LapfxKeying keying() {
    return LapfxKeying(u_luma_chroma.x, u_luma_chroma.y, lapfx_chroma(u_key_color.rgb), u_luma_chroma.z,
                       u_luma_chroma.w, u_key_color.a, u_color.a);
}

// Keyed and varied opacity at clip coordinates (origin top left), and the frame's code values there.
float keyed_alpha(vec2 uv, out vec3 code) {
    code = texture(u_frame, u_clip.y < 0.0 ? vec2(1.0 - uv.x, uv.y) : uv).rgb * 255.0;
    vec3 p = vec3(uv.x * u_clip.x, uv.y + u_vary.z * u_clip.z, 0.35 * u_vary.z * u_clip.z) / u_vary.x;
    float noise = lapfx_fractal_noise(p, 2, uint(u_vary.w)).x;
    return lapfx_vary_alpha(lapfx_key_alpha(code, keying()), noise, u_vary.y);
}

// The smoke's colour with the clip's own tint, which real smoke has a little of; brightness is in alpha already.
vec3 tinted(vec3 code) {
    vec2 chroma = lapfx_despill(lapfx_chroma(code), keying()) / max(lapfx_luma(code), 64.0);
    bool keyed_by_chroma = u_luma_chroma.w > 0.0;
    vec3 tint = 1.0 + vec3(1.402 * chroma.y, -0.344 * chroma.x - 0.714 * chroma.y, 1.772 * chroma.x);
    // Over a coloured background the mixture's tint is the background's, unless spill suppression takes it out.
    return u_color.rgb * clamp(keyed_by_chroma ? mix(tint, vec3(1.0), u_key_color.a) : tint, 0.0, 2.0);
}

// Distance from the camera plane, mm, of a window depth.
float view_depth(float depth) {
    return u_projection[3][2] / (2.0 * depth - 1.0 + u_projection[2][2]);
}

// Smoke that scatters `color` and lets 1 - alpha through, per channel: red passes more than blue.
void put(float alpha, vec3 color) {
    vec3 transmission = pow(vec3(1.0 - alpha), u_extinction.rgb);
    o_light = vec4(color * (1.0 - transmission), 0.0);
    o_transmission = vec4(transmission, 1.0);
}
