#version 450 core
// Tissue without blood or char, and instruments.
#include "tissue.glsl"

void main() {
    vec3 geometric = facing_normal();
    vec3 shaded = u_plate == 1 ? plate_light() : lapfx_drawn_light(shade(bare_tissue(geometric), geometric));
    o_color = vec4(overlaid(shaded), 1.0);
}
