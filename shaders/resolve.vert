#version 450 core
// A rectangle of the view.
uniform vec4 u_bounds;  // xy: lower left, zw: upper right corner; 0..1 of the viewport

layout(location = 0) out vec2 v_uv;  // 0..1 of the viewport, origin bottom left

void main() {
    v_uv = mix(u_bounds.xy, u_bounds.zw, vec2(gl_VertexID & 1, gl_VertexID >> 1));
    gl_Position = vec4(v_uv * 2.0 - 1.0, 0.0, 1.0);
}
