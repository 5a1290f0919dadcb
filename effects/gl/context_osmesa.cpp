// Mesa's off-screen renderer. It is opened privately with dlopen, because a linked one would clash with the GLX of a
// window.
#include <dlfcn.h>

#include <array>
#include <cstdint>

#include "gl/context_hold.h"
#include "gl/context_owner.h"

namespace lapfx::gl {

namespace {

// The few declarations of GL/osmesa.h that we use (Mesa 3-D graphics library, OSMesa interface 11.2).
constexpr int osmesa_format = 0x22, osmesa_depth_bits = 0x30, osmesa_profile = 0x33, osmesa_core_profile = 0x34,
              osmesa_major_version = 0x36, osmesa_minor_version = 0x37, format_rgba = 0x1908, osmesa_type = 0x23,
              type_unsigned_byte = 0x1401;
using OSMesaContext = void*;
using CreateContextAttribs = OSMesaContext (*)(const int* attributes, OSMesaContext share);
using MakeCurrent = unsigned char (*)(OSMesaContext, void* buffer, unsigned type, int width, int height);
using DestroyContext = void (*)(OSMesaContext);
using GetCurrentContext = OSMesaContext (*)();
using GetColorBuffer = unsigned char (*)(OSMesaContext, int* width, int* height, int* format, void** buffer);
using GetIntegerv = void (*)(int name, int* value);

struct Osmesa {
    void* library = nullptr;
    CreateContextAttribs create = nullptr;
    MakeCurrent make_current = nullptr;
    DestroyContext destroy = nullptr;
    GetCurrentContext get_current = nullptr;
    GetColorBuffer get_color_buffer = nullptr;
    GetIntegerv get_integer = nullptr;
    Context::GetProcAddress get_proc_address = nullptr;

    /// Why it cannot be used, or empty.
    std::string open() {
        for (const char* name : {"libOSMesa.so.8", "libOSMesa.so"})
            if (library == nullptr) library = dlopen(name, RTLD_NOW | RTLD_LOCAL);
        if (library == nullptr) return "libOSMesa.so.8 is not installed";
        const bool found = find(create, "OSMesaCreateContextAttribs") && find(make_current, "OSMesaMakeCurrent") &&
                           find(destroy, "OSMesaDestroyContext") && find(get_current, "OSMesaGetCurrentContext") &&
                           find(get_color_buffer, "OSMesaGetColorBuffer") && find(get_integer, "OSMesaGetIntegerv") &&
                           find(get_proc_address, "OSMesaGetProcAddress");
        return found ? "" : "libOSMesa is too old";
    }

  private:
    template <typename F>
    bool find(F& function, const char* name) const {
        function = reinterpret_cast<F>(dlsym(library, name));
        return function != nullptr;
    }
};

struct OsmesaCurrent : Context::Owner::Current {
    explicit OsmesaCurrent(const Osmesa& functions) : make(functions.make_current), context(functions.get_current()) {
        if (context == nullptr) return;
        int format = 0;
        functions.get_integer(osmesa_type, &type);
        functions.get_color_buffer(context, &width, &height, &format, &buffer);
    }
    MakeCurrent make;
    OSMesaContext context;
    void* buffer = nullptr;
    int type = type_unsigned_byte, width = 0, height = 0;

    void make_current() const noexcept override { make(context, buffer, static_cast<unsigned>(type), width, height); }
};

struct OsmesaOwner : Context::Owner {
    Osmesa osmesa;
    OSMesaContext context = nullptr;
    mutable std::array<std::uint8_t, 16 * 16 * 4> pixels{};  // it requires a default framebuffer; we draw into our own

    ~OsmesaOwner() override {
        // The library stays open: Mesa registers thread-exit handlers that would point into unmapped code.
        if (context == nullptr) return;
        if (is_current()) release();
        osmesa.destroy(context);
    }
    bool is_current() const noexcept override { return osmesa.get_current() == context; }
    bool make_current() const noexcept override {
        if (osmesa.make_current(context, pixels.data(), type_unsigned_byte, 16, 16) != 0) return true;
        release();
        return false;
    }
    std::unique_ptr<Current> current() const override { return std::make_unique<OsmesaCurrent>(osmesa); }
    void release() const noexcept { osmesa.make_current(nullptr, nullptr, type_unsigned_byte, 0, 0); }
    Context::GetProcAddress get_proc_address() const override { return osmesa.get_proc_address; }
    std::string name() const override { return "OSMesa"; }
};

}  // namespace

std::unique_ptr<Context::Owner> make_osmesa(std::string& reason) {
    auto owner = std::make_unique<OsmesaOwner>();
    reason = owner->osmesa.open();
    if (!reason.empty()) return nullptr;
    require_same_functions(owner->osmesa.get_proc_address, owner->name());
    const int attributes[] = {osmesa_format,
                              format_rgba,
                              osmesa_depth_bits,
                              24,
                              osmesa_profile,
                              osmesa_core_profile,
                              osmesa_major_version,
                              4,
                              osmesa_minor_version,
                              5,
                              0};
    owner->context = owner->osmesa.create(attributes, nullptr);
    if (owner->context == nullptr || !owner->make_current()) {
        reason = "it offers no OpenGL 4.5 core context";
        return nullptr;
    }
    return owner;
}

}  // namespace lapfx::gl
