// A clip's frames on the GPU by the paper's buffering scheme (table 1): when the frame that is wanted is not
// there, this frame and the next one are sent in the same cycle, so that the next cycle sends nothing. Render
// thread only.
#pragma once

#include <array>
#include <memory>

#include "gl/objects.h"
#include "smoke/clip_stream.h"

namespace lapfx::smoke {

class ClipTextures {
  public:
    ClipTextures(const std::filesystem::path& path, int buffers);

    /// The texture that shows frame `index`, RGB, row 0 = top; under Policy::latest the last one when it is
    /// late.
    const gl::Texture& frame(int index, Policy policy) noexcept;

    const OldClipInfo& info() const { return stream_.info(); }
    /// Frames sent to the GPU so far.
    std::uint64_t uploads() const { return uploads_; }

  private:
    struct Sent {
        int index = -1;
        gl::Texture texture;
    };
    void send(Sent& to, int index, const cv::Mat& image) noexcept;

    ClipStream stream_;
    std::array<Sent, 2> sent_;
    int shown_ = 0;
    std::uint64_t uploads_ = 0;
};

}  // namespace lapfx::smoke
