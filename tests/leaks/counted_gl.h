// Functions of OpenGL that count which objects live, context by context, for Context::external().
#pragma once

#include <EGL/egl.h>

#include <cstdio>
#include <cstdlib>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "gl/gl.h"
#include "lapfx/context.h"

namespace lapfx::test::counted_gl {

/// Those whose names are made and deleted many at a time: glGenBuffers, glCreateBuffers, glDeleteBuffers.
inline constexpr const char* kinds[] = {"Buffers", "Textures", "Framebuffers",     "Renderbuffers",     "VertexArrays",
                                        "Queries", "Samplers", "ProgramPipelines", "TransformFeedbacks"};
inline constexpr const char *shaders = "Shader", *programs = "Program", *syncs = "Sync", *mappings = "Mapping";

using Name = std::uintptr_t;  // of an object, or the address of a sync object

struct Counted {
    std::set<std::tuple<EGLContext, std::string, Name>> live;
    std::map<std::string, int> made;  ///< so far
    std::vector<std::string> faults;  ///< deletes of what does not live, in the order of the calls
};

inline Counted& counted() {
    static Counted all;
    return all;
}

inline void born(const char* kind, Name name) {
    if (name == 0) return;  // the driver refused
    ++counted().made[kind];
    if (!counted().live.emplace(eglGetCurrentContext(), kind, name).second)
        counted().faults.push_back(std::string(kind) + " made twice");
}
inline void gone(const char* kind, Name name) {
    if (name != 0 && counted().live.erase({eglGetCurrentContext(), kind, name}) == 0)  // OpenGL takes no notice of 0
        counted().faults.push_back(std::string(kind) + ' ' + std::to_string(name) + " deleted, which does not live");
}

/// How many live, by kind, in a context that has not been destroyed, or in all.
inline std::map<std::string, int> live(EGLContext context = EGL_NO_CONTEXT) {
    std::map<std::string, int> by_kind;
    for (const auto& [of, kind, name] : counted().live)
        if (context == EGL_NO_CONTEXT || of == context) ++by_kind[kind];
    return by_kind;
}

/// The driver's own.
template <typename Function>
Function driver(const std::string& name) {
    return reinterpret_cast<Function>(eglGetProcAddress(name.c_str()));
}

template <std::size_t kind>
struct Many {
    static void gen(GLsizei count, GLuint* names) { make("glGen", count, names); }
    static void create(GLsizei count, GLuint* names) { make("glCreate", count, names); }
    static void create_of(GLenum target, GLsizei count, GLuint* names) {
        driver<PFNGLCREATETEXTURESPROC>(std::string("glCreate") + kinds[kind])(target, count, names);
        for (GLsizei i = 0; i < count; ++i) born(kinds[kind], names[i]);
    }
    static void remove(GLsizei count, const GLuint* names) {
        for (GLsizei i = 0; i < count; ++i) {
            gone(kinds[kind], names[i]);
            // A buffer that is deleted is mapped no more.
            if (kinds[kind] == std::string("Buffers"))
                counted().live.erase({eglGetCurrentContext(), mappings, names[i]});
        }
        driver<PFNGLDELETEBUFFERSPROC>(std::string("glDelete") + kinds[kind])(count, names);
    }

  private:
    static void make(const char* verb, GLsizei count, GLuint* names) {
        driver<PFNGLCREATEBUFFERSPROC>(std::string(verb) + kinds[kind])(count, names);
        for (GLsizei i = 0; i < count; ++i) born(kinds[kind], names[i]);
    }
};

inline GLuint create_shader(GLenum stage) {
    const GLuint name = driver<PFNGLCREATESHADERPROC>("glCreateShader")(stage);
    born(shaders, name);
    return name;
}
inline void delete_shader(GLuint name) {
    gone(shaders, name);
    driver<PFNGLDELETESHADERPROC>("glDeleteShader")(name);
}
inline GLuint create_program() {
    const GLuint name = driver<PFNGLCREATEPROGRAMPROC>("glCreateProgram")();
    born(programs, name);
    return name;
}
inline void delete_program(GLuint name) {
    gone(programs, name);
    driver<PFNGLDELETEPROGRAMPROC>("glDeleteProgram")(name);
}
inline GLsync fence_sync(GLenum condition, GLbitfield flags) {
    GLsync const made = driver<PFNGLFENCESYNCPROC>("glFenceSync")(condition, flags);
    born(syncs, reinterpret_cast<Name>(made));
    return made;
}
inline void delete_sync(GLsync sync) {
    gone(syncs, reinterpret_cast<Name>(sync));
    driver<PFNGLDELETESYNCPROC>("glDeleteSync")(sync);
}
inline void* map_named_buffer_range(GLuint name, GLintptr offset, GLsizeiptr length, GLbitfield access) {
    void* const at = driver<PFNGLMAPNAMEDBUFFERRANGEPROC>("glMapNamedBufferRange")(name, offset, length, access);
    born(mappings, at == nullptr ? 0 : name);
    return at;
}
inline GLboolean unmap_named_buffer(GLuint name) {
    gone(mappings, name);
    return driver<PFNGLUNMAPNAMEDBUFFERPROC>("glUnmapNamedBuffer")(name);
}

/// In place of each function that makes or deletes objects and is not counted here: the core calls none.
inline void uncounted() {
    std::fputs("a function of OpenGL was called that makes or deletes what counted_gl.h does not count\n", stderr);
    std::abort();
}

template <typename Function>
Context::Function any(Function* function) {
    return reinterpret_cast<Context::Function>(function);
}

inline const std::map<std::string, Context::Function>& counting() {
    static const std::map<std::string, Context::Function> all = [] {
        std::map<std::string, Context::Function> table{{"glCreateShader", any(create_shader)},
                                                       {"glDeleteShader", any(delete_shader)},
                                                       {"glCreateProgram", any(create_program)},
                                                       {"glDeleteProgram", any(delete_program)},
                                                       {"glFenceSync", any(fence_sync)},
                                                       {"glDeleteSync", any(delete_sync)},
                                                       {"glMapNamedBufferRange", any(map_named_buffer_range)},
                                                       {"glUnmapNamedBuffer", any(unmap_named_buffer)}};
        [&table]<std::size_t... kind>(std::index_sequence<kind...>) {
            const auto add = [&table](const std::string& name, Context::Function gen, Context::Function create,
                                      Context::Function create_of, Context::Function remove) {
                table["glGen" + name] = gen;
                table["glCreate" + name] = name == "Textures" || name == "Queries" ? create_of : create;
                table["glDelete" + name] = remove;
            };
            (add(kinds[kind], any(Many<kind>::gen), any(Many<kind>::create), any(Many<kind>::create_of),
                 any(Many<kind>::remove)),
             ...);
        }
        (std::make_index_sequence<std::size(kinds)>());
        return table;
    }();
    return all;
}

/// For Context::external(), where a context of EGL is current.
inline Context::Function get_proc_address(const char* name) {
    const std::string text = name;
    if (const auto found = counting().find(text); found != counting().end()) return found->second;
    for (const char* verb : {"glGen", "glCreate", "glDelete", "glMap", "glUnmap", "glFenceSync", "glImport"})
        if (text.starts_with(verb) && !text.starts_with("glGenerate")) return uncounted;
    return eglGetProcAddress(name);
}

}  // namespace lapfx::test::counted_gl
