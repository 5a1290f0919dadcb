// A clip's frame on the GPU: what ClipSet gives and SmokeGpu draws. Plain data.
#pragma once

#include "gl/gl.h"
#include "media/picture.h"

namespace lapfx::media {

/// Names of array textures (GL_TEXTURE_2D_ARRAY, linear, clamped to the edge, no mipmaps) and the layer in them; row 0
/// is the top. Owned by the ClipSet, valid until its next call. Without `color` there is nothing to show yet.
struct ClipFrame {
    PictureFormat format;                 ///< says which of the textures there are
    GLuint color = 0;                     ///< R8 luma (Layout::planar) or RGB8 (Layout::rgb)
    GLuint chroma = 0;                    ///< RG8 Cb and Cr, at PictureFormat::chroma_size(); 0 for Layout::rgb
    GLuint alpha = 0;                     ///< R8 opacity; 0 where the clip has none
    int layer = 0;                        ///< in all of them
    const ColorMatrix* matrix = nullptr;  ///< Layout::planar has one
};

}  // namespace lapfx::media
