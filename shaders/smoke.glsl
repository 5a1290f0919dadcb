// Shared by plume and haze: a clip's frame, its keying, and smoke as optical thickness. Variants of one shader are made
// by #define (effects/smoke/smoke_gpu.cpp):
//   LAPFX_LAYERS  how many clips are drawn at once, 1 to 4; haze only
//   LAPFX_PLANAR  frames are planes of luma and chroma, else RGB
//   LAPFX_ALPHA   frames bring their own opacity
//   LAPFX_CHROMA  keyed by chroma, or spill is taken out
//   LAPFX_EDGES   choke or feather is on
//   LAPFX_NOISE   noise varies the opacity
//   LAPFX_TURNED  the clip is turned by an angle, not only mirrored
//   LAPFX_WINDOW  the clip is cropped, fades at its edges or has masks
//   LAPFX_DIRECT  the layer goes straight over the frame, else into the sum that resolve.frag lays over it
#include "view.glsl"
#include "smoke_layer.glsl"
#include "keying.glsl"
#include "edges.glsl"
#include "window.glsl"

layout(binding = 0) uniform sampler2DArray u_frames[LAPFX_LAYERS];  // RGB, or luma; row 0 = top
#ifdef LAPFX_PLANAR
layout(binding = 4) uniform sampler2DArray u_chroma[LAPFX_LAYERS];  // Cb, Cr at half of the rows and columns
#endif
#ifdef LAPFX_ALPHA
layout(binding = 8) uniform sampler2DArray u_opacity[LAPFX_LAYERS];
#endif
#ifdef LAPFX_NOISE
layout(binding = 12) uniform sampler2D u_noise;  // tiles; a channel for each layer drawn at once; 0..1 is -1..1
#endif
// Direct: window depth; otherwise view depth, mm, at this target's size.
layout(binding = 13) uniform sampler2D u_scene_depth;

#ifdef LAPFX_DIRECT
// Dual-source blending: destination * o_transmission + o_light.
layout(location = 0, index = 0) out vec4 o_light;
layout(location = 0, index = 1) out vec4 o_transmission;
#else
layout(location = 0) out vec4 o_sum;  // rgb: light and tint of the smoke * thickness; a: thickness
#endif

LapfxKeying keying(int i) {
    vec4 ramps = u_layers[i].luma_chroma, key = u_layers[i].key;
    return LapfxKeying(ramps.x, ramps.y, key.xy, ramps.z, ramps.w, key.z, key.w);
}

// Luma, Cb and Cr (around 0) of layer i, code values. Chroma is sampled in the middle of its four pixels, as in RGB
// frames made from it, where each chroma sample serves exactly those four.
vec3 clip_code(int i, vec2 place) {
    float array_layer = u_layers[i].vary.w;
#ifdef LAPFX_PLANAR
    vec3 sampled = vec3(textureLod(u_frames[i], vec3(place, array_layer), 0.0).r,
                        textureLod(u_chroma[i], vec3(place * u_layers[i].chroma_scale.xy, array_layer), 0.0).rg);
#else
    vec3 sampled = textureLod(u_frames[i], vec3(place, array_layer), 0.0).rgb;
#endif
    vec4 y = u_layers[i].code_rows[0], cb = u_layers[i].code_rows[1], cr = u_layers[i].code_rows[2];
    return vec3(dot(y.xyz, sampled) + y.w, dot(cb.xyz, sampled) + cb.w, dot(cr.xyz, sampled) + cr.w);
}

// 0 where the crop or a mask removes the clip.
float clip_window(int i, vec2 place) {
#ifdef LAPFX_WINDOW
    vec2 position = place * u_layers[i].amount.zw;
    float share = lapfx_inside(position, u_layers[i].window, u_layers[i].fades);
    for (int mask = 0; mask < int(u_layers[i].mask_count.x); ++mask)
        share *= lapfx_outside(position, u_layers[i].masks[mask], u_layers[i].mask_count.y);
    return share;
#else
    return 1.0;
#endif
}

