#include "ui/gl/renderer.h"

#include <glad/gl.h>

#include <cstddef>
#include <stdexcept>

#include "ui/paint/painter.h"
#include "ui/value/closed_list.h"

namespace lapfx::ui {

// Written at build time by effects/cmake/write_embedded_shaders.cmake.
extern const std::pair<std::string_view, std::string_view>* const embedded_shaders;
extern const unsigned embedded_shader_count;

namespace {

constexpr std::size_t clip_block = 256;                // entries, of the shader's u_clips
constexpr GLint pixel_uniform = 0, width_uniform = 1;  // locations in the shaders
constexpr GLint atlas_texels = 2048 * 2048;            // the most that Fonts makes

std::string_view embedded(std::string_view name) {
    for (unsigned i = 0; i < embedded_shader_count; ++i) {
        if (embedded_shaders[i].first == name) return embedded_shaders[i].second;
    }
    return {};
}

/// `picture`: drawn by the second program, that of pictures.
constexpr struct {
    InstanceKind value;
    std::string_view name;
    bool picture = false;
} kinds[] = {{InstanceKind::fill, "fill"},
             {InstanceKind::glyph, "glyph"},
             {InstanceKind::line, "line"},
             {InstanceKind::image, "image", true},
             {InstanceKind::gradient, "gradient", true},
             {InstanceKind::checker, "checker", true},
             {InstanceKind::shadow, "shadow", true},
             {InstanceKind::compare, "compare", true}};
static_assert(is_whole(kinds));

constexpr struct {
    CompareMode value;
    std::string_view name;
} modes[] = {{CompareMode::wipe, "wipe"}, {CompareMode::difference, "difference"}, {CompareMode::onion, "onion"}};
static_assert(is_whole(modes));

/// Both lists as constants for the shaders.
std::string shader_constants() {
    std::string text;
    for (const auto& each : kinds)
        text.append("const uint ").append(each.name) +=
            "_kind = " + std::to_string(static_cast<int>(each.value)) + "u;\n";
    for (const auto& each : modes)
        text.append("const int ").append(each.name) +=
            "_mode = " + std::to_string(static_cast<int>(each.value)) + ";\n";
    return text;
}

int program_of(InstanceKind kind) {
    return kinds[static_cast<std::size_t>(kind)].picture ? 1 : 0;
}

std::string log_of(GLuint name, decltype(glGetShaderiv) get, decltype(glGetShaderInfoLog) read) {
    GLint length = 0;
    get(name, GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<std::size_t>(std::max(length, 1)), '\0');
    read(name, length, &length, log.data());
    log.resize(static_cast<std::size_t>(length));
    return log;
}

/// Returns 0 and adds to `fault` when it does not compile. `before` goes behind the line of #version.
GLuint compile(GLenum stage, std::string_view text, std::string_view before, std::string& fault) {
    const std::size_t line_end = text.find('\n');
    const std::size_t first_line = line_end == text.npos ? text.size() : line_end + 1;
    const std::string_view parts[] = {text.substr(0, first_line), before, "#line 2\n", text.substr(first_line)};
    const GLchar* texts[4];
    GLint lengths[4];
    for (int i = 0; i < 4; ++i) texts[i] = parts[i].data(), lengths[i] = static_cast<GLint>(parts[i].size());
    const GLuint shader = glCreateShader(stage);
    glShaderSource(shader, 4, texts, lengths);
    glCompileShader(shader);
    GLint done = GL_FALSE;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &done);
    if (done == GL_TRUE) return shader;
    fault += stage == GL_VERTEX_SHADER ? "ui.vert: " : "ui.frag: ";
    fault += log_of(shader, glGetShaderiv, glGetShaderInfoLog);
    glDeleteShader(shader);
    return 0;
}

GLuint link(std::string_view vertex, std::string_view fragment, std::string_view before, std::string& fault) {
    const GLuint stages[] = {compile(GL_VERTEX_SHADER, vertex, before, fault),
                             compile(GL_FRAGMENT_SHADER, fragment, before, fault)};
    GLuint program = 0;
    if (stages[0] != 0 && stages[1] != 0) {
        program = glCreateProgram();
        for (const GLuint stage : stages) glAttachShader(program, stage);
        glLinkProgram(program);
        for (const GLuint stage : stages) glDetachShader(program, stage);  // they would stay as long as the program
        GLint done = GL_FALSE;
        glGetProgramiv(program, GL_LINK_STATUS, &done);
        if (done != GL_TRUE) {
            fault += "ui.vert, ui.frag: " + log_of(program, glGetProgramiv, glGetProgramInfoLog);
            glDeleteProgram(program);
            program = 0;
        }
    }
    for (const GLuint stage : stages) glDeleteShader(stage);
    return program;
}

void describe_instances(GLuint vertices, GLuint instances) {
    const auto attribute = [&](GLuint index, GLenum type, bool integer, std::size_t offset) {
        glEnableVertexArrayAttrib(vertices, index);
        glVertexArrayAttribBinding(vertices, index, 0);
        if (integer)
            glVertexArrayAttribIFormat(vertices, index, 4, type, static_cast<GLuint>(offset));
        else
            glVertexArrayAttribFormat(vertices, index, 4, type, GL_TRUE, static_cast<GLuint>(offset));
    };
    attribute(0, GL_FLOAT, false, offsetof(Instance, x));
    attribute(1, GL_UNSIGNED_SHORT, true, offsetof(Instance, uv));
    attribute(2, GL_UNSIGNED_BYTE, false, offsetof(Instance, color));
    attribute(3, GL_UNSIGNED_BYTE, true, offsetof(Instance, radius));
    glVertexArrayVertexBuffer(vertices, 0, instances, 0, sizeof(Instance));
    glVertexArrayBindingDivisor(vertices, 0, 1);
}

/// Rows one after the other in our own memory, whatever the host set.
void set_unpacking() {
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    for (const GLenum name : {GL_UNPACK_ROW_LENGTH, GL_UNPACK_SKIP_ROWS, GL_UNPACK_SKIP_PIXELS, GL_UNPACK_SKIP_IMAGES,
                              GL_UNPACK_IMAGE_HEIGHT, GL_UNPACK_SWAP_BYTES, GL_UNPACK_LSB_FIRST}) {
        glPixelStorei(name, 0);
    }
}

}  // namespace

