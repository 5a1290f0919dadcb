#version 450 core
// Colours of the UI, sRGB-encoded as they are blended, premultiplied. See ui.vert for the two programs and for what
// comes in.

flat in vec4 v_color;
flat in vec4 v_shape;
#ifdef LAPFX_UI_PICTURES
flat in uint v_kind;
flat in vec4 v_other;
#else
flat in vec4 v_inside;
flat in float v_glyph;
#endif
in vec4 v_place;

#ifndef LAPFX_UI_PICTURES
// Coverage, rows one after the other: an eighth of a frame faster on llvmpipe.
layout(binding = 0) uniform samplerBuffer u_atlas;
layout(location = 1) uniform int u_atlas_width;
#else
layout(binding = 1) uniform sampler2D u_first;  // sRGB, straight alpha; filtered, never mipmapped
layout(binding = 2) uniform sampler2D u_second;
#endif

layout(location = 0) out vec4 o_color;

// px from the edge of a rounded rectangle around 0, negative inside.
float distance_to(vec2 at, vec2 half_size, float radius) {
    vec2 q = abs(at) - half_size + radius;
    return length(max(q, 0.0)) + min(max(q.x, q.y), 0.0) - radius;
}

#ifndef LAPFX_UI_PICTURES

void main() {
    float way = distance_to(v_place.xy, v_shape.xy, v_shape.z);
    float inside = clamp(0.5 - way - v_shape.w, 0.0, 1.0), frame = clamp(0.5 - way, 0.0, 1.0) - inside;
    float ink = texelFetch(u_atlas, int(v_place.w) * u_atlas_width + int(v_place.z)).r;
    ink += v_shape.w * ink * (1.0 - ink);
    o_color = v_color * (v_glyph > 0.5 ? ink : frame) + v_inside * inside;
}

#else

vec4 picture(sampler2D source, vec2 at, bool nearest) {
    ivec2 size = textureSize(source, 0);
    vec4 color = nearest ? texelFetch(source, clamp(ivec2(floor(at * vec2(size))), ivec2(0), size - 1), 0)
                         : textureLod(source, at, 0.0);
    return color;
}

vec2 turned(vec2 at, int bits, int bit) {
    return vec2(at.x, (bits & bit) != 0 ? 1.0 - at.y : at.y);
}

vec4 compared() {
    int mode = int(v_other.x), bits = int(v_other.w);
    vec4 first = picture(u_first, turned(v_place.zw, bits, 2), (bits & 1) != 0);
    vec4 second = picture(u_second, turned(v_place.zw, bits, 4), (bits & 1) != 0);
    first.rgb *= first.a;
    second.rgb *= second.a;
    switch (mode) {
        case wipe_mode: return mix(first, second, clamp(v_place.x + 0.5, 0.0, 1.0));
        case difference_mode: return vec4(min(abs(first.rgb - second.rgb) * v_other.y, 1.0), 1.0);
        default: return mix(first, second, v_other.z);
    }
}

void main() {
    if (v_kind == image_kind) {
        vec4 color = picture(u_first, v_place.zw, v_shape.x > 0.5) * v_color;
        o_color = vec4(color.rgb * color.a, color.a);
    } else if (v_kind == gradient_kind) {
        o_color = mix(v_color, v_other, clamp(v_place.x, 0.0, 1.0));
    } else if (v_kind == checker_kind) {
        ivec2 square = ivec2(floor(v_place.xy));
        o_color = ((square.x + square.y) & 1) == 0 ? v_color : v_other;
    } else if (v_kind == shadow_kind) {
        float outside = clamp(distance_to(v_place.xy, v_shape.xy, v_shape.z) / v_shape.w, 0.0, 1.0);
        o_color = v_color * (1.0 - outside * outside * (3.0 - 2.0 * outside));
    } else {
        o_color = compared();
    }
}

#endif
