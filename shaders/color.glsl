// sRGB transfer (IEC 61966-2-1) and luma. Lighting happens in linear light; thresholds of a clip in its own code
// values.

vec3 lapfx_to_linear(vec3 srgb) {
    return mix(srgb / 12.92, pow((srgb + 0.055) / 1.055, vec3(2.4)), greaterThan(srgb, vec3(0.04045)));
}

vec3 lapfx_to_srgb(vec3 linear) {
    return mix(linear * 12.92, 1.055 * pow(linear, vec3(1.0 / 2.4)) - 0.055, greaterThan(linear, vec3(0.0031308)));
}

// The camera's soft shoulder: identity up to the knee, then an approach to 1 with the same slope.
const float lapfx_knee = 0.7;

vec3 lapfx_shoulder(vec3 x) {
    vec3 over = max(x - lapfx_knee, 0.0) / (1.0 - lapfx_knee);
    return min(x, lapfx_knee) + (1.0 - lapfx_knee) * (over / (1.0 + over));
}