Renderer::Renderer() {
    GLint texels = 0;
    glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &texels);
    if (texels < atlas_texels) throw std::runtime_error("the driver's buffer textures are too small for text");
    std::string fault;
    if (!reload(embedded("ui.vert"), embedded("ui.frag"), fault)) throw std::runtime_error(fault);
    glCreateVertexArrays(1, &vertices_);
    glCreateBuffers(1, &instances_);
    glCreateBuffers(1, &clips_);
    glCreateBuffers(1, &atlas_);
    glCreateTextures(GL_TEXTURE_BUFFER, 1, &atlas_texture_);
    describe_instances(vertices_, instances_);

    glCreateSamplers(1, &sampler_);
    for (const GLenum name : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER}) {
        glSamplerParameteri(sampler_, name, GL_LINEAR);
    }
    for (const GLenum name : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T}) {
        glSamplerParameteri(sampler_, name, GL_CLAMP_TO_EDGE);
    }
    GLint alignment = 256;
    glGetIntegerv(GL_UNIFORM_BUFFER_OFFSET_ALIGNMENT, &alignment);
    clip_alignment_ = std::max(sizeof(glm::vec4), static_cast<std::size_t>(alignment)) / sizeof(glm::vec4);
}

Renderer::~Renderer() {
    for (const unsigned program : programs_) glDeleteProgram(program);
    for (const Picture& picture : pictures_) glDeleteTextures(1, &picture.texture);
    glDeleteTextures(1, &atlas_texture_);
    glDeleteSamplers(1, &sampler_);
    glDeleteBuffers(1, &atlas_);
    glDeleteBuffers(1, &instances_);
    glDeleteBuffers(1, &clips_);
    glDeleteVertexArrays(1, &vertices_);
}

bool Renderer::reload(std::string_view vertex, std::string_view fragment, std::string& fault) {
    fault.clear();
    Programs made{};
    const std::string constants = shader_constants();
    made[0] = link(vertex, fragment, constants, fault);
    if (fault.empty()) made[1] = link(vertex, fragment, "#define LAPFX_UI_PICTURES\n" + constants, fault);
    const bool good = fault.empty();
    if (good) std::swap(made, programs_);
    for (const unsigned program : made) glDeleteProgram(program);
    return good;
}

