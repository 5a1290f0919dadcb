// A small frame with a depth, hand-made clip frames, and the smoke over them according to the CPU references.
#pragma once

#include <functional>
#include <glm/gtc/matrix_transform.hpp>
#include <random>

#include "gl/objects.h"
#include "lapfx/authoring/clip_roles.h"
#include "lapfx/view.h"
#include "render/view_block.h"
#include "smoke/keying_pixel.h"
#include "smoke/smoke_gpu.h"
#include "support/gpu_test.h"
#include "support/thickness.h"

namespace lapfx::smoke {

/// A frame with known planes, in textures as ClipSet makes them; it is in the last of three layers.
struct HandMade {
    HandMade(glm::ivec2 size, media::Layout layout, bool alpha, std::uint32_t seed, const media::ColorMatrix& m)
        : matrix(m) {
        format = {.size = size, .layout = layout, .alpha = alpha};
        std::mt19937 random(seed);
        const auto fill = [&](std::vector<std::uint8_t>& plane, std::size_t bytes, int low, int high) {
            plane.resize(bytes);
            for (std::uint8_t& b : plane)
                b = static_cast<std::uint8_t>(low + static_cast<int>(random() % (high - low + 1)));
        };
        fill(planes[0], format.color_bytes(), 16, 235);
        fill(planes[1], format.chroma_bytes(), 108, 148);
        fill(planes[2], format.alpha_bytes(), 0, 255);
        const bool rgb = layout == media::Layout::rgb;
        make(0, size, rgb ? GL_RGB8 : GL_R8, rgb ? GL_RGB : GL_RED);
        make(1, format.chroma_size(), GL_RG8, GL_RG);
        make(2, size, GL_R8, GL_RED);
    }

    media::ClipFrame frame() const {
        return {.format = format,
                .color = textures[0].name(),
                .chroma = textures[1].name(),
                .alpha = textures[2].name(),
                .layer = 2,
                .matrix = format.layout == media::Layout::planar ? &matrix : nullptr};
    }

    /// R'G'B' code values at a place, pixels of the clip; bilinear, clamped to the edge.
    glm::vec3 rgb(glm::vec2 place) const {
        const glm::vec4 color = bilinear(planes[0], format.size, format.layout == media::Layout::rgb ? 3 : 1, place);
        if (format.layout == media::Layout::rgb) return glm::vec3(color);
        const glm::vec4 chroma = bilinear(planes[1], format.chroma_size(), 2, place / 2.0f);
        return matrix.matrix * (glm::vec3(color.x, chroma.x, chroma.y) - matrix.offset);
    }
    float opacity(glm::vec2 place, const Keying& key) const {
        return format.alpha ? bilinear(planes[2], format.size, 1, place).x / 255.0f : key_alpha(rgb(place), key);
    }

    /// The clip's shading if it has its own opacity.
    float shading(glm::vec2 place) const {
        return format.alpha ? shade(luma(rgb(place)), bilinear(planes[2], format.size, 1, place).x / 255.0f) : 1.0f;
    }

    media::PictureFormat format;
    media::ColorMatrix matrix;
    std::vector<std::uint8_t> planes[3];
    gl::Texture textures[3];

