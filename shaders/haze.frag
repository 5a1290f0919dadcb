#version 450 core
// Environmental smoke over the whole view: an even veil of optical thickness E, made uneven by clips and by noise.
#define LAPFX_FILLS_VIEW
#include "smoke.glsl"

layout(location = 0) in vec2 v_uv;

void main() {
    vec2 uv = vec2(v_uv.x, 1.0 - v_uv.y);
    vec4 noise = smoke_noise(uv), sum = vec4(0.0);
    for (int i = 0; i < LAPFX_LAYERS; ++i) {
        vec3 light;
        float shape = smoke_opacity(i, uv, noise[i], light);
        vec4 amount = u_layers[i].amount;
        float thickness = bounded(amount.x * max(1.0 + amount.y * (2.0 * shape - 1.0), 0.0));
        sum += vec4(light, 1.0) * thickness;
    }
#ifdef LAPFX_DIRECT
    sum *= vec4(u_light.rgb, 1.0) * lapfx_haze_reach(scene_depth());
#endif
    put(sum);
}
