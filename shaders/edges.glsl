// Choke and feather: the edge of keyed smoke. The includer defines lapfx_opacity_at(), the keyed opacity at a place of
// the clip, pixels. Mirrored on the CPU by effects/smoke/keying_pixel.h; tests/parity/keying_test.cpp compares
// them.

float lapfx_opacity_at(vec2 position);

const vec2 lapfx_directions[8] =
    vec2[8](vec2(1.0, 0.0), vec2(0.70710678, 0.70710678), vec2(0.0, 1.0), vec2(-0.70710678, 0.70710678), vec2(-1.0, 0.0),
            vec2(-0.70710678, -0.70710678), vec2(0.0, -1.0), vec2(0.70710678, -0.70710678));

// The least opacity here and `choke` pixels away in eight directions: edges move inwards.
float lapfx_choked(vec2 position, float choke) {
    float least = lapfx_opacity_at(position);
    int count = choke > 0.0 ? 8 : 0;
    for (int i = 0; i < count; ++i) least = min(least, lapfx_opacity_at(position + choke * lapfx_directions[i]));
    return least;
}

// The mean of the choked opacity here and `feather` pixels away in eight directions.
float lapfx_edged(vec2 position, float choke, float feather) {
    float sum = lapfx_choked(position, choke);
    int count = feather > 0.0 ? 8 : 0;
    for (int i = 0; i < count; ++i) sum += lapfx_choked(position + feather * lapfx_directions[i], choke);
    return sum / float(count + 1);
}
