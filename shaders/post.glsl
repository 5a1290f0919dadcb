// Linear light to the picture of an endoscope's camera: exposure, white balance, sharpening, saturation, the lens'
// fall-off, the film curve, the round mask, in this order, then sRGB. It works in lapfx's own frame and in a host's:
// lapfx::post_shader() gives this text with its includes, lapfx::post_values() what the array is set to
// (lapfx/camera.h; tests/support/post_cpu.h is the same on the CPU).
#include "color.glsl"

// 0: rgb: exposure times white balance; a: saturation. 1: xyz: the film (color.glsl); w: 0 shoulder, 1 film,
// 2 light that has been through the shoulder. 2: x: fall-off of the lens; y: vignette; z: sharpening. 3: xy: size, px.
uniform vec4 lapfx_camera[4];

const vec3 lapfx_luma = vec3(0.2126, 0.7152, 0.0722);  // Rec. 709

float lapfx_brightness(sampler2D frame, ivec2 at, ivec2 last) {
    vec3 light = texelFetch(frame, clamp(at, ivec2(0), last), 0).rgb * lapfx_camera[0].rgb;
    return sqrt(max(dot(light, lapfx_luma), 0.0));
}

// Between four pixels; a host's sampler may filter otherwise.
float lapfx_brightness_at(sampler2D frame, vec2 place, ivec2 last) {
    vec2 position = place - 0.5, f = fract(position);
    ivec2 first = ivec2(floor(position));
    vec4 corners = vec4(lapfx_brightness(frame, first, last), lapfx_brightness(frame, first + ivec2(1, 0), last),
                        lapfx_brightness(frame, first + ivec2(0, 1), last),
                        lapfx_brightness(frame, first + ivec2(1, 1), last));
    vec2 rows = mix(corners.xz, corners.yw, f.x);
    return mix(rows.x, rows.y, f.y);
}

// As processors of endoscopes do: what is brighter than its surround becomes brighter, up to a bound, so that an edge
// has no white or black line beside it. The surround is four places 1.5 px away in a picture of 512 rows.
float lapfx_sharpened(sampler2D frame, vec2 uv) {
    const float reach = 1.5 / 512.0, most = 0.25;
    vec2 place = uv * lapfx_camera[3].xy;
    ivec2 last = ivec2(lapfx_camera[3].xy) - 1;
    float apart = reach * lapfx_camera[3].y;
    float here = lapfx_brightness_at(frame, place, last);
    float around = 0.25 * (lapfx_brightness_at(frame, place + vec2(apart, 0.0), last) +
                           lapfx_brightness_at(frame, place - vec2(apart, 0.0), last) +
                           lapfx_brightness_at(frame, place + vec2(0.0, apart), last) +
                           lapfx_brightness_at(frame, place - vec2(0.0, apart), last));
    float more = 1.0 + clamp(lapfx_camera[2].z * (here - around) / (here + 0.05), -most, most);
    return more * more;
}

vec3 lapfx_post(sampler2D frame, vec2 uv) {
    vec3 color = texture(frame, uv).rgb * lapfx_camera[0].rgb;
    if (lapfx_camera[2].z > 0.0) color *= lapfx_sharpened(frame, uv);
    float saturation = lapfx_camera[0].a;
    if (saturation != 1.0) color = max(mix(vec3(dot(color, lapfx_luma)), color, saturation), 0.0);
    // The circle is as wide as the frame is high, plus a little, as in scopes that cut it off above and below.
    float radius = length((uv - 0.5) * lapfx_camera[3].xy) / (0.5 * lapfx_camera[3].y);
    float lens = 1.0 - lapfx_camera[2].x * smoothstep(0.35, 1.15, radius);
    float mask = 1.0 - smoothstep(1.11, 1.13, radius), vignette = lapfx_camera[2].y;
    if (lapfx_camera[1].w == 1.0) {
        color = lapfx_film(color * mix(1.0, lens, vignette), lapfx_camera[1].xyz) * mix(1.0, mask, vignette);
    } else {
        if (lapfx_camera[1].w == 0.0) color = lapfx_shoulder(color);
        color *= mix(1.0, lens * mask, vignette);
    }
    return lapfx_to_srgb(clamp(color, 0.0, 1.0));
}
