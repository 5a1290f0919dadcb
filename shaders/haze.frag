#version 450 core
// Environmental smoke over the whole view: an even veil of optical thickness E, made uneven by a clip and by noise.
#include "smoke.glsl"

layout(location = 0) in vec2 v_uv;

void main() {
    vec3 code;
    float shape = smoke_opacity(vec2(v_uv.x, 1.0 - v_uv.y), code);
    float thickness = u_color.a * max(1.0 + u_extinction.a * (2.0 * shape - 1.0), 0.0);
#ifdef LAPFX_DIRECT
    thickness *= lapfx_haze_reach(scene_depth());
#endif
    put(thickness, tinted(code) * u_light.rgb);
}
