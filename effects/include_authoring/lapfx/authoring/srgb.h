// The transfer of sRGB (IEC 61966-2-1) between codes and linear light, both 0..1; as in shaders/color.glsl. Pure.
#pragma once

#include <cmath>

namespace lapfx {

/// `Number`: float or double, in which it is worked out.
template <typename Number>
Number linear_of_srgb(Number code) {
    return code <= Number(0.04045) ? code / Number(12.92)
                                   : std::pow((code + Number(0.055)) / Number(1.055), Number(2.4));
}
template <typename Number>
Number srgb_of_linear(Number light) {
    return light <= Number(0.0031308) ? Number(12.92) * light
                                      : Number(1.055) * std::pow(light, Number(1) / Number(2.4)) - Number(0.055);
}

}  // namespace lapfx