// --- sending ---

/// Whole rows: the atlas is a buffer (shaders/ui.frag says why).
void Renderer::send_atlas(Fonts& fonts) {
    const Atlas& atlas = fonts.atlas();
    const bool whole = atlas.size != atlas_size_ || atlas.resets != atlas_resets_;
    const auto width = static_cast<std::size_t>(atlas.size.x);
    const int first = whole ? 0 : atlas.dirty.y, end = whole ? atlas.size.y : atlas.dirty.w;
    if (end <= first) return;
    const std::size_t bytes = static_cast<std::size_t>(end - first) * width;
    if (atlas.size != atlas_size_) {
        glNamedBufferData(atlas_, static_cast<GLsizeiptr>(bytes), atlas.pixels.data(), GL_DYNAMIC_DRAW);
        glTextureBuffer(atlas_texture_, GL_R8, atlas_);
    } else {
        const std::size_t offset = static_cast<std::size_t>(first) * width;
        glNamedBufferSubData(atlas_, static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(bytes),
                             &atlas.pixels[offset]);
    }
    atlas_size_ = atlas.size;
    atlas_resets_ = atlas.resets;
    last_.bytes += bytes;
    fonts.clear_dirty();
}

void Renderer::send_picture(Picture& picture, const StoredImage& image) {
    if (picture.texture == 0 || picture.size != image.size) {
        glDeleteTextures(1, &picture.texture);
        glCreateTextures(GL_TEXTURE_2D, 1, &picture.texture);
        glTextureStorage2D(picture.texture, 1, GL_RGBA8, image.size.x, image.size.y);
        picture.size = image.size;
    }
    set_unpacking();
    glTextureSubImage2D(picture.texture, 0, 0, 0, image.size.x, image.size.y, GL_RGBA, GL_UNSIGNED_BYTE,
                        image.pixels.data());
    picture.serial = image.serial;
    last_.bytes += image.pixels.size();
}

/// Only what this frame shows; textures of images that are no more go.
void Renderer::send_pictures(const DrawList& list, const ImageStore* images) {
    const std::span<const StoredImage> all = images != nullptr ? images->all() : std::span<const StoredImage>{};
    for (std::size_t i = 0; i < pictures_.size(); ++i) {
        if (pictures_[i].texture == 0 || (i < all.size() && all[i].serial != 0)) continue;
        glDeleteTextures(1, &pictures_[i].texture);
        pictures_[i] = {};
    }
    if (pictures_.size() < all.size()) pictures_.resize(all.size());
    for (const Batch& batch : list.batches) {
        for (const ImageHandle image : batch.images) {
            if (image < own_images || image - own_images >= all.size()) continue;
            const StoredImage& stored = all[image - own_images];
            Picture& picture = pictures_[image - own_images];
            if (stored.serial != 0 && stored.serial != picture.serial) send_picture(picture, stored);
        }
    }
}

unsigned Renderer::texture_of(ImageHandle image) const {
    if (image < own_images) return static_cast<unsigned>(image);
    return image - own_images < pictures_.size() ? pictures_[image - own_images].texture : 0;
}

/// A new store each frame: the driver need not wait until the last one is drawn.
void Renderer::send_instances(const DrawList& list) {
    const std::size_t bytes = list.instances.size() * sizeof(Instance);
    glNamedBufferData(instances_, static_cast<GLsizeiptr>(bytes), list.instances.data(), GL_STREAM_DRAW);
    last_.bytes += bytes;
}

/// The tables of all batches, each where a uniform block may begin, and a whole block's room behind the last.
void Renderer::send_clips(const DrawList& list) {
    clip_table_.clear();
    for (const Batch& batch : list.batches) {
        for (std::uint32_t i = 0; i < batch.clips; ++i) {
            const Rect& clip = list.clips[batch.first_clip + i];
            clip_table_.emplace_back(clip.x, clip.y, clip.right(), clip.bottom());
        }
        const std::size_t steps = (clip_table_.size() + clip_alignment_ - 1) / clip_alignment_;
        clip_table_.resize(steps * clip_alignment_);
    }
    clip_table_.resize(clip_table_.size() + clip_block);
    const std::size_t bytes = clip_table_.size() * sizeof(glm::vec4);
    glNamedBufferData(clips_, static_cast<GLsizeiptr>(bytes), clip_table_.data(), GL_STREAM_DRAW);
    last_.bytes += bytes;
}

