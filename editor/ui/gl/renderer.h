// Draws a DrawList with OpenGL 4.5 core: instanced quads, one call a batch as a rule, opaque backgrounds by scissored
// clears.
//
//     ui::Renderer renderer;                     // with the context current
//     renderer.draw(list, fonts, &images, 0);    // onto the window
//
// The framebuffer holds sRGB-encoded values and must not encode again. The renderer sets all state that drawing depends
// on and does not restore any of it. It leaves: program, vertex array, framebuffer, viewport, scissor box,
// textures and samplers of units 0 to 2, uniform buffer 0, premultiplied blending on; depth, stencil and scissor test,
// culling, logic operation, framebuffer sRGB and rasteriser discard off; all colour channels written; pixel unpacking
// at 1-byte alignment, else plain.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "ui/draw/images.h"
#include "ui/text/fonts.h"

namespace lapfx::ui {

/// Statistics of one draw().
struct RenderStatistics {
    int draw_calls = 0;
    int clears = 0;
    std::size_t bytes = 0;  ///< sent: instances, clips, the atlas's and the images' changes
};

class Renderer {
  public:
    /// Needs a current context and a loaded glad. Throws std::runtime_error with the compiler's log.
    Renderer();
    ~Renderer();
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;

    /// Uses other shader texts from now on (shaders/ui.vert, shaders/ui.frag as they are on disk). If they do not
    /// compile, returns false with the log in `fault` and keeps the earlier shaders.
    bool reload(std::string_view vertex, std::string_view fragment, std::string& fault);

    /// `framebuffer` is at least as large as the list; its lower left corner is drawn. Sends what changed of the atlas
    /// and of the images in use, so one renderer serves one Fonts and one store; an image that is no more, or null
    /// `images`, shows black. Steady frames allocate nothing.
    void draw(const DrawList& list, Fonts& fonts, const ImageStore* images, unsigned framebuffer);
    const RenderStatistics& last() const { return last_; }

  private:
    /// Shapes and text; pictures, gradients and the like (shaders/ui.vert says why apart).
    static constexpr int program_count = 2;
    using Programs = std::array<unsigned, program_count>;
    struct Picture {
        unsigned texture = 0;
        glm::ivec2 size{0};
        std::uint32_t serial = 0;
    };

    void send_atlas(Fonts& fonts);
    void send_pictures(const DrawList& list, const ImageStore* images);
    void send_picture(Picture& picture, const StoredImage& image);
    void send_instances(const DrawList& list);
    void send_clips(const DrawList& list);
    void set_state(const DrawList& list, unsigned framebuffer) const;
    void clear(const DrawList& list);
    void draw_batch(const DrawList& list, const Batch& batch, std::size_t clip_offset);
    unsigned texture_of(ImageHandle image) const;

    Programs programs_{};
    unsigned vertices_ = 0, instances_ = 0, clips_ = 0, sampler_ = 0;
    unsigned atlas_ = 0, atlas_texture_ = 0;  ///< a buffer, and the texture that reads it
    glm::ivec2 atlas_size_{0};
    std::uint32_t atlas_resets_ = 0;
    std::size_t clip_alignment_ = 16;  ///< entries
    std::vector<Picture> pictures_;    ///< the index is that in the store
    std::vector<glm::vec4> clip_table_;
    RenderStatistics last_;
};

}  // namespace lapfx::ui
