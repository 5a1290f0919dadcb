#version 450 core
// Tissue that anything has happened to, with the blood of the model `spread`.
#include "tissue.glsl"
#include "bleeding.glsl"
#include "wounded.glsl"

LapfxBlood blood_here(vec3 geometric) {
    return lapfx_blood(v_blood, surface_gradient(v_blood.x, geometric), v_rest, geometric);
}
