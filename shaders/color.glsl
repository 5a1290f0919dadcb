// sRGB transfer (IEC 61966-2-1) and luma. Lighting happens in linear light; thresholds of a clip in its own code
// values.

vec3 lapfx_to_linear(vec3 srgb) {
    return mix(srgb / 12.92, pow((srgb + 0.055) / 1.055, vec3(2.4)), greaterThan(srgb, vec3(0.04045)));
}

vec3 lapfx_to_srgb(vec3 linear) {
    return mix(linear * 12.92, 1.055 * pow(linear, vec3(1.0 / 2.4)) - 0.055, greaterThan(linear, vec3(0.0031308)));
}

// The film curve, one channel each: x: toe, y: knee, z: light of white, over the knee and in units of what is left
// between the knee and 1 (effects/camera.cpp has the same).
vec3 lapfx_film(vec3 light, vec3 film) {
    vec3 x = max(light, 0.0);
    x *= x * (1.0 + film.x) / max(x + film.x, 1e-6);
    vec3 u = min(max(x - film.y, 0.0) / (1.0 - film.y), film.z);
    return min(x, film.y) + (1.0 - film.y) * u * (1.0 + u / (film.z * film.z)) / (1.0 + u);
}

// The light that it shows as this.
vec3 lapfx_before_film(vec3 shown, vec3 film) {
    vec3 share = max(shown - film.y, 0.0) / (1.0 - film.y), less = share - 1.0;
    vec3 u = 0.5 * film.z * film.z * (less + sqrt(less * less + 4.0 * share / (film.z * film.z)));
    vec3 dark = (min(shown, film.y) + (1.0 - film.y) * max(u, 0.0)) / (1.0 + film.x);
    return 0.5 * (dark + sqrt(dark * dark + 4.0 * film.x * dark));
}

// The camera's soft shoulder: identity up to the knee, then an approach to 1 with the same slope.
const float lapfx_knee = 0.7;

vec3 lapfx_shoulder(vec3 x) {
    vec3 over = max(x - lapfx_knee, 0.0) / (1.0 - lapfx_knee);
    return min(x, lapfx_knee) + (1.0 - lapfx_knee) * (over / (1.0 + over));
}