  private:
    void make(int plane, glm::ivec2 size, GLenum internal, GLenum external) {
        if (planes[plane].empty()) return;
        textures[plane] = gl::Texture({.size = size, .format = internal, .layers = 3});
        const std::vector<std::uint8_t> other(planes[plane].size(), 99);
        for (int layer = 0; layer < 2; ++layer) textures[plane].upload(external, other.data(), layer);
        textures[plane].upload(external, planes[plane].data(), 2);
    }
    static glm::vec4 bilinear(const std::vector<std::uint8_t>& plane, glm::ivec2 size, int channels, glm::vec2 place) {
        const glm::vec2 at = place - 0.5f, f = at - glm::floor(at);
        const glm::ivec2 first(glm::floor(at));
        glm::vec4 sum(0.0f);
        for (int i = 0; i < 4; ++i) {
            const glm::ivec2 corner(i & 1, i >> 1);
            const glm::ivec2 texel = glm::clamp(first + corner, glm::ivec2(0), size - 1);
            const float weight = (corner.x == 1 ? f.x : 1.0f - f.x) * (corner.y == 1 ? f.y : 1.0f - f.y);
            for (int c = 0; c < channels; ++c)
                sum[c] += weight * static_cast<float>(
                                       plane[static_cast<std::size_t>((texel.y * size.x + texel.x) * channels + c)]);
        }
        return sum;
    }
};

/// BT.601, limited range.
inline media::ColorMatrix bt601() {
    media::ColorMatrix m;
    m.matrix = glm::mat3(glm::vec3(255.0f / 219.0f), glm::vec3(0.0f, -0.391762f, 2.017232f),
                         glm::vec3(1.596027f, -0.812968f, 0.0f));
    m.offset = {16.0f, 128.0f, 128.0f};
    return m;
}

class SmokeGpuTest : public test::GpuTest {
  protected:
    static constexpr float focus = 100.0f;  // mm
    static constexpr glm::vec4 background{0.4f, 0.2f, 0.1f, 1.0f};

    void SetUp() override {
        test::GpuTest::SetUp();
        if (!IsSkipped()) set_size({48, 32});
    }
    void TearDown() override {
        if (!IsSkipped()) glBindFramebuffer(GL_FRAMEBUFFER, 0);
        test::GpuTest::TearDown();
    }

    void set_size(glm::ivec2 wanted) {
        size = wanted;
        color = gl::Texture({.size = size, .format = GL_RGBA32F, .filter = GL_NEAREST});
        depth = gl::Texture({.size = size, .format = GL_DEPTH_COMPONENT32F, .filter = GL_NEAREST});
        framebuffer = gl::Framebuffer(color, nullptr);
        view.projection = glm::perspective(glm::radians(60.0f), static_cast<float>(size.x) / static_cast<float>(size.y),
                                           2.0f, 5000.0f);
        view.lamp.focus_distance = focus;
    }
    /// The scene's distance, mm, of each pixel (origin bottom left).
    void set_depth(const std::function<float(glm::ivec2)>& distance) {
        std::vector<float> values;
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x) {
                const glm::vec4 clip = view.projection * glm::vec4(0.0f, 0.0f, -distance({x, y}), 1.0f);
                values.push_back(clip.z / clip.w * 0.5f + 0.5f);
            }
        glTextureSubImage2D(depth.name(), 0, 0, 0, size.x, size.y, GL_DEPTH_COMPONENT, GL_FLOAT, values.data());
    }
    /// Pixels, rows from the bottom, of the background under the layers from `add`.
    std::vector<glm::vec4> draw(SmokeGpu& gpu, const std::function<void()>& add) {
        const render::ViewBlock block;
        block.bind(view);
        glClearNamedFramebufferfv(framebuffer.name(), GL_COLOR, 0, &background.x);
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.name());
        glViewport(0, 0, size.x, size.y);
        gpu.begin({{plume, haze}}, softness);
        add();
        gpu.draw(depth.name());
        std::vector<glm::vec4> pixels(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
        glGetTextureImage(color.name(), 0, GL_RGBA, GL_FLOAT, static_cast<GLsizei>(pixels.size() * sizeof(glm::vec4)),
                          pixels.data());
        glDisable(GL_BLEND);
        return pixels;
    }
    std::size_t index(glm::ivec2 pixel) const { return static_cast<std::size_t>(pixel.y * size.x + pixel.x); }

    glm::ivec2 size{0};
    gl::Texture color, depth;
    gl::Framebuffer framebuffer;
    View view;
    SmokeMedium plume{.color = {0.8, 0.7, 0.6}, .extinction = {0.85, 1.0, 1.1}};
    SmokeMedium haze{.color = {0.5, 0.6, 0.4}, .extinction = {0.8, 1.0, 1.12}};
    double softness = 6.0;
};

}  // namespace lapfx::smoke
