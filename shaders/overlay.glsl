// Invisible values that decide: density of vessels and fat (paper: figure 9) and the bleed value, as false colour over
// the shaded tissue, which turns grey. Output linear.

#include "overlays.glsl"  // OVERLAY_NONE and so on, made from the table in lapfx/view.h

uniform int u_overlay;
layout(binding = 2) uniform sampler2D u_density;  // vessels, fat; white where vertices have them

// How much of the false colour covers the tissue at density 1.
const float lapfx_overlay_cover = 0.8;

// 0 blue, 1/3 green, 2/3 yellow, 1 red.
vec3 lapfx_false_color(float t) {
    return clamp(vec3(3.0 * t - 1.0, min(3.0 * t, 3.0 - 3.0 * t), 1.0 - 3.0 * t), 0.0, 1.0);
}

// `shaded`: the tissue as it would be drawn. `density`: vessels and fat, 0..1. `bleed`: bleed value, mm, per pixel.
vec3 lapfx_overlay(vec3 shaded, vec2 density, float bleed) {
    if (u_overlay == OVERLAY_NONE) return shaded;
    vec3 grey = vec3(dot(shaded, vec3(0.2126, 0.7152, 0.0722)));
    if (u_overlay == OVERLAY_VESSELS) return mix(grey, vec3(0.0, 0.6, 1.0), lapfx_overlay_cover * density.x);
    if (u_overlay == OVERLAY_FAT) return mix(grey, vec3(1.0, 0.7, 0.0), lapfx_overlay_cover * density.y);
    if (u_overlay != OVERLAY_BLEED) return shaded;
    // Isolines every 2 mm from 0, one and a half pixels wide; colours run to red at 20 mm. Bounded, because the value
    // drops steeply beyond the reach of blood.
    float steps = bleed / 2.0, width = clamp(fwidth(steps), 1e-6, 1.0);
    float line = 1.0 - clamp(abs(fract(steps + 0.5) - 0.5) / width - 0.25, 0.0, 1.0);
    vec3 color = lapfx_false_color(clamp(bleed / 20.0, 0.0, 1.0));
    float inside = clamp(steps / width + 0.5, 0.0, 1.0);
    return mix(grey, color, inside * max(0.35, line));
}
