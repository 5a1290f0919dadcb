// Where drawn coordinates lie in the clip of a plume that widens upwards (x, y), and how much thinner its smoke is
// there (z). `source`: where the smoke starts; `widening`: width at the top as a part of that at the source. Mirrored
// on the CPU by effects/smoke/plume.h.
vec3 lapfx_plume_place(vec2 drawn, vec2 source, float widening) {
    float risen = clamp((source.y - drawn.y) / max(source.y, 1e-3), 0.0, 1.0);
    float width = 1.0 + (widening - 1.0) * risen;
    return vec3(source.x + (drawn.x - source.x) * widening / width, drawn.y, 1.0 / width);
}
