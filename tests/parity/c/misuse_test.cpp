// What a program may do wrong with the C API: it is told, nothing is drawn, nothing crashes.
#include <cmath>
#include <fstream>
#include <limits>
#include <stdexcept>
#include <thread>

#include "parity/c/c_fixture.h"

namespace lapfx::test {
namespace {

class MisuseTest : public CTest {};

constexpr float nan = std::numeric_limits<float>::quiet_NaN(), infinite = std::numeric_limits<float>::infinity();

TEST_F(MisuseTest, HandlesAreKnownForWhatTheyAre) {
    expect_fails(lapfx_effects_seek(nullptr, 0.0), LAPFX_MISUSE,
                 "lapfx_effects_seek: effects is NULL; expected a lapfx_effects");
    expect_fails(lapfx_effects_seek(reinterpret_cast<lapfx_effects*>(frame), 0.0), LAPFX_MISUSE,
                 "effects is a lapfx_frame; expected a lapfx_effects");
    int address = 0;
    expect_fails(lapfx_effects_seek(reinterpret_cast<lapfx_effects*>(&address), 0.0), LAPFX_MISUSE,
                 "effects is no lapfx_effects that lives");
    for (const std::uintptr_t any : {std::uintptr_t{1}, std::uintptr_t{0xdeadbeef}, ~std::uintptr_t{0}})
        expect_fails(lapfx_effects_destroy(reinterpret_cast<lapfx_effects*>(any)), LAPFX_MISUSE, "that lives");
    expect_fails(lapfx_effects_create(context, organ, nullptr, nullptr, &effects), LAPFX_MISUSE,
                 "preset is NULL; expected a lapfx_preset");
    EXPECT_EQ(effects, nullptr) << "what could not be made is NULL; TearDown destroys that";
}

TEST_F(MisuseTest, WhatWasDestroyedIsNeverFoundAgain) {
    lapfx_preset* gone = nullptr;
    expect_ok(lapfx_preset_parse(plain_preset, nullptr, &gone));
    lapfx_preset* const before = gone;
    expect_ok(lapfx_preset_destroy(gone));
    expect_fails(lapfx_preset_destroy(before), LAPFX_MISUSE, "it was destroyed, or lapfx never made it");
    for (int i = 0; i < 100; ++i) {  // the next one lies in the same place
        lapfx_preset* next = nullptr;
        expect_ok(lapfx_preset_parse(plain_preset, nullptr, &next));
        ASSERT_NE(next, before);
        expect_fails(lapfx_preset_set(before, "bleeding.speed", "1"), LAPFX_MISUSE, "preset is no lapfx_preset");
        expect_ok(lapfx_preset_destroy(next));
    }
    expect_ok(lapfx_preset_destroy(nullptr));
}

TEST_F(MisuseTest, StructsOfAnotherSizeAreRefused) {
    lapfx_view view = from_above();
    view.size = sizeof view - 8;
    expect_fails(lapfx_effects_draw_organ(effects, &view), LAPFX_MISUSE,
                 "view: size is " + std::to_string(sizeof view - 8) + "; expected sizeof(lapfx_view), " +
                     std::to_string(sizeof view));
    lapfx_amounts amounts{};
    expect_fails(lapfx_effects_get_amounts(effects, &amounts), LAPFX_MISUSE,
                 "amounts: size is 0; expected sizeof(lapfx_am");
    lapfx_contact contacts[2] = {LAPFX_CONTACT, LAPFX_CONTACT};
    contacts[1].size = 7;
    expect_fails(lapfx_effects_set_contacts(effects, contacts, 2), LAPFX_MISUSE, "contacts[1]: size is 7; expected");
    lapfx_sample sample = LAPFX_SAMPLE;
    sample.size = 1000;
    expect_fails(lapfx_effects_push_sample(effects, &sample), LAPFX_MISUSE, "sample: size is 1000; expected");
    lapfx_effects_options options = LAPFX_EFFECTS_OPTIONS;
    options.size = 0;
    lapfx_effects* made = nullptr;
    expect_fails(lapfx_effects_create(context, organ, preset, &options, &made), LAPFX_MISUSE, "options: size is 0");
}

TEST_F(MisuseTest, NullIsNoArgument) {
    expect_fails(lapfx_organ_load(nullptr, nullptr, &organ), LAPFX_MISUSE, "lapfx_organ_load: path is NULL");
    EXPECT_EQ(organ, nullptr);
    expect_fails(lapfx_preset_set(preset, "bleeding.speed", nullptr), LAPFX_MISUSE, "value is NULL");
    expect_fails(lapfx_preset_load("a.json", nullptr), LAPFX_MISUSE, "preset is NULL");
    expect_fails(lapfx_effects_draw_organ(effects, nullptr), LAPFX_MISUSE, "view is NULL");
    expect_fails(lapfx_effects_set_contacts(effects, nullptr, 1), LAPFX_MISUSE, "contacts is NULL");
    expect_fails(lapfx_effects_set_organ(effects, nullptr, nullptr, 0), LAPFX_MISUSE, "organ");
    expect_fails(lapfx_effects_get_organ_coming(effects, nullptr), LAPFX_MISUSE, "coming is NULL");
    expect_fails(lapfx_effects_set_shape(effects, 1681, nullptr, nullptr), LAPFX_MISUSE, "positions is NULL");
    expect_fails(lapfx_effects_set_gravity(effects, nullptr), LAPFX_MISUSE, "gravity is NULL");
    expect_fails(lapfx_context_external(nullptr, &context), LAPFX_MISUSE, "get_proc_address is NULL");
    EXPECT_EQ(context, nullptr);
    lapfx_effects_options options = LAPFX_EFFECTS_OPTIONS;
    options.clip_folder_count = 1;
    lapfx_effects* made = nullptr;
    lapfx_context* own = nullptr;
    ASSERT_EQ(lapfx_context_create(LAPFX_BACKEND_AUTOMATIC, &own), LAPFX_OK);
    expect_ok(make_plane(&organ));
    expect_fails(lapfx_effects_create(own, organ, preset, &options, &made), LAPFX_MISUSE,
                 "options.clip_folders is NULL");
    expect_ok(lapfx_context_destroy(own));
}

TEST_F(MisuseTest, MatricesThatAreNoneDrawNothing) {
    const auto frame_of = [&](float element) {
        std::vector<std::uint8_t> rgba(std::size_t{4} * width * height);
        lapfx_view view = from_above();
        view.view[5] = element;
        unsigned depth = 0;
        expect_ok(lapfx_frame_begin(frame, width, height));
        expect_fails(lapfx_effects_draw_organ(effects, &view), LAPFX_BAD_INPUT, "view.view: element 5 is ");
        expect_fails(lapfx_effects_draw_metal_clips(effects, &view), LAPFX_BAD_INPUT, "view.view: element 5 is ");
        expect_ok(lapfx_frame_begin_smoke(frame));
        expect_ok(lapfx_frame_get_depth(frame, &depth));
        expect_fails(lapfx_effects_draw_smoke(effects, &view, depth), LAPFX_BAD_INPUT, "; expected finite numbers");
        expect_ok(lapfx_frame_read(frame, nullptr, rgba.data(), rgba.size()));
        return rgba;
    };
    std::vector<std::uint8_t> nothing(std::size_t{4} * width * height);
    expect_ok(lapfx_frame_begin(frame, width, height));
    expect_ok(lapfx_frame_begin_smoke(frame));
    expect_ok(lapfx_frame_read(frame, nullptr, nothing.data(), nothing.size()));
    for (const float bad : {nan, infinite, -infinite}) EXPECT_EQ(frame_of(bad), nothing);
    EXPECT_NE(picture(), nothing) << "with a good matrix something is drawn";
    lapfx_view view = from_above();
    for (float& element : view.projection) element = 0;
    expect_fails(lapfx_effects_draw_organ(effects, &view), LAPFX_BAD_INPUT, "view.projection: has the determinant 0");
    const auto spoilt = [](void (*spoil)(lapfx_view&)) {
        lapfx_view spoilt_view = from_above();
        spoil(spoilt_view);
        return spoilt_view;
    };
    const lapfx_view none_rigid[] = {spoilt([](lapfx_view& v) {
                                         for (int i = 0; i < 4; ++i)
                                             for (int k = 0; k < i; ++k)
                                                 std::swap(v.view[4 * i + k], v.view[4 * k + i]);
                                     }),
                                     spoilt([](lapfx_view& v) {
                                         for (int i = 0; i < 12; ++i) v.view[i] *= 1.01f;
                                     }),
                                     spoilt([](lapfx_view& v) {
                                         for (int i = 0; i < 3; ++i) v.view[i] = -v.view[i];
                                     })};
    for (const lapfx_view& other : none_rigid)
        expect_fails(lapfx_effects_draw_organ(effects, &other), LAPFX_BAD_INPUT,
                     "view.view: is not rigid; expected a rotation and a translation, without scale, column by column");
    view = from_above();
    view.lamp_focus_distance = 0;
    expect_fails(lapfx_effects_draw_organ(effects, &view), LAPFX_BAD_INPUT,
                 "view.lamp_focus_distance: 0.000000; expected more than 0");
    view = from_above();
    view.lamp_intensity = -1;
    expect_fails(lapfx_effects_draw_organ(effects, &view), LAPFX_BAD_INPUT,
                 "view.lamp_intensity: -1.000000; expected 0 or more");
    view = from_above();
    view.lamp_color[1] = nan;
    expect_fails(lapfx_effects_draw_organ(effects, &view), LAPFX_BAD_INPUT, "view.lamp_color: element 1 is nan");
}

TEST_F(MisuseTest, FramesHaveAnOrderAndASize) {
    std::vector<std::uint8_t> rgba(std::size_t{4} * width * height);
    unsigned depth = 0;
    const std::string none = "no frame was begun: call lapfx_frame_begin first";
    expect_fails(lapfx_frame_begin_smoke(frame), LAPFX_MISUSE, none);
    expect_fails(lapfx_frame_get_depth(frame, &depth), LAPFX_MISUSE, none);
    expect_fails(lapfx_frame_finish(frame, 0, nullptr), LAPFX_MISUSE, none);
    expect_fails(lapfx_frame_read(frame, nullptr, rgba.data(), rgba.size()), LAPFX_MISUSE, none);
    expect_fails(lapfx_frame_begin(frame, 0, 10), LAPFX_BAD_INPUT, "size: 0x10; expected at least 1x1 pixels");
    expect_fails(lapfx_frame_begin(frame, 10, -3), LAPFX_BAD_INPUT, "size: 10x-3; expected at least 1x1 pixels");
    expect_fails(lapfx_frame_begin(frame, 1 << 30, 1), LAPFX_BAD_INPUT, "is outside 1x1 to ");
    expect_ok(lapfx_frame_begin(frame, width, height));
    expect_fails(lapfx_frame_read(frame, nullptr, rgba.data(), rgba.size()), LAPFX_MISUSE, "the smoke was not begun");
    expect_ok(lapfx_frame_begin_smoke(frame));
    expect_fails(lapfx_frame_begin_smoke(frame), LAPFX_MISUSE, "the smoke was begun already");
    expect_fails(lapfx_frame_begin(frame, 1 << 30, 1), LAPFX_BAD_INPUT, "is outside 1x1 to ");
    expect_fails(lapfx_frame_begin_smoke(frame), LAPFX_MISUSE, "the smoke was begun already");  // nothing has changed
    expect_fails(lapfx_frame_read(frame, nullptr, rgba.data(), rgba.size() - 1), LAPFX_BAD_INPUT,
                 "bytes: 6143; a picture of 48x32 pixels has 6144");
    expect_fails(lapfx_frame_read(frame, nullptr, nullptr, rgba.size()), LAPFX_MISUSE, "rgba is NULL");
    lapfx_response response = LAPFX_RESPONSE;
    response.exposure = nan;
    expect_fails(lapfx_frame_read(frame, &response, rgba.data(), rgba.size()), LAPFX_BAD_INPUT,
                 "response.exposure: nan is no finite number");
    float values[16];
    response = LAPFX_RESPONSE;
    response.curve = 2;
    expect_fails(lapfx_post_values(&response, width, height, values), LAPFX_BAD_INPUT,
                 "response.curve: is neither 0, shoulder, nor 1, film");
    response.curve = 1, response.white = 1.0;
    expect_fails(lapfx_post_values(&response, width, height, values), LAPFX_BAD_INPUT,
                 "response.white: is not more than 1");
    expect_fails(lapfx_post_values(nullptr, 0, height, values), LAPFX_BAD_INPUT, "size: 0x");
    expect_fails(lapfx_post_values(nullptr, width, height, nullptr), LAPFX_MISUSE, "values is NULL");
    expect_fails(lapfx_frame_finish(frame, 12345, nullptr), LAPFX_BAD_INPUT,
                 "framebuffer: 12345 is no complete framebuffer");
    lapfx_get_proc_address functions = nullptr;
    expect_ok(lapfx_context_functions(context, &functions));
    const auto error = reinterpret_cast<unsigned (*)()>(functions("glGetError"));
    EXPECT_EQ(error(), 0U) << "OpenGL has not been asked to do it";
    const lapfx_view view = from_above();
    expect_fails(lapfx_effects_draw_smoke(effects, &view, 0), LAPFX_BAD_INPUT, "depth: 0 is no texture of the context");
    expect_fails(lapfx_effects_draw_smoke(effects, &view, 9999), LAPFX_BAD_INPUT, "depth: 9999 is no texture");
    expect_ok(lapfx_frame_read(frame, nullptr, rgba.data(), rgba.size()));
    expect_ok(lapfx_frame_read(frame, nullptr, rgba.data(), rgba.size()));
}

TEST_F(MisuseTest, ValuesAreToldWithWhatIsAllowed) {
    lapfx_context* none = nullptr;
    expect_fails(lapfx_context_create(7, &none), LAPFX_BAD_INPUT, "backend: 7 is not one of 0 to 2");
    lapfx_contact contact = LAPFX_CONTACT;
    contact.action = -1;
    expect_fails(lapfx_effects_set_contacts(effects, &contact, 1), LAPFX_BAD_INPUT,
                 "contacts[0].action: -1 is not one of 0 to 6 (cauterise to clip)");
    lapfx_sample sample = LAPFX_SAMPLE;
    sample.action = 7;
    expect_fails(lapfx_effects_push_sample(effects, &sample), LAPFX_BAD_INPUT, "sample.action: 7 is not one of 0 to 6");
    expect_fails(lapfx_effects_seek(effects, nan), LAPFX_BAD_INPUT, "time: nan is no finite number");
    const double zero[3] = {}, broken[3] = {0, infinite, 0};
    expect_fails(lapfx_effects_set_gravity(effects, zero), LAPFX_BAD_INPUT, "gravity: a vector of length 0");
    expect_fails(lapfx_effects_set_gravity(effects, broken), LAPFX_BAD_INPUT, "gravity: element 1 is inf");
    const double glaring[3] = {1, 0, 2};
    expect_fails(lapfx_effects_set_organ_color(effects, glaring), LAPFX_BAD_INPUT,
                 "color: element 2 is 2.000000; expected 0 to 1");
    lapfx_hit hit{};
    hit.size = sizeof hit;
    expect_fails(lapfx_effects_pick(effects, zero, zero, &hit), LAPFX_BAD_INPUT, "direction: a vector of length 0");
    lapfx_wound wound{};
    wound.size = sizeof wound;
    expect_fails(lapfx_effects_get_wound(effects, 0, &wound), LAPFX_BAD_INPUT,
                 "index: 0 is not below 0, the number of wounds");
    std::vector<float> positions(std::size_t{3} * 41 * 41);
    positions[10] = nan;
    expect_fails(lapfx_effects_set_organ(effects, organ, nullptr, 0), LAPFX_MISUSE, "call lapfx_organ_prepare before");
    expect_fails(lapfx_effects_set_shape(effects, 5, positions.data(), nullptr), LAPFX_BAD_INPUT,
                 "vertex_count: 5; the organ has 1681 vertices");
    expect_fails(lapfx_effects_set_shape(effects, 1681, positions.data(), nullptr), LAPFX_BAD_INPUT,
                 "positions: element 10 is nan");
    positions[10] = -1e30f;
    expect_fails(lapfx_effects_set_shape(effects, 1681, positions.data(), nullptr), LAPFX_BAD_INPUT,
                 "expected numbers from -1e9 to 1e9");
    expect_fails(lapfx_effects_set_contacts(effects, &contact, static_cast<std::size_t>(-1)), LAPFX_BAD_INPUT,
                 "count: 18446744073709551615 is above 16777216");
    lapfx_effects_options options = LAPFX_EFFECTS_OPTIONS;
    const char* folder = "clips";
    options.clip_folders = &folder;
    options.clip_folder_count = static_cast<std::size_t>(-1);
    lapfx_effects* made = nullptr;
    expect_fails(lapfx_effects_create(context, organ, preset, &options, &made), LAPFX_BAD_INPUT,
                 "options.clip_folder_count: 18446744073709551615 is above 1024");
    expect_fails(lapfx_preset_set(preset, "bleeding.speed", "-3"), LAPFX_BAD_INPUT, "-3 is below the minimum 0 mm/s");
    expect_fails(lapfx_organ_load("none.glb", nullptr, &organ), LAPFX_BAD_INPUT, "lapfx_organ_load: none.glb: ");
    lapfx_scene* scene = nullptr;
    expect_fails(lapfx_scene_load("none.json", &scene), LAPFX_BAD_INPUT, "lapfx_scene_load: none.json: ");
}

TEST_F(MisuseTest, MeshesThatAreNoneAreNotMade) {
    const float corners[] = {0, 0, 0, 9, 0, 0, 0, 9, 0}, broken[] = {0, 0, 1, nan, 0, 0};
    const std::uint32_t triangle[] = {0, 1, 2}, beyond[] = {0, 1, 3};
    lapfx_mesh mesh = LAPFX_MESH;
    lapfx_organ* made = nullptr;
    expect_fails(lapfx_organ_create(&mesh, &made), LAPFX_MISUSE, "mesh.positions is NULL");
    mesh.positions = corners;
    mesh.vertex_count = 3;
    expect_fails(lapfx_organ_create(&mesh, &made), LAPFX_MISUSE, "mesh.indices is NULL");
    mesh.indices = triangle;
    expect_fails(lapfx_organ_create(&mesh, &made), LAPFX_BAD_INPUT, "organ: indices: 0; three for each of 1 to ");
    mesh.index_count = 2;
    expect_fails(lapfx_organ_create(&mesh, &made), LAPFX_BAD_INPUT, "organ: indices: 2; three for each of 1 to ");
    mesh.index_count = 3;
    mesh.indices = beyond;
    expect_fails(lapfx_organ_create(&mesh, &made), LAPFX_BAD_INPUT, "organ: indices/2: 3; there are 3 positions");
    mesh.indices = triangle;
    mesh.uvs = broken;
    expect_fails(lapfx_organ_create(&mesh, &made), LAPFX_BAD_INPUT, "organ: uvs/1: nan is not a number");
    EXPECT_EQ(made, nullptr);
    mesh.uvs = nullptr;
    mesh.vertex_count = static_cast<std::size_t>(-1);
    expect_fails(lapfx_organ_create(&mesh, &made), LAPFX_BAD_INPUT,
                 "organ: positions: 18446744073709551615; expected 1 to 60000000");
    mesh.vertex_count = 3;
    expect_ok(lapfx_organ_create(&mesh, &made));
    expect_ok(lapfx_organ_destroy(made));
}

TEST_F(MisuseTest, OtherThreadsMayPushAndNoMore) {
    const lapfx_view view = from_above();
    std::thread([&] {
        const std::string other = "called on another thread than that on which the context was made";
        EXPECT_STREQ(lapfx_last_message(), "") << "it is a message of each thread";
        lapfx_sample sample = LAPFX_SAMPLE;
        expect_ok(lapfx_effects_push_sample(effects, &sample));
        expect_fails(lapfx_effects_seek(effects, 1.0), LAPFX_MISUSE, "lapfx_effects_seek: " + other);
        expect_fails(lapfx_effects_draw_organ(effects, &view), LAPFX_MISUSE, other);
        expect_fails(lapfx_frame_begin(frame, width, height), LAPFX_MISUSE, other);
        expect_fails(lapfx_context_make_current(context), LAPFX_MISUSE, other);
        expect_fails(lapfx_context_destroy(context), LAPFX_MISUSE, other);
        expect_fails(lapfx_frame_destroy(frame), LAPFX_MISUSE, other);
        lapfx_effects* made = nullptr;
        expect_fails(lapfx_effects_create(context, organ, preset, nullptr, &made), LAPFX_MISUSE, other);
    }).join();
    expect_ok(lapfx_effects_seek(effects, 1.0));  // it is still there
}

TEST_F(MisuseTest, AFullQueueIsTold) {
    lapfx_sample sample = LAPFX_SAMPLE;
    for (int i = 0; i < 8192; ++i) {
        sample.time = 0.001 * i;
        ASSERT_EQ(lapfx_effects_push_sample(effects, &sample), LAPFX_OK);
    }
    expect_fails(lapfx_effects_push_sample(effects, &sample), LAPFX_RUNTIME, "the queue is full; the sample is lost");
    lapfx_amounts amounts{};
    amounts.size = sizeof amounts;
    expect_ok(lapfx_effects_get_amounts(effects, &amounts));
    EXPECT_EQ(amounts.lost_samples, 1U);
}

TEST_F(MisuseTest, TheLogIsToldEachFaultAndCallsNothing) {
    struct Told {
        std::vector<std::string> lines;
        lapfx_preset* preset;
        lapfx_status inside = LAPFX_OK;
    } told{{}, preset};
    lapfx_set_log(
        [](void* user, int level, const char* message) {
            Told& to = *static_cast<Told*>(user);
            EXPECT_EQ(level, LAPFX_LOG_ERROR);
            to.lines.emplace_back(message);
            to.inside = lapfx_preset_set(to.preset, "bleeding.speed", "3");
        },
        &told);
    lapfx_preset* made = nullptr;
    const char* two_faults =
        R"({"format": "lapfx.preset", "version": 1, "bleeding": {"speed": -1}, "smoke": {"fog": 1}})";
    expect_fails(lapfx_preset_parse(two_faults, nullptr, &made), LAPFX_BAD_INPUT, "/bleeding/speed: -1");
    lapfx_set_log(nullptr, nullptr);
    expect_fails(lapfx_effects_seek(nullptr, 0.0), LAPFX_MISUSE, "NULL");
    ASSERT_EQ(told.lines.size(), 2U) << "a line for each fault, and none once there is no log";
    EXPECT_THAT(told.lines, testing::Contains(testing::StartsWith("lapfx_preset_parse: json: /bleeding/speed: -1")));
    EXPECT_THAT(told.lines, testing::Contains(testing::HasSubstr("fog")));
    EXPECT_EQ(told.inside, LAPFX_MISUSE);
}

TEST_F(MisuseTest, ALogMayThrowAndAskForTheMessage) {
    struct Told {
        std::string message;
    } told;
    lapfx_set_log(
        [](void* user, int, const char*) {
            static_cast<Told*>(user)->message = lapfx_last_message();
            throw std::runtime_error("of the log");
        },
        &told);
    for (int i = 0; i < 2; ++i)
        expect_fails(lapfx_effects_seek(nullptr, 0.0), LAPFX_MISUSE, "lapfx_effects_seek: effects is NULL");
    EXPECT_EQ(told.message, "lapfx_effects_seek: effects is NULL; expected a lapfx_effects");
    told.message.clear();
    expect_fails(lapfx_effects_push_sample(nullptr, nullptr), LAPFX_MISUSE, "effects is NULL");
    EXPECT_EQ(told.message, "") << "the haptic thread does not wait for the log";
    lapfx_set_log(nullptr, nullptr);
    expect_ok(lapfx_effects_seek(effects, 1.0));
}

TEST_F(MisuseTest, APlateIsNotDrawn) {
    lapfx_scene* scene = nullptr;
    lapfx_organ* made = nullptr;
    const std::string path = testing::TempDir() + "plate.scene.json";
    std::ofstream(path)
        << R"({"format": "lapfx.scene", "version": 1, "organ": {"file": "stomach.glb"}, "plate": {"use": true}})";
    expect_ok(lapfx_scene_load(path.c_str(), &scene));
    expect_fails(lapfx_scene_load_organ(scene, &made), LAPFX_BAD_INPUT,
                 "scene: shows a plate, a frame of its reference");
    expect_ok(lapfx_scene_destroy(scene));
}

}  // namespace
}  // namespace lapfx::test
