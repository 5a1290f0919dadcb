// Tissue with what surgery does to it: divided, charred, covered with blood, in this order from below; whatever the
// model of bleeding. The includer includes tissue.glsl and LapfxBlood (bleeding.glsl) before, and defines blood_here()
// after.

// The blood of this pixel; `geometric`: normal of the tissue.
LapfxBlood blood_here(vec3 geometric);

// Gradient over the surface of a value that is linear in each triangle (Mikkelsen, "Bump Mapping Unparametrized
// Surfaces on the GPU", 2010).
vec3 surface_gradient(float value, vec3 normal) {
    vec3 dx = dFdx(v_position), dy = dFdy(v_position);
    vec3 r1 = cross(dy, normal), r2 = cross(normal, dx);
    float det = dot(dx, r1);
    vec3 gradient = dFdx(value) * r1 + dFdy(value) * r2;
    return abs(det) < 1e-12 ? vec3(0.0) : gradient / det;
}

// Adds a slope (gradient of a height over organ space, mm per mm) to a normal.
vec3 tilted(vec3 normal, vec3 slope, vec3 geometric) {
    return normalize(normal - (slope - geometric * dot(geometric, slope)));
}

// Divided tissue: a groove with raw walls, dark at its bottom, with a torn rim.
void add_cut(inout Tissue tissue, vec3 geometric, vec4 fine) {
    vec3 along = surface_gradient(v_marks.y, geometric);
    float open = v_marks.y > 0.0 ? v_marks.y + 0.22 * fine.x * min(4.0 * v_marks.y, 1.0) : 0.0;
    float raw = smoothstep(0.38, 0.56, open), bottom = smoothstep(0.6, 1.0, open);
    vec3 flesh = vec3(0.20, 0.022, 0.018) * (1.0 + 0.9 * fine.x);
    tissue.albedo = mix(tissue.albedo, mix(flesh, vec3(0.035, 0.003, 0.003), bottom), raw);
    // A wall falls off over the rim only; the bottom is level.
    float wall = smoothstep(0.2, 0.5, open) * (1.0 - smoothstep(0.7, 1.0, open));
    vec3 slope = -1.1 * wall * along - 0.12 * raw * fine.yzw;
    tissue.normal = tilted(tissue.normal, slope, geometric);
    tissue.film_normal = tilted(tissue.film_normal, slope, geometric);
    tissue.roughness = mix(tissue.roughness, 0.28, raw);
    // The lamp does not shine far into a groove.
    tissue.sheen *= 1.0 - 0.8 * raw;
    tissue.wetness *= 1.0 - 0.8 * bottom;
}

// Heated tissue: first pale and cooked, then black-brown, matt, with a cracked crust.
void add_char(inout Tissue tissue, vec3 geometric, vec4 coarse, vec4 fine) {
    float near = min(v_marks.x * 4.0, 1.0);
    float heat = v_marks.x > 0.0 ? clamp(v_marks.x + near * (0.30 * coarse.x + 0.16 * fine.x), 0.0, 1.0) : 0.0;
    float cooked = smoothstep(0.04, 0.28, heat), burnt = smoothstep(0.36, 0.62, heat);
    // Coagulated protein is pale and opaque, browner the hotter it got.
    float value = min(dot(tissue.albedo, vec3(0.4, 0.4, 0.2)), 1.0);  // highlights of a plate are brighter
    vec3 pale = mix(vec3(0.50, 0.40, 0.29), vec3(0.30, 0.15, 0.06), smoothstep(0.2, 0.45, heat)) * (0.55 + value);
    tissue.albedo = mix(tissue.albedo, pale, 0.75 * cooked);
    // Cracks run where the coarse noise changes its sign.
    float crack = 1.0 - smoothstep(0.0, 0.16, abs(coarse.x + 0.25 * fine.x));
    vec3 crust = mix(vec3(0.010, 0.006, 0.005), vec3(0.055, 0.028, 0.014), smoothstep(-0.1, 0.6, fine.x));
    tissue.albedo = mix(tissue.albedo, crust * (1.0 - 0.8 * crack), burnt);
    vec3 slope = burnt * (0.35 * fine.yzw + 0.25 * coarse.yzw * (1.0 - crack));
    tissue.normal = tilted(tissue.normal, slope, geometric);
    tissue.film_normal = tilted(tissue.film_normal, 1.3 * slope, geometric);
    tissue.wetness *= 1.0 - 0.35 * cooked * (1.0 - burnt) - 0.72 * burnt;
    tissue.roughness = mix(tissue.roughness, 0.42, burnt);
}

// Gives how much of the pixel is blood.
float add_blood(inout Tissue tissue, vec3 geometric) {
    LapfxBlood blood = blood_here(geometric);
    tissue.albedo = mix(tissue.albedo, blood.color, blood.coverage * blood.opacity);
    // A deeper layer of fluid levels the bumps, and light scatters through it, so its body is shaded smoothly.
    tissue.normal = normalize(mix(tissue.normal, geometric, 0.9 * blood.level));
    vec3 surface = normalize(mix(tissue.film_normal, geometric, 0.6 * blood.level));
    tissue.film_normal = tilted(surface, blood.coverage * blood.slope, geometric);
    float wetness = mix(0.02, 1.0, smoothstep(0.15, 0.85, blood.gloss));
    LapfxFilm film = lapfx_blood_film(mix(0.55, 0.10, blood.gloss), wetness, blood.spread);
    tissue.roughness = mix(tissue.roughness, film.roughness, blood.coverage);
    tissue.wetness = mix(tissue.wetness, film.wetness, blood.coverage);
    // Under blood the tissue loses its sheen, which would veil the blood.
    tissue.sheen *= 1.0 - 0.85 * blood.coverage * blood.opacity.g;
    return blood.coverage;
}

void main() {
    vec3 geometric = facing_normal();
    Tissue tissue = bare_tissue(geometric);
    bool marked = v_marks.x > 0.0 || v_marks.y > 0.0;
    vec4 coarse = lapfx_fractal_noise(v_rest / 2.2, marked ? 1 : 0, 77u);
    vec4 fine = lapfx_fractal_noise(v_rest / 0.7, marked ? 2 : 0, 78u);
    add_cut(tissue, geometric, fine);
    add_char(tissue, geometric, coarse, fine);
    float covered = add_blood(tissue, geometric);
    vec3 shaded = shade(tissue, geometric);
    // Where nothing has happened, a plate stays as it is.
    float changed = u_plate == 1 ? max(covered, min(4.0 * max(v_marks.x, v_marks.y), 1.0)) : 1.0;
    o_color = vec4(overlaid(mix(shaded, lapfx_drawn_light(shaded), changed)), 1.0);
}
