#version 450 core
// Environmental smoke over the whole view: an even veil of optical thickness E, made uneven by a clip and by noise.
#include "smoke.glsl"

layout(location = 0) in vec2 v_uv;

uniform float u_unevenness;

void main() {
    vec3 code;
    float shape = keyed_alpha(vec2(v_uv.x, 1.0 - v_uv.y), code);
    float scene = view_depth(texelFetch(u_scene_depth, ivec2(gl_FragCoord.xy), 0).r);
    // The farther the tissue, the more smoke lies before it; E is the thickness at the focus distance.
    float reach = clamp(scene / u_light.a, 0.4, 1.8);
    float thickness = u_extinction.a * reach * max(1.0 + u_unevenness * (2.0 * shape - 1.0), 0.0);
    put(1.0 - exp(-thickness), tinted(code) * u_light.rgb);
}
