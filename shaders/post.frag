#version 450 core
// The finished picture: the camera's, within the picture of a plate where one is shown.
#include "post.glsl"

layout(location = 0) in vec2 v_uv;
layout(binding = 0) uniform sampler2D u_frame;
uniform vec2 u_plate;  // share of the frame that the plate's picture covers; 0: none is shown
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
    vec3 srgb = lapfx_post(u_frame, v_uv);
    o_color = vec4(u_plate.x > 0.0 ? framed(srgb) : srgb, 1.0);
}
