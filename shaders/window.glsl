// The part of a clip's frame that may become smoke: crop, fade at its edges, masks. Pixels of the clip, from its upper
// left corner. Mirrored on the CPU by effects/smoke/keying_pixel.h; constants by effects/smoke/window.h.

// 0 at or below 0, 1 from 1 on, without a kink.
vec4 lapfx_eased(vec4 x) {
    vec4 t = clamp(x, 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

// 1 inside low..high, fading to 0 at its edges over `fades`: left, top, right, bottom.
float lapfx_inside(vec2 position, vec4 low_high, vec4 fades) {
    vec4 eased = lapfx_eased(vec4(position - low_high.xy, low_high.zw - position) / fades);
    return eased.x * eased.y * eased.z * eased.w;
}

// 0 inside a mask, rising to 1 over `softness` around it.
float lapfx_outside(vec2 position, vec4 mask, float softness) {
    vec2 beyond = max(max(mask.xy - position, position - mask.zw), 0.0);
    return lapfx_eased(vec4(length(beyond) / softness)).x;
}
