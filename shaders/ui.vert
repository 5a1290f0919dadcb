#version 450 core
// The UI's quads: one instance of 32 bytes each (editor/ui/draw/draw_list.h), four corners without a vertex buffer.
// This file makes two programs: one for shapes and text, which are most of a frame, and, with LAPFX_UI_PICTURES, one
// for everything that is larger and rarer. They are separate because llvmpipe runs every branch of a fragment shader
// for every pixel.

layout(location = 0) in vec4 a_rect;    // px: x, y, w, h; a line: both ends
layout(location = 1) in uvec4 a_uv;     // as the kind has it
layout(location = 2) in vec4 a_color;   // sRGB, straight alpha
layout(location = 3) in uvec4 a_bytes;  // radius, border, kind, index of the clip

layout(std140, binding = 0) uniform Clips {
    vec4 u_clips[256];  // px: left, top, right, bottom
};
layout(location = 0) uniform vec2 u_pixel;  // of the framebuffer, in clip space

flat out vec4 v_color;  // sRGB, premultiplied
flat out vec4 v_shape;  // half size and radius, px; frame's width, px, or how far text is bent
#ifdef LAPFX_UI_PICTURES
flat out uint v_kind;
flat out vec4 v_other;  // second colour, premultiplied; of compare: mode, gain, share of the second, bits
#else
flat out vec4 v_inside;  // within a frame, premultiplied
flat out float v_glyph;  // 1 of a glyph, 0 of a shape
#endif
out vec4 v_place;  // xy: px from the middle of the shape; zw: in the texture

// NAME_kind and NAME_mode: the values of InstanceKind and CompareMode, which the renderer puts in front.
const float endless = 1e6, no_border = 1e8;  // px; a border wider than any shape leaves nothing inside

vec4 clip;
vec2 corner;

void put(vec2 at) {
    gl_Position = vec4(at.x * u_pixel.x - 1.0, 1.0 - at.y * u_pixel.y, 0.0, 1.0);
}

// The corner of low..high cut to the clip; a rectangle outside becomes a quad without area.
vec2 put_corner(vec2 low, vec2 high) {
    vec2 at = clamp(mix(low, high, corner), clip.xy, clip.zw);
    put(at);
    return at;
}

vec4 premultiplied(vec4 color) {
    return vec4(color.rgb * color.a, color.a);
}

vec4 color_of(uint low, uint high) {
    return premultiplied(unpackUnorm4x8(low | high << 16));
}

#ifndef LAPFX_UI_PICTURES

// A line thinner than a pixel becomes one pixel wide and paler.
vec2 thicken(vec2 half_size) {
    vec2 thick = max(half_size, 0.5);
    float part = half_size.x / thick.x * half_size.y / thick.y;
    v_color *= part;
    v_inside *= part;
    return thick;
}

void put_fill(float radius, float border) {
    vec2 low = a_rect.xy, high = low + a_rect.zw, middle = low + 0.5 * a_rect.zw;
    if (a_uv.z == 1u) {
        v_inside = color_of(a_uv.x, a_uv.y);
        v_color += v_inside * (1.0 - v_color.a);
    }
    if (radius == 0.0 && border == 0.0 && fract(low) == vec2(0.0) && fract(high) == vec2(0.0)) {
        v_shape = vec4(endless, endless, 0.0, no_border);  // the quad's own edges are the shape's
    } else {
        vec2 half_size = thicken(0.5 * a_rect.zw);
        v_shape = vec4(half_size, min(radius, min(half_size.x, half_size.y)), border > 0.0 ? border : no_border);
        low = floor(middle - half_size);
        high = ceil(middle + half_size);
    }
    v_place.xy = put_corner(low, high) - middle;
}

