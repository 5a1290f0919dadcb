// The host in VTK (samples/host/vtk.cpp) as it is, but for one thing: every call of the core is watched. OpenGL's state
// is the same after it as before, all of it, but for what effects.h says of bind_bleeding(). What is not is told, and
// the exit code is 3; at the end the calls are told by name.
#include <lapfx/effects.h>
#include <vtk_glew.h>
#include <cstdio>
#include <cstdlib>

#include "support/gl_state.h"

namespace lapfx::test {

inline std::map<std::string, int> calls;

/// What one call changes: only names in `meant`, which have changed.
class Watch {
  public:
    explicit Watch(const char* call) : call_(call), before_(gl_state()) {}
    void end(std::initializer_list<std::string> meant = {}) {
        GlState after = gl_state();
        for (const std::string& name : meant) after.erase(name);
        const std::string changed = changes(before_, after);
        const GLenum error = glGetError();
        if (changed.empty() && error == GL_NO_ERROR) {
            ++calls[call_];
            return;
        }
        std::fprintf(stderr, "%s changed\n%serror 0x%x\n", call_, changed.c_str(), error);
        std::_Exit(3);
    }

  private:
    const char* call_;
    GlState before_;
};

template <typename Call>
void watched(const char* name, const Call& call) {
    Watch watch(name);
    call();
    watch.end();
}

/// The uniform binding of bind_bleeding().
inline std::initializer_list<std::string> bleeding_binding() {
    using gl_state_parts::named;
    static const std::initializer_list<std::string> names = {
        named("value", GL_UNIFORM_BUFFER_BINDING), named("binding", GL_UNIFORM_BUFFER_BINDING, 1),
        named("binding", GL_UNIFORM_BUFFER_START, 1), named("binding", GL_UNIFORM_BUFFER_SIZE, 1)};
    return names;
}

/// Watches a base that comes after it: how it is made, and how it ends.
class Around {
  protected:
    explicit Around(const char* begin) : watch_(begin) {}
    ~Around() { watch_.end(bleeding_binding()); }  // the buffer that bind_bleeding() left bound is no more
    void made(const char* end) {
        watch_.end();
        end_ = end;
    }
    void ends() { watch_ = Watch(end_); }

  private:
    Watch watch_;
    const char* end_ = "";
};

class WatchedEffects : Around, public Effects {
  public:
    WatchedEffects(const Organ& organ, const Preset& preset, const EffectsOptions& options)
        : Around("Effects"), Effects(organ, preset, options) {
        made("~Effects");
    }
    WatchedEffects(WatchedEffects&&) = delete;
    WatchedEffects& operator=(WatchedEffects&&) = delete;
    ~WatchedEffects() { ends(); }

    void set_curves(const Curves& curves) {
        watched("set_curves", [&] { Effects::set_curves(curves); });
    }
    void set_contacts(std::span<const ToolContact> contacts) {
        watched("set_contacts", [&] { Effects::set_contacts(contacts); });
    }
    void seek(double time) {
        watched("seek", [&] { Effects::seek(time); });
    }
    void draw_metal_clips(const View& view) {
        watched("draw_metal_clips", [&] { Effects::draw_metal_clips(view); });
    }
    void draw_smoke(const View& view, unsigned depth) {
        watched("draw_smoke", [&] { Effects::draw_smoke(view, depth); });
    }
    void bind_bleeding() const {
        Watch watch("bind_bleeding");
        Effects::bind_bleeding();
        watch.end(bleeding_binding());
        GLint bound = 0;
        glGetIntegeri_v(GL_UNIFORM_BUFFER_BINDING, 1, &bound);
        if (bound == 0) std::_Exit(3);
    }
};

struct Told {
    ~Told() {
        for (const auto& [name, count] : calls) std::fprintf(stderr, "%s %d\n", name.c_str(), count);
    }
};
inline const Told told;

}  // namespace lapfx::test

#define Effects test::WatchedEffects
#include "../../samples/host/vtk.cpp"