// --- drawing ---

void Renderer::set_state(const DrawList& list, unsigned framebuffer) const {
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
    glViewport(0, 0, list.size.x, list.size.y);
    for (const GLenum off :
         {GL_DEPTH_TEST, GL_STENCIL_TEST, GL_CULL_FACE, GL_COLOR_LOGIC_OP, GL_FRAMEBUFFER_SRGB, GL_RASTERIZER_DISCARD,
          GL_SAMPLE_ALPHA_TO_COVERAGE, GL_SAMPLE_ALPHA_TO_ONE, GL_SAMPLE_COVERAGE, GL_SAMPLE_MASK, GL_SCISSOR_TEST}) {
        glDisable(off);
    }
    for (GLenum plane = 0; plane < 8; ++plane) glDisable(GL_CLIP_DISTANCE0 + plane);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    glClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
    glDepthRange(0, 1);
    glEnable(GL_BLEND);
    glBlendEquation(GL_FUNC_ADD);
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    glBindVertexArray(vertices_);
    for (GLuint unit = 0; unit < 3; ++unit) glBindSampler(unit, sampler_);
    glBindTextureUnit(0, atlas_texture_);
    glProgramUniform1i(programs_[0], width_uniform, atlas_size_.x);
    for (const unsigned program : programs_) {
        glProgramUniform2f(program, pixel_uniform, 2.0F / static_cast<float>(list.size.x),
                           2.0F / static_cast<float>(list.size.y));
    }
}

void Renderer::clear(const DrawList& list) {
    if (list.clears.empty()) return;
    const Rect whole{0, 0, static_cast<float>(list.size.x), static_cast<float>(list.size.y)};
    glEnable(GL_SCISSOR_TEST);
    for (const Clear& clear : list.clears) {
        const Rect rect = intersect(clear.rect, whole);
        const auto left = static_cast<int>(std::lround(rect.x)), right = static_cast<int>(std::lround(rect.right()));
        const auto top = static_cast<int>(std::lround(rect.y)), bottom = static_cast<int>(std::lround(rect.bottom()));
        if (right <= left || bottom <= top) continue;
        const glm::vec4 color = glm::vec4(clear.color.r, clear.color.g, clear.color.b, 255) / 255.0F;
        glScissor(left, list.size.y - bottom, right - left, bottom - top);
        glClearBufferfv(GL_COLOR, 0, &color.x);
        ++last_.clears;
    }
    glDisable(GL_SCISSOR_TEST);
}

/// One call for all neighbours that one program draws.
void Renderer::draw_batch(const DrawList& list, const Batch& batch, std::size_t clip_offset) {
    glBindBufferRange(GL_UNIFORM_BUFFER, 0, clips_, static_cast<GLintptr>(clip_offset * sizeof(glm::vec4)),
                      clip_block * sizeof(glm::vec4));
    for (GLuint i = 0; i < 2; ++i) {
        if (batch.images[i] != 0) glBindTextureUnit(1 + i, texture_of(batch.images[i]));
    }
    const std::uint32_t end = batch.first + batch.count;
    for (std::uint32_t from = batch.first; from < end;) {
        const int program = program_of(list.instances[from].kind);
        std::uint32_t to = from + 1;
        while (to < end && program_of(list.instances[to].kind) == program) ++to;
        glUseProgram(programs_[static_cast<std::size_t>(program)]);
        glDrawArraysInstancedBaseInstance(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(to - from), from);
        ++last_.draw_calls;
        from = to;
    }
}

void Renderer::draw(const DrawList& list, Fonts& fonts, const ImageStore* images, unsigned framebuffer) {
    last_ = {};
    if (list.size.x <= 0 || list.size.y <= 0) return;
    send_atlas(fonts);
    send_pictures(list, images);
    send_instances(list);
    send_clips(list);
    set_state(list, framebuffer);
    clear(list);
    std::size_t clip_offset = 0;
    for (const Batch& batch : list.batches) {
        draw_batch(list, batch, clip_offset);
        clip_offset += (batch.clips + clip_alignment_ - 1) / clip_alignment_ * clip_alignment_;
    }
}

}  // namespace lapfx::ui
