#version 450 core
// Tissue that bleeds (the model `spread`), is charred or divided; other triangles are dropped.
#include "organ.glsl"
#include "bleeding_block.glsl"

out float gl_CullDistance[1];

void main() {
    pass_vertex();
    bool touched = lapfx_can_bleed(a_blood.x) || a_marks.x > 0.0 || a_marks.y > 0.0;
    gl_CullDistance[0] = touched ? 1.0 : -1.0;
}
