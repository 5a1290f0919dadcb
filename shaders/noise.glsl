// Perlin's improved gradient noise (Ken Perlin, "Improving Noise", SIGGRAPH 2002) on a hashed lattice, so that it never
// repeats and needs no texture. Mirrored on the CPU by effects/smoke/noise.h; tests/parity/smoke/noise_test.cpp
// compares them.

uint lapfx_hash(ivec3 cell, uint seed) {
    uvec3 c = uvec3(cell);
    uint h = (c.x * 0x8da6b343u) ^ (c.y * 0xd8163841u) ^ (c.z * 0xcb1ab31fu) ^ (seed * 0x9e3779b9u);
    h ^= h >> 15; h *= 0x2c1b3c6du;
    h ^= h >> 12; h *= 0x297a2d39u;
    return h ^ (h >> 15);
}

// One of the twelve edge directions of a cube, as in Perlin 2002 (four of them twice).
vec3 lapfx_gradient(ivec3 cell, uint seed) {
    uint h = lapfx_hash(cell, seed) & 15u;
    float u = (h & 1u) == 0u ? 1.0 : -1.0;
    float v = (h & 2u) == 0u ? 1.0 : -1.0;
    if (h < 4u) return vec3(u, v, 0.0);
    if (h < 8u) return vec3(u, 0.0, v);
    if (h < 12u) return vec3(0.0, u, v);
    // 12..15 repeat four of the twelve, so that a mask can select.
    return (h & 1u) == 0u ? vec3(v, 1.0, 0.0) : vec3(0.0, -1.0, v);
}

// Value in about -1..1 with mean 0 (x), and its gradient (yzw). One lobe per unit of p. `from`: whole lobes that are
// added to p without losing its precision, so that noise may drift for days.
vec4 lapfx_perlin_from(ivec3 from, vec3 p, uint seed) {
    vec3 base = floor(p);
    ivec3 cell = from + ivec3(base);
    vec3 f = p - base;
    vec3 s = f * f * f * (f * (f * 6.0 - 15.0) + 10.0);
    vec3 ds = 30.0 * f * f * (f * (f - 2.0) + 1.0);

    vec3 g000 = lapfx_gradient(cell, seed), g100 = lapfx_gradient(cell + ivec3(1, 0, 0), seed);
    vec3 g010 = lapfx_gradient(cell + ivec3(0, 1, 0), seed), g110 = lapfx_gradient(cell + ivec3(1, 1, 0), seed);
    vec3 g001 = lapfx_gradient(cell + ivec3(0, 0, 1), seed), g101 = lapfx_gradient(cell + ivec3(1, 0, 1), seed);
    vec3 g011 = lapfx_gradient(cell + ivec3(0, 1, 1), seed), g111 = lapfx_gradient(cell + ivec3(1, 1, 1), seed);
    vec4 n000 = vec4(dot(g000, f), g000), n100 = vec4(dot(g100, f - vec3(1, 0, 0)), g100);
    vec4 n010 = vec4(dot(g010, f - vec3(0, 1, 0)), g010), n110 = vec4(dot(g110, f - vec3(1, 1, 0)), g110);
    vec4 n001 = vec4(dot(g001, f - vec3(0, 0, 1)), g001), n101 = vec4(dot(g101, f - vec3(1, 0, 1)), g101);
    vec4 n011 = vec4(dot(g011, f - vec3(0, 1, 1)), g011), n111 = vec4(dot(g111, f - vec3(1, 1, 1)), g111);

    vec4 x00 = mix(n000, n100, s.x), x10 = mix(n010, n110, s.x), x01 = mix(n001, n101, s.x), x11 = mix(n011, n111, s.x);
    vec4 y0 = mix(x00, x10, s.y), y1 = mix(x01, x11, s.y);
    vec4 value = mix(y0, y1, s.z);
    // The weights also change: that is the second part of the gradient.
    value.y += ds.x * mix(mix(n100.x - n000.x, n110.x - n010.x, s.y), mix(n101.x - n001.x, n111.x - n011.x, s.y), s.z);
    value.z += ds.y * mix(x10.x - x00.x, x11.x - x01.x, s.z);
    value.w += ds.z * (y1.x - y0.x);
    return value;
}

vec4 lapfx_perlin(vec3 p, uint seed) { return lapfx_perlin_from(ivec3(0), p, seed); }

// Octaves of noise, each half as large and half as strong, scaled so that the sum stays in about -1..1. Value and
// gradient.
vec4 lapfx_fractal_noise(vec3 p, int octaves, uint seed) {
    vec4 sum = vec4(0.0);
    float amplitude = 1.0, frequency = 1.0, total = 0.0;
    for (int i = 0; i < octaves; ++i) {
        vec4 n = lapfx_perlin(p * frequency, seed + uint(i));
        sum += amplitude * vec4(n.x, n.yzw * frequency);
        total += amplitude;
        amplitude *= 0.5;
        frequency *= 2.0;
    }
    return octaves > 0 ? sum / total : sum;
}
