// Blood on an organ (paper: "Simulation of bleeding", figure 6, fragment shader stage). It works in lapfx's own organ
// shader and in a host's: paste this text (lapfx::bleeding_shader() gives it with its includes), bind the uniform block
// (Effects::bind_bleeding), pass Effects::bleed_buffer() through the vertex shader as a vec2, and call lapfx_blood().
// It uses no name of the shader around it. Lengths mm in organ space, colours linear.
#include "noise.glsl"
#include "bleeding_block.glsl"

struct LapfxBlood {
    float coverage;   // 0..1, how much of the pixel is blood
    float depth;      // mm beyond the edge: bleed value minus (threshold + noise)
    float clot;       // 0 fresh .. 1 clotted
    float gloss;      // 0..1, how sharply and strongly it reflects the lamp
    float level;      // 0..1, how far the layer levels the bumps of the tissue beneath
    vec3 color;       // colour of the blood itself: from thin to deep, darker where clotted
    vec3 opacity;     // 0..1, how much of the tissue it hides; most red passes
    vec3 slope;       // gradient of the layer's height over organ space: subtract it from the unit normal
    float spread;     // variance of the slope of what is too small for the pixel: see lapfx_blood_film()
};

// How much the surface reflects, from how rough and how wet it is without lobes that are smaller than a pixel.
struct LapfxFilm {
    float roughness;  // square root of GGX's alpha
    float wetness;    // strength of the highlight
};

// How much light 1 mm of film absorbs: powers of a half per channel for deep_at = 1. Haemoglobin absorbs several times
// more green and blue than red (Prahl's tables: 8 to 20 times), and less in a film that also scatters.
const vec3 lapfx_blood_absorption = vec3(2.6, 8.0, 7.5);

// Share of the slope of noise that a pixel resolves. `footprint`: the pixel's, in lobes.
float lapfx_resolved(float footprint) { return exp(-3.0 * footprint * footprint); }

// Mean square of the slope of one octave of noise along a surface, per lobe (two thirds of that of lapfx_perlin()).
const float lapfx_slope_square = 0.99;

// A pixel that holds many lobes, because they are small or far away, would be a mirror by chance and flash white beside
// dark ones. So the lobes' slopes widen the highlight (Kaplanyan et al., "Filtering Distributions of Normals for
// Shading Antialiasing", 2016). It also grows weaker, since a picture shows a spark no brighter than white: of a lobe
// with alpha a, whose light passes white up to a tilt s, that leaves 2 a / s - (a / s)^2 in the mean. A wide highlight
// with all of its light would veil the blood. Gives what to draw with in place of `roughness` (square root of GGX's
// alpha) and `wetness` (strength of the highlight).
LapfxFilm lapfx_blood_film(float roughness, float wetness, float spread) {
    const float white = 0.25;
    float narrow = roughness * roughness, wide = sqrt(narrow * narrow + min(spread, 0.2));
    vec2 x = min(vec2(narrow, wide) / white, 1.0);
    vec2 mean = 2.0 * x - x * x;
    return LapfxFilm(sqrt(wide), wetness * mean.x / mean.y);
}

// The noise that moves the edge, in -1..1, and the part of its gradient over organ space that a pixel with this
// footprint (mm) resolves; `lost`: mean square of the rest. Rivulets compress it along gravity, the
// fine octaves more than the first: on a wall its lobes become runs that point downhill, while level tissue has no
// extent along gravity and does not change. On steep tissue the runs are also longer. Everything is odd in the noise,
// so that blood gains as much area as it loses.
vec4 lapfx_blood_noise(vec3 position, vec3 normal, int octaves, float footprint, out float lost) {
    vec3 down = u_blood_down.xyz;
    float rivulets = u_blood_surface.w, scale = u_blood_edge.y;
    vec4 noise = vec4(0.0);
    float amplitude = 1.0, total = 0.0;
    lost = 0.0;
    for (int i = 0; i < octaves; ++i) {
        float press = (i == 0 ? 0.6 : 0.8) * rivulets;
        vec3 place = (position - press * dot(position, down) * down) / (scale * amplitude);
        vec4 n = lapfx_perlin(place, uint(u_blood_surface.z) + uint(i));
        // Half as large and half as strong: every octave has the same slope.
        float resolved = lapfx_resolved(footprint / (scale * amplitude));
        noise += vec4(amplitude * n.x, resolved * (n.yzw - press * dot(n.yzw, down) * down) / scale);
        lost += lapfx_slope_square * (1.0 - resolved * resolved) / (scale * scale);
        total += amplitude;
        amplitude *= 0.5;
    }
    noise /= max(total, 1.0);
    lost /= max(total * total, 1.0);
    float steep = rivulets * smoothstep(0.3, 0.9, length(cross(normal, down)));
    // x - x^3 / 6.75 reaches its maximum, 1, at 1.5: longer runs are bent into -1..1 and not cut off.
    float x = clamp(noise.x * (1.0 + steep), -1.5, 1.5);
    float bent = clamp(x - steep * x * x * x / 6.75, -1.0, 1.0);
    return vec4(bent, noise.yzw * (1.0 + steep) * (1.0 - steep * x * x / 2.25));
}

