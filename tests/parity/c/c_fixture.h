// A flat organ, a preset, effects and a frame by the C API, in a context of their own.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <string>
#include <vector>

#include "lapfx.h"
#include "support/gpu_test.h"
#include "support/meshes.h"

namespace lapfx::test {

/// Expects a status, and a text in the message that goes with it.
inline void expect_fails(lapfx_status found, lapfx_status wanted, const std::string& text) {
    EXPECT_EQ(found, wanted) << lapfx_last_message();
    EXPECT_THAT(lapfx_last_message(), testing::HasSubstr(text));
}
inline void expect_ok(lapfx_status found) {
    EXPECT_EQ(found, LAPFX_OK) << lapfx_last_message();
}

inline constexpr const char* plain_preset = R"({"format": "lapfx.preset", "version": 1, "name": "plain"})";
/// Of plane(): a camera 100 mm above it.
inline lapfx_view from_above() {
    lapfx_view view = LAPFX_VIEW;
    const float down[16] = {1, 0, 0, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 0, -100, 1};
    const float wide[16] = {2, 0, 0, 0, 0, 2, 0, 0, 0, 0, -1.01f, -1, 0, 0, -10, 0};
    std::memcpy(view.view, down, sizeof down);
    std::memcpy(view.projection, wide, sizeof wide);
    return view;
}

class CTest : public testing::Test {
  protected:
    static constexpr int width = 48, height = 32;

    void SetUp() override {
        const lapfx_status status = lapfx_context_create(LAPFX_BACKEND_AUTOMATIC, &context);
        if (status == LAPFX_NO_GL) GTEST_SKIP() << lapfx_last_message();
        expect_ok(status);
        expect_ok(make_plane(&organ));
        expect_ok(lapfx_preset_parse(plain_preset, nullptr, &preset));
        expect_ok(lapfx_effects_create(context, organ, preset, nullptr, &effects));
        expect_ok(lapfx_frame_create(context, &frame));
    }
    void TearDown() override {
        expect_ok(lapfx_frame_destroy(frame));
        expect_ok(lapfx_effects_destroy(effects));
        expect_ok(lapfx_preset_destroy(preset));
        expect_ok(lapfx_organ_destroy(organ));
        expect_ok(lapfx_context_destroy(context));
    }

    static lapfx_status make_plane(lapfx_organ** made, double side = 60.0, int squares = 40) {
        const Organ flat = plane(side, squares);
        lapfx_mesh mesh = LAPFX_MESH;
        mesh.vertex_count = flat.positions.size();
        mesh.positions = &flat.positions.data()->x;
        mesh.index_count = flat.indices.size();
        mesh.indices = flat.indices.data();
        return lapfx_organ_create(&mesh, made);
    }
    /// A cut along x, as the hand makes it.
    void cut() {
        lapfx_contact contact = LAPFX_CONTACT;
        contact.action = LAPFX_CUT;
        contact.to[0] = 10;
        expect_ok(lapfx_effects_set_contacts(effects, &contact, 1));
    }
    /// All calls of a frame; `drawn` may leave something out.
    std::vector<std::uint8_t> picture(lapfx_effects* of, lapfx_frame* in, const lapfx_view& view) {
        std::vector<std::uint8_t> rgba(std::size_t{4} * width * height);
        unsigned depth = 0;
        expect_ok(lapfx_frame_begin(in, width, height));
        expect_ok(lapfx_effects_draw_organ(of, &view));
        expect_ok(lapfx_frame_begin_smoke(in));
        expect_ok(lapfx_frame_get_depth(in, &depth));
        expect_ok(lapfx_effects_draw_smoke(of, &view, depth));
        expect_ok(lapfx_frame_read(in, nullptr, rgba.data(), rgba.size()));
        return rgba;
    }
    std::vector<std::uint8_t> picture() { return picture(effects, frame, from_above()); }

    lapfx_context* context = nullptr;
    lapfx_organ* organ = nullptr;
    lapfx_preset* preset = nullptr;
    lapfx_effects* effects = nullptr;
    lapfx_frame* frame = nullptr;
};

}  // namespace lapfx::test
