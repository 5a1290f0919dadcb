// Blood on an organ (paper: "Simulation of bleeding", figure 6, fragment shader stage). Include this in an organ shader,
// bind the uniform block that effects/bleeding/bleed_gpu.h fills, pass the bleed value per vertex, and call lapfx_blood().
// Lengths mm in organ space (rest shape), colours linear. Needs noise.glsl.
#include "noise.glsl"

layout(std140, binding = 1) uniform LapfxBleeding {
    vec4 u_blood_edge;    // threshold, noise scale, noise strength, octaves
    vec4 u_blood_thin;    // rgb of a thin film; a: depth at which the pool's colour is reached
    vec4 u_blood_deep;    // rgb of a deep pool; a: opacity of a deep pool
    vec4 u_blood_surface; // thickness of the layer, gloss, seed, unused
};

struct LapfxBlood {
    float coverage;   // 0..1, how much of the pixel is blood
    float depth;      // mm beyond the edge: bleed value minus (threshold + noise)
    vec3 color;       // body colour along the gradient thin to deep
    float opacity;    // 0..1, how much of the tissue it hides
    vec3 slope;       // gradient of the layer's height over organ space, for the normal
};

// `bleed`: interpolated bleed value, mm. `slope`: its gradient over organ space. `position`: rest position, mm.
LapfxBlood lapfx_blood(float bleed, vec3 slope, vec3 position) {
    float threshold = u_blood_edge.x, scale = u_blood_edge.y, strength = u_blood_edge.z;
    // Nothing can bleed below threshold - strength, so most of an organ runs no octave at all.
    bool possible = bleed > threshold - strength;
    int octaves = possible ? int(u_blood_edge.w) : 0;
    vec4 noise = lapfx_fractal_noise(position / scale, octaves, uint(u_blood_surface.z));

    LapfxBlood blood;
    blood.depth = possible ? bleed - (threshold + strength * noise.x) : -1.0;
    float width = max(fwidth(blood.depth), 1e-3);
    blood.coverage = possible ? clamp(blood.depth / width + 0.5, 0.0, 1.0) : 0.0;

    float depth = max(blood.depth, 0.0);
    float pooled = 1.0 - exp2(-3.0 * depth / u_blood_thin.a);
    blood.color = mix(u_blood_thin.rgb, u_blood_deep.rgb, pooled);
    // A thin film lets the tissue through (Beer-Lambert); deep blood hides it.
    blood.opacity = u_blood_deep.a * (1.0 - exp2(-2.0 * depth - 0.8));

    // The layer rises steeply at its rim (the meniscus) and is flat inside: height = thickness * (1 - exp(-depth / rim)).
    float rim = 0.9;
    float steep = u_blood_surface.x / rim * exp(-depth / rim);
    blood.slope = steep * (0.5 * slope - strength / scale * noise.yzw);
    // Blood on living tissue is never still: a gentle swell breaks its highlights up.
    vec4 swell = lapfx_fractal_noise(position / 3.5, min(octaves, 1), uint(u_blood_surface.z) + 31u);
    blood.slope += 0.16 * clamp(depth / 1.5, 0.0, 1.0) * swell.yzw;
    return blood;
}
