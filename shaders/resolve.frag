#version 450 core
// Lays smoke over the frame once: the sum of all layers of a role, at the resolution of their clips, becomes light and
// transmission per channel (tests/support/thickness.h is the same on the CPU).
//
// Why a sum is enough: of light that crosses layers of thickness t1, t2, .. the share exp(-t1) * exp(-t2) .. remains,
// which is exp(-(t1 + t2 + ..)) in any order. The layers scatter light towards the eye like a mixture of media with one
// extinction: the mean of their colours weighted by thickness, times the share that does not pass. That equals layer
// over layer where the colours agree, and does not depend on an order where they differ, as in smoke that mingles.
//   LAPFX_PLUME  its thickness changes suddenly where the scene's depth does: upsampling looks at that
//   LAPFX_EVEN   no layers, an even veil
//   else haze: more of it lies before what is farther away; that is done here, at full resolution
#include "view.glsl"

layout(location = 0) in vec2 v_uv;

layout(binding = 0) uniform sampler2D u_sum;          // rgb: light and tint * thickness; a: thickness
layout(binding = 1) uniform sampler2D u_sum_depth;    // mm, depth of the scene as the plume's layers have read it
layout(binding = 13) uniform sampler2D u_scene_depth;  // window depth, the size of the frame
uniform vec3 u_color;  // linear
uniform vec3 u_extinction;
uniform float u_even;      // thickness
uniform float u_softness;  // mm

layout(location = 0, index = 0) out vec4 o_light;
layout(location = 0, index = 1) out vec4 o_transmission;

#ifdef LAPFX_PLUME
// Bilinear, but neighbours at another depth count little, so that smoke behind an instrument does not spread over its
// edge.
vec4 smoke_sum(float scene) {
    ivec2 last = textureSize(u_sum, 0) - 1;
    vec2 position = v_uv * vec2(last + 1) - 0.5;
    ivec2 first = ivec2(floor(position));
    vec2 f = position - vec2(first);
    // The distance of slanted tissue changes by a few hundredths between neighbours.
    float near = max(u_softness, 0.03 * scene);
    vec4 sum = vec4(0.0);
    float total = 0.0;
    for (int i = 0; i < 4; ++i) {
        ivec2 corner = ivec2(i & 1, i >> 1);
        ivec2 at = clamp(first + corner, ivec2(0), last);
        vec2 share = mix(1.0 - f, f, vec2(corner));
        float apart = abs(texelFetch(u_sum_depth, at, 0).r - scene);
        float weight = share.x * share.y * (max(1.0 - apart / near, 0.0) + 1e-4);
        sum += weight * texelFetch(u_sum, at, 0);
        total += weight;
    }
    return sum / max(total, 1e-8);
}
#endif

void main() {
    float scene = lapfx_view_depth(texelFetch(u_scene_depth, ivec2(gl_FragCoord.xy), 0).r);
#if defined LAPFX_PLUME
    vec4 sum = smoke_sum(scene);
    float reach = 1.0;
    vec3 color = u_color;
#elif defined LAPFX_EVEN
    vec4 sum = vec4(u_even);
    float reach = lapfx_haze_reach(scene);
    vec3 color = u_color * u_light.rgb;
#else
    vec4 sum = textureLod(u_sum, v_uv, 0.0);
    float reach = lapfx_haze_reach(scene);
    vec3 color = u_color * u_light.rgb;
#endif
    vec3 transmission = exp(-sum.a * reach * u_extinction);
    o_light = vec4(lapfx_drawn_light(color * sum.rgb / max(sum.a, 1e-6)) * (1.0 - transmission), 0.0);
    o_transmission = vec4(transmission, 1.0);
}
