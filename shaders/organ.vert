#version 450 core
// Tissue and instruments as they are.
#include "organ.glsl"

void main() { pass_vertex(); }
