#include "bench/streaming/host.h"

#include <glad/gl.h>

#include "lapfx/preset.h"

namespace lapfx::bench {

HostFrame::HostFrame() {
    glCreateTextures(GL_TEXTURE_2D, 2, textures_);
    glTextureStorage2D(textures_[0], 1, GL_RGBA16F, screen_width, screen_height);
    glTextureStorage2D(textures_[1], 1, GL_DEPTH_COMPONENT32F, screen_width, screen_height);
    const float depth = 0.95f, color[4] = {0.3f, 0.05f, 0.05f, 1.0f};
    glClearTexImage(textures_[1], 0, GL_DEPTH_COMPONENT, GL_FLOAT, &depth);
    glClearTexImage(textures_[0], 0, GL_RGBA, GL_FLOAT, color);
    glCreateFramebuffers(1, &framebuffer_);
    glNamedFramebufferTexture(framebuffer_, GL_COLOR_ATTACHMENT0, textures_[0], 0);
}

HostFrame::~HostFrame() {
    glDeleteFramebuffers(1, &framebuffer_);
    glDeleteTextures(2, textures_);
}

void HostFrame::bind(double share) const {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    glViewport(0, 0, static_cast<int>(share * screen_width), static_cast<int>(share * screen_height));
}

void finish_drawing() {
    glFinish();
}

Organ triangle() {
    Organ organ;
    organ.positions = {{-1, 0, -1}, {1, 0, -1}, {0, 0, 1}};
    organ.indices = {0, 1, 2};
    organ.normals.assign(3, glm::vec3(0, 1, 0));
    organ.tangents.assign(3, glm::vec4(1, 0, 0, 1));
    organ.uvs.assign(3, glm::vec2(0));
    organ.colors.assign(3, glm::vec4(1));
    organ.materials = {Material{}};
    organ.parts = {{.name = "triangle", .first_index = 0, .index_count = 3}};
    return organ;
}

Preset smoke_of(int streams, const BenchClips& clips) {
    Preset preset;
    preset.folder = clips.folder();
    for (int i = 0; i < streams; ++i) preset.smoke.clips.push_back({.file = clips.name(i), .role = ClipRole::haze});
    return preset;
}

View looking_on() {
    View view;
    view.view[3] = glm::vec4(0, 0, -100, 1);
    constexpr float near = 1.0f, far = 1000.0f;
    view.projection = glm::mat4(0.0f);
    view.projection[0][0] = 1.4f;
    view.projection[1][1] = 1.75f;
    view.projection[2] = glm::vec4(0, 0, -(far + near) / (far - near), -1);
    view.projection[3][2] = -2.0f * far * near / (far - near);
    return view;
}

std::vector<ToolContact> burning() {
    return {{.time = 0.0, .duration = 600.0}};
}

}  // namespace lapfx::bench
