// Clips that are drawn together, each once; filled from effects/smoke/layer_gpu.cpp.
#ifndef LAPFX_LAYERS
#define LAPFX_LAYERS 1
#endif

struct LapfxSmokeLayer {
    vec4 code_rows[3];  // luma, Cb and Cr in code values, from the frame's three values 0..1; w is added
    vec4 luma_chroma;   // luma low, luma high, chroma low, chroma high; code values
    vec4 key;           // xy: Cb, Cr of the key colour; z: spill; w: 1 = dark polarity
    vec4 vary;          // x: noise strength; y: choke, z: feather, clip pixels; w: the frame's layer in its textures
    vec4 amount;        // x: density; y: unevenness of haze, softness of a plume in mm; zw: size of the clip, pixels
    vec4 turn;          // columns of the matrix from drawn to clip coordinates, about the middle
    vec4 tile;          // xy: start, zw: extent of the noise, coordinates of u_noise
    vec4 chroma_scale;  // xy: chroma coordinates per clip coordinate; plume: z: clip below its source, w: widening
    vec4 corners[4];    // corners of a plume, camera space, mm: top left, top right, bottom left, bottom right
    vec4 color;         // rgb: linear colour; a: extinction of the transmission, for layers directly over the frame
    vec4 extinction;    // the frame
    vec4 window;        // xy: upper left, zw: lower right corner of the cropped frame, clip pixels
    vec4 fades;         // left, top, right, bottom: over how many clip pixels smoke fades inside it
    vec4 part;          // haze: xy: start, zw: extent, clip coordinates; plume: its corners as window, drawn ones
    vec4 masks[12];     // xy: upper left, zw: lower right corner, clip pixels
    vec4 mask_count;    // x: how many; y: over how many clip pixels smoke fades around them; zw: source of a plume
};

layout(std140, binding = 2) uniform LapfxSmokeLayers {
    LapfxSmokeLayer u_layers[LAPFX_LAYERS];
};
