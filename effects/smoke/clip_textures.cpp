#include "smoke/clip_textures.h"

namespace lapfx::smoke {

ClipTextures::ClipTextures(const std::filesystem::path& path, int buffers) : stream_(path, buffers) {
    const cv::Size size = stream_.info().size;
    for (Sent& sent : sent_) sent.texture = gl::Texture({.size = {size.width, size.height}, .format = GL_RGB8});
    const cv::Mat black = cv::Mat::zeros(size, CV_8UC3);  // shown under Policy::latest until the first frame is there
    for (const Sent& sent : sent_) sent.texture.upload(GL_BGR, black.data);
}

const gl::Texture& ClipTextures::frame(int index, Policy policy) noexcept {
    for (int i = 0; i < 2; ++i)
        if (sent_[static_cast<std::size_t>(i)].index == index) {
            shown_ = i;
            stream_.frame(index, Policy::latest);  // lets the worker go on; the picture is here already
            return sent_[static_cast<std::size_t>(i)].texture;
        }
    if (const cv::Mat* image = stream_.frame(index, policy)) {
        send(sent_[0], index, *image);
        shown_ = 0;
        const int next = (index + 1) % stream_.info().frame_count;
        if (const cv::Mat* following = stream_.peek(next)) send(sent_[1], next, *following);
    }
    return sent_[static_cast<std::size_t>(shown_)].texture;
}

void ClipTextures::send(Sent& to, int index, const cv::Mat& image) noexcept {
    const glm::ivec2 size = to.texture.size();
    if (image.cols != size.x || image.rows != size.y || image.type() != CV_8UC3) return;
    to.texture.upload(GL_BGR, image.data);
    to.index = index;
    ++uploads_;
}

}  // namespace lapfx::smoke