float keyed_opacity(int i, vec2 place, vec3 code) {
#if defined LAPFX_ALPHA
    return textureLod(u_opacity[i], vec3(place, u_layers[i].vary.w), 0.0).r;
#elif defined LAPFX_CHROMA
    return lapfx_key_luma(code.x, keying(i)) * lapfx_key_chroma(code.yz, keying(i));
#else
    return lapfx_key_luma(code.x, keying(i));
#endif
}

// Opacity before edges and noise: the clip's own, if it has one, otherwise the keyed one.
float clip_opacity(int i, vec2 place, vec3 code) { return keyed_opacity(i, place, code) * clip_window(i, place); }

int edged_layer = 0;

float lapfx_opacity_at(vec2 position) {
#if defined LAPFX_WINDOW && defined LAPFX_FILLS_VIEW
    vec4 window = u_layers[edged_layer].window;  // like a frame without bars beyond its edges
    position = clamp(position, window.xy + 0.5, window.zw - 0.5);
#endif
    vec2 place = position / u_layers[edged_layer].amount.zw;
    return clip_opacity(edged_layer, place, clip_code(edged_layer, place));
}

// The clip's own tint, of which real smoke has a little, and its shading if its opacity does not include its
// brightness.
vec3 own_light(int i, vec2 place, vec3 code) {
#ifdef LAPFX_ALPHA
    float shade = lapfx_shade(code.x, textureLod(u_opacity[i], vec3(place, u_layers[i].vary.w), 0.0).r);
#else
    const float shade = 1.0;
#endif
#ifdef LAPFX_CHROMA
    vec3 own = lapfx_tint(code.x, lapfx_despill(code.yz, keying(i)));
    // Over a coloured background the mixture has the tint of the background, unless spill suppression removes it.
    return shade * (u_layers[i].luma_chroma.w > 0.0 ? mix(own, vec3(1.0), u_layers[i].key.z) : own);
#else
    return shade * lapfx_tint(code.x, code.yz);
#endif
}

// Keyed and varied opacity of layer i at drawn coordinates (0..1, origin top left), and the smoke's own light there.
float smoke_opacity(int i, vec2 uv, float noise, out vec3 light) {
    vec4 turn = u_layers[i].turn;
#ifdef LAPFX_TURNED
    vec2 place = 0.5 + turn.xy * (uv.x - 0.5) + turn.zw * (uv.y - 0.5);
    // Beyond the border of a rotated clip, its mirror image continues.
    place = abs(place - 2.0 * floor(0.5 * place + 0.5));
#else
    vec2 place = vec2(0.5 + turn.x * (uv.x - 0.5), uv.y);
#endif
#if defined LAPFX_WINDOW && defined LAPFX_FILLS_VIEW
    place = u_layers[i].part.xy + place * u_layers[i].part.zw;  // the cropped frame is as large as the view
#endif
    vec3 code = clip_code(i, place);
    light = own_light(i, place, code);
#ifdef LAPFX_EDGES
    edged_layer = i;
    float alpha = lapfx_edged(place * u_layers[i].amount.zw, u_layers[i].vary.y, u_layers[i].vary.z);
#else
    float alpha = clip_opacity(i, place, code);
#endif
#ifdef LAPFX_NOISE
    alpha = lapfx_vary_alpha(alpha, noise, u_layers[i].vary.x);
#endif
    return alpha;
}

// The noise of all layers, each -1..1. In drawn coordinates: the noise of a mirrored clip is not mirrored.
vec4 smoke_noise(vec2 uv) {
#ifdef LAPFX_NOISE
    return textureLod(u_noise, u_layers[0].tile.xy + uv * u_layers[0].tile.zw, 0.0) * 2.0 - 1.0;
#else
    return vec4(0.0);
#endif
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

// Half floats end at 65504: this times the most layers stays below, and lets no light through.
float bounded(float thickness) { return min(thickness, 500.0); }

// `sum`: rgb, light and tint * thickness; a, thickness.
void put(vec4 sum) {
#ifdef LAPFX_DIRECT
    vec3 transmission = exp(-sum.a * u_layers[0].extinction.rgb);
    vec3 light = lapfx_drawn_light(u_layers[0].color.rgb * sum.rgb / max(sum.a, 1e-6));
    o_light = vec4(light * (1.0 - transmission), 0.0);
    o_transmission = vec4(transmission, 1.0);
#else
    o_sum = sum;
#endif
}
