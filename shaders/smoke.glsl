// What plume and haze share: a clip's frame, its keying, and smoke as optical thickness. Variants of
// one shader are made by #define (effects/smoke/smoke_gpu.cpp):
//   LAPFX_PLANAR  frames are planes of luma and chroma, else RGB
//   LAPFX_ALPHA   frames bring their own opacity
//   LAPFX_EDGES   choke or feather is on
//   LAPFX_NOISE   noise varies the opacity
//   LAPFX_DIRECT  each layer goes straight over the frame, else into the sum that resolve.frag lays over it
#include "view.glsl"
#include "smoke_layer.glsl"
#include "keying.glsl"
#include "edges.glsl"

layout(binding = 0) uniform sampler2DArray u_frames;  // RGB, or luma; code values / 255, row 0 = top
#ifdef LAPFX_PLANAR
layout(binding = 1) uniform sampler2DArray u_chroma;  // Cb, Cr at half of the rows and columns
#endif
#ifdef LAPFX_ALPHA
layout(binding = 2) uniform sampler2DArray u_opacity;
#endif
#ifdef LAPFX_NOISE
layout(binding = 3) uniform sampler2D u_noise;  // tiles, a layer's each
#endif
layout(binding = 4) uniform sampler2D u_scene_depth;  // direct: window depth of the scene; else view depth, at this target's size

#ifdef LAPFX_DIRECT
// Dual-source blending: destination * o_transmission + o_light.
layout(location = 0, index = 0) out vec4 o_light;
layout(location = 0, index = 1) out vec4 o_transmission;
#else
layout(location = 0) out vec4 o_sum;  // rgb: colour * thickness; a: thickness
#endif

LapfxKeying keying() {
    return LapfxKeying(u_luma_chroma.x, u_luma_chroma.y, u_key.xy, u_luma_chroma.z, u_luma_chroma.w, u_key.z, u_key.w);
}

// R'G'B' code values of the frame. Chroma is sampled as lying in the middle of its four pixels, which is how RGB frames are
// made of it too: there each chroma sample serves just those four.
vec3 clip_code(vec2 place) {
#ifdef LAPFX_PLANAR
    vec4 code = vec4(textureLod(u_frames, vec3(place, u_vary.w), 0.0).r,
                     textureLod(u_chroma, vec3(place * u_size.zw, u_vary.w), 0.0).rg, 0.0) * 255.0;
    code.w = 1.0;
    return clamp(vec3(dot(u_code_rows[0], code), dot(u_code_rows[1], code), dot(u_code_rows[2], code)), 0.0, 255.0);
#else
    return textureLod(u_frames, vec3(place, u_vary.w), 0.0).rgb * 255.0;
#endif
}

// Opacity before edges and noise: the clip's own where it brings one, else keyed.
float clip_opacity(vec2 place, vec3 code) {
#ifdef LAPFX_ALPHA
    return textureLod(u_opacity, vec3(place, u_vary.w), 0.0).r;
#else
    return lapfx_key_alpha(code, keying());
#endif
}

float lapfx_opacity_at(vec2 position) {
    vec2 place = position / u_size.xy;
    return clip_opacity(place, clip_code(place));
}

// Keyed and varied opacity at drawn coordinates (0..1, origin top left), and the frame's code values there.
float smoke_opacity(vec2 uv, out vec3 code) {
    vec2 place = 0.5 + mat2(u_turn.xy, u_turn.zw) * (uv - 0.5);
    place = abs(place - 2.0 * floor(0.5 * place + 0.5));  // turned beyond its border, the clip goes on as its mirror image
    code = clip_code(place);
#ifdef LAPFX_EDGES
    float alpha = lapfx_edged(place * u_size.xy, u_vary.y, u_vary.z);
#else
    float alpha = clip_opacity(place, code);
#endif
#ifdef LAPFX_NOISE
    // In drawn coordinates: where the clip is mirrored, its noise is not.
    alpha = lapfx_vary_alpha(alpha, textureLod(u_noise, u_tile.xy + uv * u_tile.zw, 0.0).r, u_vary.x);
#endif
    return alpha;
}

// The smoke's colour with the clip's own tint, which real smoke has a little of; brightness is in alpha already.
vec3 tinted(vec3 code) {
    vec2 chroma = lapfx_despill(lapfx_chroma(code), keying()) / max(lapfx_luma(code), 64.0);
    bool keyed_by_chroma = u_luma_chroma.w > 0.0;
    vec3 tint = 1.0 + vec3(1.402 * chroma.y, -0.344 * chroma.x - 0.714 * chroma.y, 1.772 * chroma.x);
    // Over a coloured background the mixture's tint is the background's, unless spill suppression takes it out.
    return u_color.rgb * clamp(keyed_by_chroma ? mix(tint, vec3(1.0), u_key.z) : tint, 0.0, 2.0);
}

// Distance of the scene from the camera plane, mm.
float scene_depth() {
    float depth = texelFetch(u_scene_depth, ivec2(gl_FragCoord.xy), 0).r;
#ifdef LAPFX_DIRECT
    return lapfx_view_depth(depth);
#else
    return depth;
#endif
}

// Smoke of an optical thickness that scatters `color`.
void put(float thickness, vec3 color) {
    // Half floats end at 65504: this times the most layers stays below, and lets no light through.
    thickness = min(thickness, 500.0);
#ifdef LAPFX_DIRECT
    vec3 transmission = exp(-thickness * u_extinction.rgb);
    o_light = vec4(color * (1.0 - transmission), 0.0);
    o_transmission = vec4(transmission, 1.0);
#else
    o_sum = vec4(color, 1.0) * thickness;
#endif
}
