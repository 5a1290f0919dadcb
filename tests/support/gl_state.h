// All of OpenGL 4.5's state that a call could leave changed, by name: what is set, bound and enabled in the context,
// and in the objects that are bound to draw with. Two of them are compared to see that a call leaves a host's state
// alone. Queries change nothing but the active texture, which is put back.
//
//     const test::GlState before = test::gl_state();
//     effects.draw_organ(view);
//     EXPECT_EQ(test::changes(before, test::gl_state()), "");
#pragma once

#ifndef __glew_h__  // a host of VTK's has another loader
#include <glad/gl.h>
#endif
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace lapfx::test {

using GlState = std::map<std::string, std::vector<double>>;

namespace gl_state_parts {

struct Query {
    GLenum name;
    int values = 1;
};

inline constexpr GLenum switches[] = {GL_BLEND,
                                      GL_COLOR_LOGIC_OP,
                                      GL_CULL_FACE,
                                      GL_DEBUG_OUTPUT,
                                      GL_DEBUG_OUTPUT_SYNCHRONOUS,
                                      GL_DEPTH_CLAMP,
                                      GL_DEPTH_TEST,
                                      GL_DITHER,
                                      GL_FRAMEBUFFER_SRGB,
                                      GL_LINE_SMOOTH,
                                      GL_MULTISAMPLE,
                                      GL_POLYGON_OFFSET_FILL,
                                      GL_POLYGON_OFFSET_LINE,
                                      GL_POLYGON_OFFSET_POINT,
                                      GL_POLYGON_SMOOTH,
                                      GL_PRIMITIVE_RESTART,
                                      GL_PRIMITIVE_RESTART_FIXED_INDEX,
                                      GL_PROGRAM_POINT_SIZE,
                                      GL_RASTERIZER_DISCARD,
                                      GL_SAMPLE_ALPHA_TO_COVERAGE,
                                      GL_SAMPLE_ALPHA_TO_ONE,
                                      GL_SAMPLE_COVERAGE,
                                      GL_SAMPLE_MASK,
                                      GL_SAMPLE_SHADING,
                                      GL_SCISSOR_TEST,
                                      GL_STENCIL_TEST,
                                      GL_TEXTURE_CUBE_MAP_SEAMLESS};

inline constexpr Query values[] = {{GL_ACTIVE_TEXTURE},
                                   {GL_ARRAY_BUFFER_BINDING},
                                   {GL_ATOMIC_COUNTER_BUFFER_BINDING},
                                   {GL_BLEND_COLOR, 4},
                                   {GL_CLAMP_READ_COLOR},
                                   {GL_CLIP_DEPTH_MODE},
                                   {GL_CLIP_ORIGIN},
                                   {GL_COLOR_CLEAR_VALUE, 4},
                                   {GL_COPY_READ_BUFFER_BINDING},
                                   {GL_COPY_WRITE_BUFFER_BINDING},
                                   {GL_CULL_FACE_MODE},
                                   {GL_CURRENT_PROGRAM},
                                   {GL_DEBUG_GROUP_STACK_DEPTH},
                                   {GL_DEPTH_CLEAR_VALUE},
                                   {GL_DEPTH_FUNC},
                                   {GL_DEPTH_WRITEMASK},
                                   {GL_DISPATCH_INDIRECT_BUFFER_BINDING},
                                   {GL_DRAW_FRAMEBUFFER_BINDING},
                                   {GL_DRAW_INDIRECT_BUFFER_BINDING},
                                   {GL_FRAGMENT_SHADER_DERIVATIVE_HINT},
                                   {GL_FRONT_FACE},
                                   {GL_LINE_SMOOTH_HINT},
                                   {GL_LINE_WIDTH},
                                   {GL_LOGIC_OP_MODE},
                                   {GL_MIN_SAMPLE_SHADING_VALUE},
                                   {GL_PACK_ALIGNMENT},
                                   {GL_PACK_IMAGE_HEIGHT},
                                   {GL_PACK_LSB_FIRST},
                                   {GL_PACK_ROW_LENGTH},
                                   {GL_PACK_SKIP_IMAGES},
                                   {GL_PACK_SKIP_PIXELS},
                                   {GL_PACK_SKIP_ROWS},
                                   {GL_PACK_SWAP_BYTES},
                                   {GL_PATCH_DEFAULT_INNER_LEVEL, 2},
                                   {GL_PATCH_DEFAULT_OUTER_LEVEL, 4},
                                   {GL_PATCH_VERTICES},
                                   {GL_PIXEL_PACK_BUFFER_BINDING},
                                   {GL_PIXEL_UNPACK_BUFFER_BINDING},
                                   {GL_POINT_FADE_THRESHOLD_SIZE},
                                   {GL_POINT_SIZE},
                                   {GL_POINT_SPRITE_COORD_ORIGIN},
                                   {GL_POLYGON_MODE, 2},
                                   {GL_POLYGON_OFFSET_FACTOR},
                                   {GL_POLYGON_OFFSET_UNITS},
                                   {GL_POLYGON_SMOOTH_HINT},
                                   {GL_PRIMITIVE_RESTART_INDEX},
                                   {GL_PROGRAM_PIPELINE_BINDING},
                                   {GL_PROVOKING_VERTEX},
                                   {GL_QUERY_BUFFER_BINDING},
                                   {GL_READ_BUFFER},
                                   {GL_READ_FRAMEBUFFER_BINDING},
                                   {GL_RENDERBUFFER_BINDING},
                                   {GL_SAMPLE_COVERAGE_INVERT},
                                   {GL_SAMPLE_COVERAGE_VALUE},
                                   {GL_SHADER_STORAGE_BUFFER_BINDING},
                                   {GL_STENCIL_BACK_FAIL},
                                   {GL_STENCIL_BACK_FUNC},
                                   {GL_STENCIL_BACK_PASS_DEPTH_FAIL},
                                   {GL_STENCIL_BACK_PASS_DEPTH_PASS},
                                   {GL_STENCIL_BACK_REF},
                                   {GL_STENCIL_BACK_VALUE_MASK},
                                   {GL_STENCIL_BACK_WRITEMASK},
                                   {GL_STENCIL_CLEAR_VALUE},
                                   {GL_STENCIL_FAIL},
                                   {GL_STENCIL_FUNC},
                                   {GL_STENCIL_PASS_DEPTH_FAIL},
                                   {GL_STENCIL_PASS_DEPTH_PASS},
                                   {GL_STENCIL_REF},
                                   {GL_STENCIL_VALUE_MASK},
                                   {GL_STENCIL_WRITEMASK},
                                   {GL_TEXTURE_BUFFER_BINDING},
                                   {GL_TEXTURE_COMPRESSION_HINT},
                                   {GL_TRANSFORM_FEEDBACK_ACTIVE},
                                   {GL_TRANSFORM_FEEDBACK_BINDING},
                                   {GL_TRANSFORM_FEEDBACK_PAUSED},
                                   {GL_UNIFORM_BUFFER_BINDING},
                                   {GL_UNPACK_ALIGNMENT},
                                   {GL_UNPACK_IMAGE_HEIGHT},
                                   {GL_UNPACK_LSB_FIRST},
                                   {GL_UNPACK_ROW_LENGTH},
                                   {GL_UNPACK_SKIP_IMAGES},
                                   {GL_UNPACK_SKIP_PIXELS},
                                   {GL_UNPACK_SKIP_ROWS},
                                   {GL_UNPACK_SWAP_BYTES},
                                   {GL_VERTEX_ARRAY_BINDING}};

/// One each for every draw buffer.
inline constexpr GLenum of_draw_buffers[] = {GL_BLEND_SRC_RGB,   GL_BLEND_DST_RGB,      GL_BLEND_SRC_ALPHA,
                                             GL_BLEND_DST_ALPHA, GL_BLEND_EQUATION_RGB, GL_BLEND_EQUATION_ALPHA};

/// One each for every texture unit.
inline constexpr GLenum of_units[] = {GL_TEXTURE_BINDING_1D,
                                      GL_TEXTURE_BINDING_1D_ARRAY,
                                      GL_TEXTURE_BINDING_2D,
                                      GL_TEXTURE_BINDING_2D_ARRAY,
                                      GL_TEXTURE_BINDING_2D_MULTISAMPLE,
                                      GL_TEXTURE_BINDING_2D_MULTISAMPLE_ARRAY,
                                      GL_TEXTURE_BINDING_3D,
                                      GL_TEXTURE_BINDING_BUFFER,
                                      GL_TEXTURE_BINDING_CUBE_MAP,
                                      GL_TEXTURE_BINDING_CUBE_MAP_ARRAY,
                                      GL_TEXTURE_BINDING_RECTANGLE,
                                      GL_SAMPLER_BINDING};

/// Bindings that have an index: their number, and what is asked of each.
struct Indexed {
    GLenum count;
    std::vector<GLenum> queries;
};
inline const std::vector<Indexed>& indexed() {
    static const std::vector<Indexed> all = {
        {GL_MAX_UNIFORM_BUFFER_BINDINGS, {GL_UNIFORM_BUFFER_BINDING, GL_UNIFORM_BUFFER_START, GL_UNIFORM_BUFFER_SIZE}},
        {GL_MAX_SHADER_STORAGE_BUFFER_BINDINGS,
         {GL_SHADER_STORAGE_BUFFER_BINDING, GL_SHADER_STORAGE_BUFFER_START, GL_SHADER_STORAGE_BUFFER_SIZE}},
        {GL_MAX_ATOMIC_COUNTER_BUFFER_BINDINGS,
         {GL_ATOMIC_COUNTER_BUFFER_BINDING, GL_ATOMIC_COUNTER_BUFFER_START, GL_ATOMIC_COUNTER_BUFFER_SIZE}},
        {GL_MAX_TRANSFORM_FEEDBACK_BUFFERS,
         {GL_TRANSFORM_FEEDBACK_BUFFER_BINDING, GL_TRANSFORM_FEEDBACK_BUFFER_START, GL_TRANSFORM_FEEDBACK_BUFFER_SIZE}},
        {GL_MAX_IMAGE_UNITS,
         {GL_IMAGE_BINDING_NAME, GL_IMAGE_BINDING_LEVEL, GL_IMAGE_BINDING_LAYERED, GL_IMAGE_BINDING_LAYER,
          GL_IMAGE_BINDING_ACCESS, GL_IMAGE_BINDING_FORMAT}},
        {GL_MAX_SAMPLE_MASK_WORDS, {GL_SAMPLE_MASK_VALUE}},
    };
    return all;
}

inline std::string named(const char* what, GLenum query, int index = -1) {
    std::ostringstream text;
    text << what << " 0x" << std::hex << query << std::dec;
    if (index >= 0) text << " of " << index;
    return text.str();
}

inline int count_of(GLenum query) {
    GLint count = 0;
    glGetIntegerv(query, &count);
    return count;
}

inline void add_context(GlState& all) {
    for (const GLenum query : switches) all[named("switch", query)] = {static_cast<double>(glIsEnabled(query))};
    for (int i = 0; i < count_of(GL_MAX_CLIP_DISTANCES); ++i)
        all[named("switch", GL_CLIP_DISTANCE0, i)] = {
            static_cast<double>(glIsEnabled(GL_CLIP_DISTANCE0 + static_cast<GLenum>(i)))};
    for (const Query& query : values) {
        GLdouble found[4] = {};
        glGetDoublev(query.name, found);
        all[named("value", query.name)].assign(found, found + query.values);
    }
    for (const Indexed& binding : indexed())
        for (int i = 0; i < count_of(binding.count); ++i)
            for (const GLenum query : binding.queries) {
                GLint64 found = 0;
                glGetInteger64i_v(query, static_cast<GLuint>(i), &found);
                all[named("binding", query, i)] = {static_cast<double>(found)};
            }
}

inline void add_outputs(GlState& all) {
    for (int i = 0; i < count_of(GL_MAX_DRAW_BUFFERS); ++i) {
        const auto index = static_cast<GLuint>(i);
        all[named("switch", GL_BLEND, i)] = {static_cast<double>(glIsEnabledi(GL_BLEND, index))};
        GLboolean mask[4] = {};
        glGetBooleani_v(GL_COLOR_WRITEMASK, index, mask);
        all[named("value", GL_COLOR_WRITEMASK, i)].assign(mask, mask + 4);
        for (const GLenum query : of_draw_buffers) {
            GLint found = 0;
            glGetIntegeri_v(query, index, &found);
            all[named("value", query, i)] = {static_cast<double>(found)};
        }
        all[named("draw buffer", GL_DRAW_BUFFER0, i)] = {
            static_cast<double>(count_of(GL_DRAW_BUFFER0 + static_cast<GLenum>(i)))};
    }
    for (int i = 0; i < count_of(GL_MAX_VIEWPORTS); ++i) {
        const auto index = static_cast<GLuint>(i);
        all[named("switch", GL_SCISSOR_TEST, i)] = {static_cast<double>(glIsEnabledi(GL_SCISSOR_TEST, index))};
        for (const Query& query : {Query{GL_VIEWPORT, 4}, Query{GL_SCISSOR_BOX, 4}, Query{GL_DEPTH_RANGE, 2}}) {
            GLdouble found[4] = {};
            glGetDoublei_v(query.name, index, found);
            all[named("value", query.name, i)].assign(found, found + query.values);
        }
    }
}

inline void add_units(GlState& all) {
    const int active = count_of(GL_ACTIVE_TEXTURE);
    for (int i = 0; i < count_of(GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS); ++i) {
        glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(i));
        for (const GLenum query : of_units) all[named("unit", query, i)] = {static_cast<double>(count_of(query))};
    }
    glActiveTexture(static_cast<GLenum>(active));
}

/// The vertex array that is bound, and the values of attributes that are off.
inline void add_vertices(GlState& all) {
    const bool bound = count_of(GL_VERTEX_ARRAY_BINDING) != 0;  // a core context has no other one
    if (bound) all["index buffer"] = {static_cast<double>(count_of(GL_ELEMENT_ARRAY_BUFFER_BINDING))};
    for (int i = 0; i < count_of(GL_MAX_VERTEX_ATTRIBS); ++i) {
        const auto index = static_cast<GLuint>(i);
        if (i > 0) {
            GLdouble current[4] = {};
            glGetVertexAttribdv(index, GL_CURRENT_VERTEX_ATTRIB, current);
            all[named("attribute", GL_CURRENT_VERTEX_ATTRIB, i)].assign(current, current + 4);
        }
        if (!bound) continue;
        for (const GLenum query :
             {GL_VERTEX_ATTRIB_ARRAY_ENABLED, GL_VERTEX_ATTRIB_ARRAY_SIZE, GL_VERTEX_ATTRIB_ARRAY_TYPE,
              GL_VERTEX_ATTRIB_ARRAY_STRIDE, GL_VERTEX_ATTRIB_ARRAY_NORMALIZED, GL_VERTEX_ATTRIB_ARRAY_INTEGER,
              GL_VERTEX_ATTRIB_ARRAY_DIVISOR, GL_VERTEX_ATTRIB_ARRAY_BUFFER_BINDING, GL_VERTEX_ATTRIB_BINDING,
              GL_VERTEX_ATTRIB_RELATIVE_OFFSET}) {
            GLint found = 0;
            glGetVertexAttribiv(index, query, &found);
            all[named("attribute", query, i)] = {static_cast<double>(found)};
        }
        for (const GLenum query : {GL_VERTEX_BINDING_OFFSET, GL_VERTEX_BINDING_STRIDE, GL_VERTEX_BINDING_DIVISOR,
                                   GL_VERTEX_BINDING_BUFFER}) {
            GLint64 found = 0;
            glGetInteger64i_v(query, index, &found);
            all[named("attribute", query, i)] = {static_cast<double>(found)};
        }
    }
}

/// Queries that have begun and not ended.
inline void add_queries(GlState& all) {
    for (const GLenum target : {GL_SAMPLES_PASSED, GL_ANY_SAMPLES_PASSED, GL_ANY_SAMPLES_PASSED_CONSERVATIVE,
                                GL_TIME_ELAPSED, GL_PRIMITIVES_GENERATED, GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN}) {
        GLint found = 0;
        glGetQueryiv(target, GL_CURRENT_QUERY, &found);
        all[named("query", target)] = {static_cast<double>(found)};
    }
}

}  // namespace gl_state_parts

inline GlState gl_state() {
    GlState all;
    gl_state_parts::add_context(all);
    gl_state_parts::add_outputs(all);
    gl_state_parts::add_units(all);
    gl_state_parts::add_vertices(all);
    gl_state_parts::add_queries(all);
    return all;
}

/// "value 0xb74: 513, before 515", a line for each.
inline std::string changes(const GlState& before, const GlState& after) {
    std::ostringstream told;
    for (const auto& [name, found] : after) {
        const auto& expected = before.at(name);
        if (found == expected) continue;
        told << name << ":";
        for (const double value : found) told << ' ' << value;
        told << ", before";
        for (const double value : expected) told << ' ' << value;
        told << '\n';
    }
    return told.str();
}

}  // namespace lapfx::test
