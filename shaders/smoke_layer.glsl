// One clip drawn once; filled from effects/smoke/layer_gpu.cpp.
layout(std140, binding = 2) uniform LapfxSmokeLayer {
    vec4 u_luma_chroma;  // luma low, luma high, chroma low, chroma high; code values
    vec4 u_key;          // xy: Cb, Cr of the key colour; z: spill; w: 1 = dark polarity
    vec4 u_vary;         // x: noise strength; y: choke, z: feather, clip pixels; w: the frame's layer in its textures
    vec4 u_color;        // rgb: linear colour of the smoke; a: density
    vec4 u_extinction;   // rgb: of the transmission per channel; a: unevenness of haze, softness of a plume in mm
    vec4 u_size;         // xy: of the clip, pixels; zw: chroma coordinates per clip coordinate
    vec4 u_turn;         // columns of the matrix from drawn to clip coordinates, about the middle
    vec4 u_tile;         // xy: start, zw: extent of this layer's noise, coordinates of u_noise
    vec4 u_code_rows[3]; // xyz: from YCbCr to a code value; w: is added
    vec4 u_corners[4];   // of a plume, camera space, mm: top left, top right, bottom left, bottom right
};