// `blood`: interpolated bleed value, mm, and clot, 0..1. `slope`: the bleed value's gradient over organ space; 0 if it
// is not at hand. `position`: rest position, mm. `normal`: of the tissue, unit, organ space. Call it in uniform control
// flow: it takes screen derivatives.
LapfxBlood lapfx_blood(vec2 blood, vec3 slope, vec3 position, vec3 normal) {
    float threshold = u_blood_edge.x, strength = u_blood_edge.z, deep_at = u_blood_thin.a;
    // Outside the reach of the noise no octave is computed.
    bool possible = lapfx_can_bleed(blood.x);
    int octaves = possible ? int(u_blood_edge.w) : 0;
    float footprint = max(length(dFdx(position)), length(dFdy(position))), lost;
    vec4 noise = lapfx_blood_noise(position, normal, octaves, footprint, lost);

    LapfxBlood b;
    // Beyond its reach the lowest edge counts: without a jump in depth, the edge is smooth even where the strength is
    // 0.
    b.depth = blood.x - (threshold + strength * (possible ? noise.x : -1.0));
    float width = max(fwidth(b.depth), 1e-3);
    b.coverage = possible ? clamp(b.depth / width + 0.5, 0.0, 1.0) : 0.0;

    // Fine grain: a swell that breaks up highlights on fresh blood, and the crumbs of a clot.
    const float grain_size = 1.7;
    vec4 grain = lapfx_fractal_noise(position / grain_size, min(octaves, 1), uint(u_blood_surface.z) + 31u);
    float depth = max(b.depth, 0.0), share = depth / deep_at;
    b.clot = clamp(blood.y * (1.25 + 0.9 * grain.x) - 0.1, 0.0, 1.0);

    float pooled = 1.0 - exp2(-3.0 * share);
    b.color = mix(u_blood_thin.rgb, u_blood_deep.rgb, pooled);
    // Dried blood: brown-black, red only where it is thin.
    vec3 dried = vec3(0.024, 0.0045, 0.0035) * (1.3 - 0.7 * pooled) * (1.0 + 0.8 * grain.x);
    b.color = mix(b.color, dried, b.clot * u_blood_down.w);
    // Beer and Lambert. Even at its edge a film of blood has a thickness.
    vec3 most = 1.0 - (1.0 - u_blood_deep.a) * vec3(1.0, 0.15, 0.15);
    b.opacity = most * (1.0 - exp2(-lapfx_blood_absorption * (share * (1.0 + b.clot) + 0.06)));
    b.gloss = u_blood_surface.y * (1.0 - 0.85 * b.clot);
    b.level = b.coverage * (1.0 - exp2(-2.5 * share));

    // The layer rises steeply at its rim (the meniscus) and is flat inside:
    // height = thickness * (1 - exp(-depth / rim)).
    float rim = 0.7;
    float steep = u_blood_surface.x / rim * exp(-depth / rim);
    // Blood on living tissue is never still or even: it has a swell from the lobes and from the grain.
    float swell = clamp(depth / 1.5, 0.0, 1.0), lobes = 0.12 * swell * u_blood_edge.y - steep * strength;
    float grains = swell * (0.045 + 0.06 * b.clot), resolved = lapfx_resolved(footprint / grain_size);
    b.slope = 0.5 * steep * slope + lobes * noise.yzw + grains * resolved * grain.yzw;
    b.spread = lobes * lobes * lost + grains * grains * lapfx_slope_square * (1.0 - resolved * resolved);
    return b;
}
