#include "color.glsl"

// The camera and the lamp beside it; filled from render/view_block.h. Lengths mm, colours linear.
layout(std140, binding = 0) uniform LapfxView {
    mat4 u_view;        // organ space to camera space
    mat4 u_projection;
    vec4 u_eye;         // xyz: camera in organ space
    vec4 u_axis;        // xyz: unit viewing direction in organ space
    vec4 u_light;       // rgb: colour * intensity; a: distance at which a white surface facing the lamp is lit to 1
    vec4 u_beam;        // x: cosine at half of the lamp's strength; y: ambient share; z: exposure over a plate, else 0
    vec4 u_plate_light;  // over a plate with a film curve, for which u_beam.z is 0: lapfx_camera[0] and
    vec4 u_plate_film;   // [1] of post.glsl, whose w is 1; else 0
};

// Light that arrives at a point from the lamp: the inverse square of the distance, and the beam's fall-off.
vec3 lapfx_lamp(vec3 position) {
    vec3 to_point = position - u_eye.xyz;
    float distance_mm = max(length(to_point), 1.0);
    float cosine = dot(to_point, u_axis.xyz) / distance_mm;
    // exp2(-x) with x = 1 at the half angle; 1 - cos grows with the square of the angle.
    float beam = exp2(-(1.0 - cosine) / max(1.0 - u_beam.x, 1e-4));
    float reach = u_light.a / distance_mm;
    return u_light.rgb * min(reach * reach, 9.0) * beam;
}

// Distance from the camera plane, mm, of a window depth.
float lapfx_view_depth(float depth) { return u_projection[3][2] / (2.0 * depth - 1.0 + u_projection[2][2]); }

// Farther tissue has more haze before it: 1 at the focus distance.
float lapfx_haze_reach(float scene) { return clamp(scene / u_light.a, 0.4, 1.8); }

// Light as it is drawn. The camera's shoulder has no white, so what a plate's picture was before it cannot be told:
// everything over the picture goes through the shoulder by itself. Other frames do as a whole (post.glsl).
vec3 lapfx_drawn_light(vec3 light) {
    float exposure = u_beam.z;
    return exposure > 0.0 ? lapfx_shoulder(light * exposure) / exposure : light;
}
