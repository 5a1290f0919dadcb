// What effects/bleeding/bleed_gpu.h sends. Lengths mm, colours linear.
layout(std140, binding = 1) uniform LapfxBleeding {
    vec4 u_blood_edge;     // threshold, noise scale, noise strength, octaves
    vec4 u_blood_thin;     // rgb of a thin film; a: depth at which the pool's colour is reached
    vec4 u_blood_deep;     // rgb of a deep pool; a: opacity of a deep pool
    vec4 u_blood_surface;  // thickness of the layer, gloss, seed, rivulets
    vec4 u_blood_down;     // xyz: unit, where gravity points, organ space; w: how much clots darken
};

// Whether blood can show at a bleed value (mm), wherever the noise puts its edge.
bool lapfx_can_bleed(float bleed) { return bleed > u_blood_edge.x - u_blood_edge.z; }
