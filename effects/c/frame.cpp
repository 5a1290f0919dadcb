#include <array>
#include <cmath>
#include <cstring>

#include "c/calls.h"
#include "c/objects.h"
#include "gl/gl.h"

namespace lapfx::c {

namespace {

using Stage = FrameObject::Stage;

CameraResponse response_of(const lapfx_response* response) {
    if (response == nullptr) return {};
    const lapfx_response& r = LAPFX_SIZED(lapfx_response, response);
    not_negative("response.exposure", r.exposure);
    finite("response.vignette", r.vignette);
    for (const double factor : r.white_balance) not_negative("response.white_balance", factor);
    not_negative("response.sharpening", r.sharpening);
    not_negative("response.saturation", r.saturation);
    finite("response.lens_falloff", r.lens_falloff);
    not_negative("response.toe", r.toe);
    if (r.curve != 0 && r.curve != 1) refuse_value("response.curve", "is neither 0, shoulder, nor 1, film");
    if (!(r.knee >= 0.0 && r.knee < 1.0)) refuse_value("response.knee", "is not from 0 to below 1");
    if (!(r.white > 1.0) || !std::isfinite(r.white)) refuse_value("response.white", "is not more than 1");
    return {.exposure = r.exposure,
            .vignette = r.vignette,
            .white_balance = {r.white_balance[0], r.white_balance[1], r.white_balance[2]},
            .sharpening = r.sharpening,
            .saturation = r.saturation,
            .lens_falloff = r.lens_falloff,
            .curve = static_cast<ResponseCurve>(r.curve),
            .toe = r.toe,
            .knee = r.knee,
            .white = r.white};
}

/// Calls between begin and the end.
template <typename Body>
lapfx_status during(const char* function, lapfx_frame* frame, const Body& body) noexcept {
    return call(function, [&] {
        const Held<FrameObject> held(frame, "frame");
        held->shared->require_thread();
        if (held->stage == Stage::none) throw Misuse("no frame was begun: call lapfx_frame_begin first");
        held->shared->require_drawing();
        body(*held);
    });
}

void require_smoke(const FrameObject& object) {
    if (object.stage != Stage::smoke) throw Misuse("the smoke was not begun: call lapfx_frame_begin_smoke first");
}

/// The picture is out, and others may draw; it can be written again until the next frame begins.
void close(const FrameObject& object) {
    if (is_open_frame(object.shared.get())) set_open_frame(nullptr);
}

}  // namespace

FrameObject::~FrameObject() {
    close(*this);
}

}  // namespace lapfx::c

using namespace lapfx::c;

lapfx_status lapfx_post_shader(const char** text) {
    return call(__func__, [&] {
        given(text, "text");
        static const std::string& kept = *new std::string(lapfx::post_shader());
        *text = kept.c_str();
    });
}

lapfx_status lapfx_post_values(const lapfx_response* response, int width, int height, float values[16]) {
    return call(__func__, [&] {
        positive_size(width, height);
        const std::array<glm::vec4, 4> rows = lapfx::post_values(response_of(response), {width, height});
        std::memcpy(given(values, "values"), &rows, sizeof rows);
    });
}

lapfx_status lapfx_frame_create(lapfx_context* context, lapfx_frame** frame) {
    return make<FrameObject>(__func__, frame, "frame", [&] {
        const Held<ContextObject> in(context, "context");
        in->shared->require_current();
        return std::make_unique<FrameObject>(in->shared);
    });
}

lapfx_status lapfx_frame_begin(lapfx_frame* frame, int width, int height) {
    return call(__func__, [&] {
        const Held<FrameObject> held(frame, "frame");
        positive_size(width, height);
        held->shared->require_drawing();
        try {
            held->frame.begin({width, height});
        } catch (const lapfx::Error& error) {
            if (error.failure() == lapfx::Failure::bad_input) throw;  // the frame is as it was
            held->stage = Stage::none;
            close(*held);
            throw;
        }
        held->size = {width, height};
        held->stage = Stage::scene;
        set_open_frame(held->shared.get());
    });
}

lapfx_status lapfx_frame_begin_smoke(lapfx_frame* frame) {
    return during(__func__, frame, [](FrameObject& object) {
        if (object.stage == Stage::smoke) throw Misuse("the smoke was begun already");
        object.frame.begin_smoke();
        object.stage = Stage::smoke;
    });
}

lapfx_status lapfx_frame_get_depth(lapfx_frame* frame, unsigned* depth) {
    return during(__func__, frame, [&](FrameObject& object) { *given(depth, "depth") = object.frame.depth(); });
}

lapfx_status lapfx_frame_finish(lapfx_frame* frame, unsigned framebuffer, const lapfx_response* response) {
    return during(__func__, frame, [&](FrameObject& object) {
        require_smoke(object);
        const lapfx::CameraResponse shown = response_of(response);
        if ((framebuffer != 0 && glIsFramebuffer(framebuffer) == GL_FALSE) ||
            glCheckNamedFramebufferStatus(framebuffer, GL_DRAW_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
            refuse_value("framebuffer", std::to_string(framebuffer) + " is no complete framebuffer of the context");
        object.frame.finish(framebuffer, shown);
        close(object);
    });
}

lapfx_status lapfx_frame_read(lapfx_frame* frame, const lapfx_response* response, uint8_t* rgba, size_t bytes) {
    return during(__func__, frame, [&](FrameObject& object) {
        require_smoke(object);
        given(rgba, "rgba");
        const std::size_t needed = std::size_t{4} * static_cast<std::size_t>(object.size.x) * object.size.y;
        if (bytes != needed)
            refuse_value("bytes", std::to_string(bytes) + "; a picture of " + std::to_string(object.size.x) + "x" +
                                      std::to_string(object.size.y) + " pixels has " + std::to_string(needed));
        object.frame.read(std::span(rgba, bytes), response_of(response));
        close(object);
    });
}

lapfx_status lapfx_frame_destroy(lapfx_frame* frame) {
    return destroy<FrameObject>(__func__, frame, "frame",
                                [](const FrameObject& object) { object.shared->require_current(); });
}
