// Mesa's off-screen renderer. It is opened privately with dlopen, because a linked one would clash with the GLX of a
// window.
#include <dlfcn.h>

#include <array>
#include <cstdint>

#include "gl/context_owner.h"

namespace lapfx::gl {

namespace {

// The few declarations of GL/osmesa.h that we use (Mesa 3-D graphics library, OSMesa interface 11.2).
constexpr int osmesa_format = 0x22, osmesa_depth_bits = 0x30, osmesa_profile = 0x33, osmesa_core_profile = 0x34,
              osmesa_major_version = 0x36, osmesa_minor_version = 0x37, format_rgba = 0x1908,
              type_unsigned_byte = 0x1401;
using OSMesaContext = void*;
using CreateContextAttribs = OSMesaContext (*)(const int* attributes, OSMesaContext share);
using MakeCurrent = unsigned char (*)(OSMesaContext, void* buffer, unsigned type, int width, int height);
using DestroyContext = void (*)(OSMesaContext);

struct OsmesaOwner : Context::Owner {
    void* library = nullptr;
    OSMesaContext context = nullptr;
    DestroyContext destroy = nullptr;
    Context::GetProcAddress get = nullptr;
    std::array<std::uint8_t, 16 * 16 * 4> pixels{};  // it requires a default framebuffer; we draw into our own

    ~OsmesaOwner() override {
        // The library stays open: Mesa registers thread-exit handlers that would point into unmapped code.
        if (context != nullptr) destroy(context);
    }
    Context::GetProcAddress get_proc_address() const override { return get; }
    std::string name() const override { return "OSMesa"; }
};

}  // namespace

std::unique_ptr<Context::Owner> make_osmesa(std::string& reason) {
    auto owner = std::make_unique<OsmesaOwner>();
    for (const char* name : {"libOSMesa.so.8", "libOSMesa.so"})
        if (owner->library == nullptr) owner->library = dlopen(name, RTLD_NOW | RTLD_LOCAL);
    if (owner->library == nullptr) {
        reason = "libOSMesa.so.8 is not installed";
        return nullptr;
    }
    const auto create = reinterpret_cast<CreateContextAttribs>(dlsym(owner->library, "OSMesaCreateContextAttribs"));
    const auto make_current = reinterpret_cast<MakeCurrent>(dlsym(owner->library, "OSMesaMakeCurrent"));
    owner->destroy = reinterpret_cast<DestroyContext>(dlsym(owner->library, "OSMesaDestroyContext"));
    owner->get = reinterpret_cast<Context::GetProcAddress>(dlsym(owner->library, "OSMesaGetProcAddress"));
    if (create == nullptr || make_current == nullptr || owner->destroy == nullptr || owner->get == nullptr) {
        reason = "libOSMesa is too old";
        return nullptr;
    }
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
    owner->context = create(attributes, nullptr);
    if (owner->context == nullptr ||
        make_current(owner->context, owner->pixels.data(), type_unsigned_byte, 16, 16) == 0) {
        reason = "it offers no OpenGL 4.5 core context";
        return nullptr;
    }
    return owner;
}

}  // namespace lapfx::gl
