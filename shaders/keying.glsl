// Smoke out of a video frame (paper: figure 1): luma and chroma thresholds remove the background, and Perlin noise
// varies the rest. Mirrored on the CPU by effects/smoke/keying_pixel.h; tests/parity/keying_test.cpp compares them.
// Code values: 0..255 as in the clip, BT.601 luma and chroma (full range).

struct LapfxKeying {
    float luma_low, luma_high;      // background at or below low, full smoke at or above high
    vec2 key_chroma;                // Cb, Cr of the background colour, code values around 0
    float chroma_low, chroma_high;  // the same for the distance from key_chroma; high 0 = not used
    float spill;                    // 0..1, how much of the background's colour is removed from the smoke
    float dark;                     // 1: smoke is darker than its background
};

float lapfx_luma(vec3 code) { return dot(code, vec3(0.299, 0.587, 0.114)); }

vec2 lapfx_chroma(vec3 code) {
    float luma = lapfx_luma(code);
    return vec2((code.b - luma) / 1.772, (code.r - luma) / 1.402);
}

// Clamped to 0..1; NaN, from a pixel that has one, counts as 0 (clamp() could give anything).
float lapfx_unit(float x) { return x > 0.0 ? min(x, 1.0) : 0.0; }

float lapfx_ramp(float value, float low, float high) { return lapfx_unit((value - low) / max(high - low, 1e-3)); }

// Opacity 0..1 of the smoke in one pixel is the product of these two. The ramps are linear because smoke of one colour
// mixes linearly with a flat background: luma and chroma distance both grow in proportion to its opacity.
float lapfx_key_luma(float luma, LapfxKeying key) {
    return lapfx_ramp(key.dark > 0.5 ? 255.0 - luma : luma, key.luma_low, key.luma_high);
}

float lapfx_key_chroma(vec2 chroma, LapfxKeying key) {
    return key.chroma_high > 0.0 ? lapfx_ramp(distance(chroma, key.key_chroma), key.chroma_low, key.chroma_high) : 1.0;
}

float lapfx_key_alpha(vec3 code, LapfxKeying key) {
    return lapfx_key_luma(lapfx_luma(code), key) * lapfx_key_chroma(lapfx_chroma(code), key);
}

// The smoke's own chroma, code values: `spill` removes the part in the direction of the background's colour.
vec2 lapfx_despill(vec2 chroma, LapfxKeying key) {
    float strength = dot(key.key_chroma, key.key_chroma);
    float lean = strength > 1.0 ? max(dot(chroma, key.key_chroma) / strength, 0.0) : 0.0;
    return chroma - key.spill * lean * key.key_chroma;
}

// The smoke's own tint, 1 where it is grey; alpha already includes brightness. `chroma` is without spill.
vec3 lapfx_tint(float luma, vec2 chroma) {
    vec2 share = chroma / max(luma, 64.0);
    return clamp(1.0 + vec3(1.402 * share.y, -0.344 * share.x - 0.714 * share.y, 1.772 * share.x), 0.0, 2.0);
}

// How brightly smoke is lit, 1 from middle grey on, if its opacity comes from the clip itself. When keyed by luma,
// brighter only means denser, and dense smoke is lit to 1; here luma can distinguish light from shadow. The clip's
// colour counts as premultiplied, as in clips over black. In very thin smoke colour over opacity is only rounding, so
// adding 0.05 to both draws it to 1. Squared code values are almost linear light. The result is bounded: dark smoke
// does not turn black, white smoke is as bright as the same clip keyed from black, and the edge of a clip with straight
// alpha does not glow.
float lapfx_shade(float luma, float alpha) {
    float own = (max(luma, 0.0) / 128.0 + 0.05) / (lapfx_unit(alpha) + 0.05);
    return clamp(own * own, 0.1, 1.0);
}

// Alpha varied by noise in -1..1: mean kept, never outside 0..1.
float lapfx_vary_alpha(float alpha, float noise, float strength) {
    return lapfx_unit(alpha * (1.0 + strength * noise));
}
