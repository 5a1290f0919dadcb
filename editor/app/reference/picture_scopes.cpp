#include "app/reference/picture_scopes.h"

#include <algorithm>
#include <cmath>

namespace lapfx::app {

namespace {

constexpr int samples = 256;  // of the shorter side

}  // namespace

void PictureScopes::count(const Image& image) {
    if (image.width < 1 || image.height < 1 || image.pixels.empty()) return;
    const int every = std::max(1, std::min(image.width, image.height) / samples);
    const ui::ScopeSource source{
        .bytes = image.pixels, .size = {image.width, image.height}, .channels = 4, .every = every};
    vectors_.update_chroma(source);
    waves_.update_luma(source);
    for (auto& bins : bins_) bins.fill(0);
    std::array<double, channel_titles.size()> sums{};
    double count = 0;
    for (int y = 0; y < image.height; y += every) {
        const std::uint8_t* row = image.pixels.data() + 4 * static_cast<std::size_t>(y) * image.width;
        for (int x = 0; x < image.width; x += every, ++count) {
            const std::uint8_t* p = row + 4 * static_cast<std::size_t>(x);
            const float luma = ui::luma_chroma(glm::vec3(p[0], p[1], p[2])).x;
            const std::array<std::uint8_t, channel_titles.size()> level = {
                static_cast<std::uint8_t>(std::clamp(std::lround(luma), 0L, 255L)), p[0], p[1], p[2]};
            for (std::size_t c = 0; c < level.size(); ++c) {
                ++bins_[c][level[c]];
                sums[c] += level[c];
            }
        }
    }
    for (std::size_t c = 0; c < means_.size(); ++c) means_[c] = sums[c] / count;
}

}  // namespace lapfx::app
