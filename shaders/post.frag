#version 450 core
// Linear light to the camera's sRGB picture: exposure, a soft shoulder for the highlights, the endoscope's round view.
#include "color.glsl"

layout(location = 0) in vec2 v_uv;
layout(binding = 0) uniform sampler2D u_frame;
uniform float u_exposure;
uniform float u_vignette;  // 0 none .. 1 the round picture of an endoscope
uniform vec2 u_size;       // pixels

layout(location = 0) out vec4 o_color;

// Identity up to the knee, then an approach to 1 with the same slope.
vec3 shoulder(vec3 x) {
    const float knee = 0.7;
    vec3 over = max(x - knee, 0.0) / (1.0 - knee);
    return min(x, knee) + (1.0 - knee) * (over / (1.0 + over));
}

void main() {
    vec3 color = shoulder(texture(u_frame, v_uv).rgb * u_exposure);
    // The circle is as wide as the frame is high, plus a little, as in scopes that cut it off above and below.
    float radius = length((v_uv - 0.5) * u_size) / (0.5 * u_size.y);
    float lens = 1.0 - 0.45 * smoothstep(0.35, 1.15, radius);
    float mask = 1.0 - smoothstep(1.11, 1.13, radius);
    color *= mix(1.0, lens * mask, u_vignette);
    o_color = vec4(lapfx_to_srgb(clamp(color, 0.0, 1.0)), 1.0);
}
