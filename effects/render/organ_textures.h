// The textures of an organ on the GPU, sent at once or a part in each frame. Render thread, context current.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "gl/objects.h"
#include "organ/texture_levels.h"

namespace lapfx::render {

GLenum wrap_mode(Wrap wrap);

class OrganTextures {
  public:
    OrganTextures() = default;
    /// Sends all of them.
    OrganTextures(const Organ& organ, const organ::PixelList& pixels);

    /// Sends about so many bytes of what has not been sent; false when nothing is left. `all`: the same in each call.
    bool send(std::span<const organ::TextureLevels> all, std::size_t bytes) noexcept;

    /// Frees one that was sent; false when none is left.
    bool free_one() noexcept;

    /// The texture of an image in that use; 0: there is none.
    GLuint find(int image, bool color) const noexcept;
    std::size_t memory() const noexcept;  ///< bytes on the GPU, with mip levels

  private:
    struct Sent {
        organ::TextureUse use;
        gl::Texture texture;
    };
    std::size_t make(const organ::TextureLevels& levels);
    std::size_t send_rows(const organ::TextureLevels& levels, std::size_t bytes) noexcept;

    std::vector<Sent> sent_;
    std::size_t next_ = 0, level_ = 0;  // of all, and of its levels
    int row_ = 0;                       // of the level
    bool made_ = false;                 // the texture of next_ exists
};

}  // namespace lapfx::render
