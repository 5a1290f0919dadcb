#version 450 core
// Linear light to the camera's sRGB picture: exposure, a soft shoulder for the highlights, the endoscope's round view.
#include "color.glsl"

layout(location = 0) in vec2 v_uv;
layout(binding = 0) uniform sampler2D u_frame;
uniform float u_exposure;
uniform float u_vignette;  // 0 none .. 1 the round picture of an endoscope
uniform vec2 u_size;       // pixels
uniform int u_over_plate;  // 1: each light has been through the shoulder (view.glsl)
uniform vec2 u_plate;      // share of the frame that the plate's picture covers; 0: none is shown
layout(binding = 1) uniform sampler2D u_plate_picture;  // that picture, sRGB code values; alpha: valid view

layout(location = 0) out vec4 o_color;

// A plate is shown as its picture: beyond its valid view as it is, and black around it.
vec3 framed(vec3 srgb) {
    vec2 place = (v_uv - 0.5) / u_plate + 0.5;
    if (any(lessThan(place, vec2(0.0))) || any(greaterThan(place, vec2(1.0)))) return vec3(0.0);
    vec4 picture = texture(u_plate_picture, vec2(place.x, 1.0 - place.y));
    return mix(picture.rgb, srgb, picture.a);
}

void main() {
    vec3 color = texture(u_frame, v_uv).rgb * u_exposure;
    if (u_over_plate == 0) color = lapfx_shoulder(color);
    // The circle is as wide as the frame is high, plus a little, as in scopes that cut it off above and below.
    float radius = length((v_uv - 0.5) * u_size) / (0.5 * u_size.y);
    float lens = 1.0 - 0.45 * smoothstep(0.35, 1.15, radius);
    float mask = 1.0 - smoothstep(1.11, 1.13, radius);
    color *= mix(1.0, lens * mask, u_vignette);
    vec3 srgb = lapfx_to_srgb(clamp(color, 0.0, 1.0));
    o_color = vec4(u_plate.x > 0.0 ? framed(srgb) : srgb, 1.0);
}