// A bar with round ends along the line. Inside the clip its quad is slanted like the line; otherwise it is the box
// around the line, cut to the clip.
void put_line() {
    vec2 middle = 0.5 * (a_rect.xy + a_rect.zw), way = a_rect.zw - a_rect.xy;
    float far = length(way), radius = float(a_uv.x) / 128.0;
    vec2 along = far > 0.0 ? way / far : vec2(1.0, 0.0), across = vec2(-along.y, along.x);
    float thick = max(radius, 0.5);
    v_color *= radius / thick;
    v_shape = vec4(0.5 * far + thick, thick, thick, no_border);

    float reach = thick + 0.5;
    vec2 low = min(a_rect.xy, a_rect.zw) - reach, high = max(a_rect.xy, a_rect.zw) + reach, at;
    if (all(greaterThanEqual(low, clip.xy)) && all(lessThanEqual(high, clip.zw))) {
        vec2 side = 2.0 * corner - 1.0;
        at = middle + side.x * (0.5 * far + reach) * along + side.y * reach * across;
        put(at);
    } else {
        at = put_corner(low, high);
    }
    v_place.xy = vec2(dot(at - middle, along), dot(at - middle, across));
}

void put_glyph() {
    // Blended in sRGB, light text on dark looks thinner than dark text on light, so half-covered pixels become up to
    // 0.1 stronger the lighter the text is. Judged at 14 px: 0 is spindly on dark, 0.8 half-bold. Dark text does not
    // change.
    float light = dot(a_color.rgb, vec3(0.2126, 0.7152, 0.0722));
    v_shape = vec4(endless, endless, 0.0, 0.4 * light);
    v_glyph = 1.0;
    v_place = vec4(0.0);
    v_place.zw = put_corner(a_rect.xy, a_rect.xy + a_rect.zw) - a_rect.xy + vec2(a_uv.xy);
}

void main() {
    corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);
    clip = u_clips[a_bytes.w];
    v_color = premultiplied(a_color);
    v_inside = vec4(0.0);
    v_glyph = 0.0;
    v_place = vec4(0.0);
    if (a_bytes.z == glyph_kind) put_glyph();
    else if (a_bytes.z == line_kind) put_line();
    else put_fill(float(a_bytes.x), float(a_bytes.y));
}

#else

// Packed as editor/ui/paint/painter.h says. v_place.x becomes the distance across the wipe's line, px.
void unpack_compare(vec2 at) {
    float angle = float(a_uv.y) / 65536.0 * 6.28318530718;
    vec2 normal = vec2(cos(angle), sin(angle));
    float reach = 0.5 * dot(abs(normal), a_rect.zw);
    v_place.x = dot(at - a_rect.xy - 0.5 * a_rect.zw, normal) - (float(a_uv.x) / 65535.0 * 2.0 - 1.0) * reach;
    v_other = vec4(float(a_bytes.x), unpackHalf2x16(a_uv.z).x, float(a_uv.w) / 65535.0, float(a_bytes.y));
}

void main() {
    corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);
    clip = u_clips[a_bytes.w];
    v_kind = a_bytes.z;
    v_color = premultiplied(a_color);
    v_shape = vec4(0.0);
    v_other = vec4(0.0);

    vec2 low = a_rect.xy, high = low + a_rect.zw;
    float softness = v_kind == shadow_kind ? float(a_uv.x) : 0.0;
    vec2 at = put_corner(low - softness, high + softness);
    v_place = vec4(at - low, (at - low) / a_rect.zw);
    if (v_kind == image_kind) {
        v_color = a_color;
        v_shape.x = float(a_bytes.y);
        v_place.zw = mix(vec2(a_uv.xy), vec2(a_uv.zw), v_place.zw) / 65535.0;
    } else if (v_kind == gradient_kind) {
        v_other = color_of(a_uv.x, a_uv.y);
        v_place.x = a_uv.z == 1u ? v_place.w : v_place.z;
    } else if (v_kind == checker_kind) {
        v_other = color_of(a_uv.z, a_uv.w);
        v_place.xy /= float(a_uv.x);
    } else if (v_kind == shadow_kind) {
        vec2 half_size = 0.5 * a_rect.zw;
        v_shape = vec4(half_size, min(float(a_bytes.x), min(half_size.x, half_size.y)), max(softness, 1.0));
        v_place.xy -= half_size;
    } else {
        unpack_compare(at);
    }
}

#endif
