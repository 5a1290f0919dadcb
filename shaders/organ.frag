#version 450 core
// Tissue without blood or char, and instruments.
#include "tissue.glsl"

void main() {
    vec3 geometric = facing_normal();
    o_color = vec4(overlaid(shade(bare_tissue(geometric), geometric)), 1.0);
}
