// The C API as it is meant: the same as in C++, contexts in any order, and frames that allocate nothing.
#include <filesystem>
#include <fstream>

#include "parity/allocations.h"
#include "parity/c/c_fixture.h"
#include "support/wait_until.h"

namespace lapfx::test {
namespace {

class UseTest : public CTest {};

TEST_F(UseTest, ACutBleedsAndIsCounted) {
    const std::vector<std::uint8_t> clean = picture();
    cut();
    expect_ok(lapfx_effects_seek(effects, 3.0));
    EXPECT_NE(picture(), clean);
    lapfx_amounts amounts{};
    amounts.size = sizeof amounts;
    expect_ok(lapfx_effects_get_amounts(effects, &amounts));
    std::size_t wounds = 0, contacts = 0;
    expect_ok(lapfx_effects_get_wound_count(effects, &wounds));
    expect_ok(lapfx_effects_get_contact_count(effects, &contacts));
    EXPECT_EQ(wounds, 5U) << "10 mm of cut, a wound each 2.5 mm";
    EXPECT_EQ(contacts, 1U);
    EXPECT_EQ(amounts.wounds, 5);
    EXPECT_GT(amounts.blood_area, 10.0);
    lapfx_wound wound{};
    wound.size = sizeof wound;
    expect_ok(lapfx_effects_get_wound(effects, 4, &wound));
    EXPECT_NEAR(wound.position[0], 10.0, 1e-6);
    EXPECT_EQ(wound.bleeds, 1);
    lapfx_contact contact = LAPFX_CONTACT;
    expect_ok(lapfx_effects_get_contact(effects, 0, &contact));
    EXPECT_EQ(contact.action, LAPFX_CUT);
    EXPECT_EQ(contact.to[0], 10.0);
    expect_ok(lapfx_effects_seek(effects, 0.0));
    expect_ok(lapfx_effects_set_contacts(effects, nullptr, 0));
    expect_ok(lapfx_effects_seek(effects, 0.0));
    EXPECT_EQ(picture(), clean);
}

TEST_F(UseTest, ValuesOfAPresetAreLive) {
    cut();
    expect_ok(lapfx_effects_seek(effects, 3.0));
    const std::vector<std::uint8_t> red = picture();
    expect_ok(lapfx_preset_set(preset, "bleeding.color_thin", "#10f020"));
    const char* json = nullptr;
    expect_ok(lapfx_preset_write(preset, &json));
    EXPECT_THAT(json, testing::HasSubstr("\"plain\""));
    expect_ok(lapfx_effects_set_preset(effects, preset));
    expect_ok(lapfx_effects_seek(effects, 3.0));
    EXPECT_NE(picture(), red);
}

TEST_F(UseTest, APreparedOrganGivesTheSamePicture) {
    lapfx_organ* prepared = nullptr;
    lapfx_effects* other = nullptr;
    expect_ok(make_plane(&prepared));
    expect_ok(lapfx_organ_prepare(prepared, preset));
    expect_ok(lapfx_effects_create(context, prepared, preset, nullptr, &other));
    lapfx_contact contact = LAPFX_CONTACT;
    contact.action = LAPFX_CUT;
    contact.to[0] = 10;
    for (lapfx_effects* one : {effects, other}) {
        expect_ok(lapfx_effects_set_contacts(one, &contact, 1));
        expect_ok(lapfx_effects_seek(one, 3.0));
    }
    EXPECT_EQ(picture(other, frame, from_above()), picture());
    expect_ok(lapfx_organ_destroy(prepared));
    EXPECT_EQ(picture(other, frame, from_above()), picture()) << "effects need no organ any more";
    expect_ok(lapfx_effects_destroy(other));
}

TEST_F(UseTest, AnotherOrganTakesThePlaceOfTheFirst) {
    constexpr std::size_t vertices = 21 * 21;
    lapfx_organ* other = nullptr;
    lapfx_effects* direct = nullptr;
    expect_ok(make_plane(&other, 30.0, 20));
    expect_ok(lapfx_organ_prepare(other, preset));
    expect_ok(lapfx_effects_create(context, other, preset, nullptr, &direct));
    lapfx_contact contact = LAPFX_CONTACT;
    contact.action = LAPFX_CUT;
    contact.to[0] = 10;
    expect_ok(lapfx_effects_set_contacts(direct, &contact, 1));
    expect_ok(lapfx_effects_seek(direct, 3.0));

    int coming = 2;
    expect_ok(lapfx_effects_get_organ_coming(effects, &coming));
    EXPECT_EQ(coming, 0);
    expect_ok(lapfx_effects_seek(effects, 3.0));
    const std::vector<std::uint8_t> before = picture();
    std::vector<float> shape(3 * vertices, 0.0f);
    expect_ok(lapfx_effects_set_organ(effects, other, &contact, 1));
    expect_ok(lapfx_effects_get_organ_coming(effects, &coming));
    EXPECT_EQ(coming, 1);
    EXPECT_EQ(picture(), before);
    expect_fails(lapfx_effects_set_shape(effects, vertices, shape.data(), nullptr), LAPFX_BAD_INPUT,
                 "the organ has 1681 vertices");
    expect_fails(lapfx_effects_set_organ(effects, organ, nullptr, 0), LAPFX_MISUSE, "call lapfx_organ_prepare before");
    expect_ok(lapfx_effects_get_organ_coming(effects, &coming));
    EXPECT_EQ(coming, 1) << "what is refused changes nothing";
    EXPECT_TRUE(test::wait_until([&] { return coming == 0; },
                                 [&] {
                                     expect_ok(lapfx_effects_seek(effects, 3.0));
                                     expect_ok(lapfx_effects_get_organ_coming(effects, &coming));
                                 }));
    EXPECT_NE(picture(), before);
    EXPECT_EQ(picture(), picture(direct, frame, from_above()));
    expect_ok(lapfx_effects_set_shape(effects, vertices, shape.data(), nullptr));
    expect_ok(lapfx_organ_destroy(other));
    expect_ok(lapfx_effects_destroy(direct));
}

TEST_F(UseTest, ACoarseOrganIsRefined) {
    const float corners[] = {0, 0, 0, 9, 0, 0, 0, 9, 0};
    const std::uint32_t triangle[] = {0, 1, 2};
    lapfx_mesh mesh = LAPFX_MESH;
    mesh.positions = corners;
    mesh.vertex_count = 3;
    mesh.indices = triangle;
    mesh.index_count = 3;
    lapfx_organ *coarse = nullptr, *fine = nullptr;
    expect_ok(lapfx_organ_create(&mesh, &coarse));
    expect_ok(lapfx_organ_refine(coarse, &fine));
    expect_ok(lapfx_organ_destroy(coarse));
    lapfx_organ_data data{};
    data.size = sizeof data;
    expect_ok(lapfx_organ_get_data(fine, &data));
    EXPECT_GT(data.vertex_count, 20U);
    EXPECT_EQ(data.index_count % 3, 0U);
    EXPECT_EQ(std::vector<float>(data.positions, data.positions + 9), std::vector<float>(corners, corners + 9));
    EXPECT_EQ(data.normals[2], 1.0f);
    expect_ok(lapfx_organ_destroy(fine));
}

TEST_F(UseTest, ScenesSayWhatAHostNeeds) {
    const std::filesystem::path folder(testing::TempDir()), file = folder / "c_scene.json";
    std::ofstream(file) << R"({"format": "lapfx.scene", "version": 1, "name": "two", "seed": 7, "preset": "p.json",
        "organ": {"file": "o.obj", "scale": 2}, "camera": {"eye": [0, 0, 50], "exposure": 1.5}, "events": [
        {"action": "cut", "time": 3, "position": [1, 2, 3], "to": [1, 2, 3]},
        {"action": "tear", "time": 1, "position": [4, 5, 6], "to": [4, 5, 7]}]})";
    lapfx_scene* scene = nullptr;
    expect_ok(lapfx_scene_load(file.c_str(), &scene));
    lapfx_scene_info info{};
    info.size = sizeof info;
    expect_ok(lapfx_scene_get_info(scene, &info));
    EXPECT_STREQ(info.name, "two");
    EXPECT_EQ(info.seed, 7U);
    EXPECT_EQ(info.preset, folder / "p.json");
    EXPECT_EQ(info.organ_file, folder / "o.obj");
    EXPECT_STREQ(info.organ_texture, "");
    EXPECT_EQ(info.organ_scale, 2.0);
    ASSERT_EQ(info.event_count, 2U);
    lapfx_contact contact = LAPFX_CONTACT;
    expect_ok(lapfx_scene_get_event(scene, 0, &contact));
    EXPECT_EQ(contact.action, LAPFX_TEAR) << "in the order of time";
    EXPECT_EQ(contact.to[2], 7.0);
    expect_fails(lapfx_scene_get_event(scene, 2, &contact), LAPFX_BAD_INPUT,
                 "index: 2 is not below 2, the number of events");
    lapfx_view view = LAPFX_VIEW;
    expect_ok(lapfx_scene_get_view(scene, 200, 100, &view));
    EXPECT_EQ(view.view[14], -50.0f) << "column by column";
    EXPECT_FLOAT_EQ(view.projection[5], 2 * view.projection[0]);
    EXPECT_EQ(view.lamp_ambient, 0.02);
    EXPECT_EQ(view.lamp_color[2], 0.92);
    expect_fails(lapfx_scene_get_view(scene, 200, 0, &view), LAPFX_BAD_INPUT,
                 "size: 200x0; expected at least 1x1 pixels");
    lapfx_response response = LAPFX_RESPONSE;
    expect_ok(lapfx_scene_get_response(scene, &response));
    EXPECT_EQ(response.exposure, 1.5);
    EXPECT_EQ(response.lens_falloff, 0.45);
    EXPECT_EQ(response.curve, 0);
    const char* text = nullptr;
    expect_ok(lapfx_post_shader(&text));
    EXPECT_NE(std::string(text).find("vec3 lapfx_post(sampler2D frame, vec2 uv)"), std::string::npos);
    float values[16];
    response.curve = 1;
    expect_ok(lapfx_post_values(&response, 200, 100, values));
    EXPECT_FLOAT_EQ(values[0], 1.5f);
    EXPECT_FLOAT_EQ(values[6], 6.0f) << "(3 - .6) / (1 - .6)";
    EXPECT_EQ(values[12], 200.0f);
    lapfx_organ* none = nullptr;
    expect_fails(lapfx_scene_load_organ(scene, &none), LAPFX_BAD_INPUT, (folder / "o.obj").string());
    expect_ok(lapfx_effects_set_curves(effects, scene));
    expect_ok(lapfx_effects_set_curves(effects, nullptr));
    expect_ok(lapfx_scene_destroy(scene));
    std::filesystem::remove(file);
}

TEST_F(UseTest, ContextsEndWithTheirLastObject) {
    const std::vector<std::uint8_t> drawn = picture();
    expect_ok(lapfx_context_destroy(context));
    EXPECT_EQ(picture(), drawn);
    lapfx_frame* made = nullptr;
    expect_fails(lapfx_frame_create(context, &made), LAPFX_MISUSE, "context is no lapfx_context that lives");
    context = nullptr;
}

TEST_F(UseTest, TwoContextsTakeTurns) {
    const std::vector<std::uint8_t> drawn = picture();
    lapfx_context* second = nullptr;
    lapfx_effects* other = nullptr;
    lapfx_frame* in = nullptr;
    expect_ok(lapfx_context_create(LAPFX_BACKEND_AUTOMATIC, &second));
    expect_ok(lapfx_effects_create(second, organ, preset, nullptr, &other));
    expect_ok(lapfx_frame_create(second, &in));
    EXPECT_EQ(picture(), drawn) << "the first one is made current again";
    EXPECT_EQ(picture(other, in, from_above()), drawn);

    const lapfx_view view = from_above();
    const std::string open = "a frame of another context was begun and is not finished";
    expect_ok(lapfx_frame_begin(frame, width, height));
    expect_fails(lapfx_effects_draw_organ(other, &view), LAPFX_MISUSE, open);
    expect_fails(lapfx_frame_begin(in, width, height), LAPFX_MISUSE, open);
    expect_ok(lapfx_frame_destroy(frame));
    frame = nullptr;
    EXPECT_EQ(picture(other, in, from_above()), drawn) << "the frame that was begun is gone";
    expect_ok(lapfx_context_destroy(second));
    expect_ok(lapfx_effects_destroy(other));
    expect_ok(lapfx_frame_destroy(in));
}

TEST_F(UseTest, AHostsContextHasToBeCurrent) {
    lapfx_get_proc_address functions = nullptr;
    expect_ok(lapfx_context_functions(context, &functions));
    lapfx_context* host = nullptr;
    lapfx_effects* other = nullptr;
    expect_ok(lapfx_context_make_current(context));
    expect_ok(lapfx_context_external(functions, &host));
    expect_ok(lapfx_effects_create(host, organ, preset, nullptr, &other));
    expect_fails(lapfx_context_make_current(host), LAPFX_MISUSE,
                 "the context is the host's: the host makes it current");
    const char *text = nullptr, *same = nullptr;
    expect_ok(lapfx_context_renderer(host, &text));
    expect_ok(lapfx_context_renderer(context, &same));
    EXPECT_STREQ(text, same);
    EXPECT_STRNE(text, "");

    // Nothing is current once the last object of the context that stands for the host's window is gone.
    lapfx_context* gone = nullptr;
    expect_ok(lapfx_context_create(LAPFX_BACKEND_AUTOMATIC, &gone));
    expect_ok(lapfx_context_make_current(gone));
    const lapfx_view view = from_above();
    for (const lapfx_status status : {lapfx_effects_draw_organ(other, &view), lapfx_effects_destroy(other)})
        expect_fails(status, LAPFX_MISUSE, "another context is current than when this one was made known");
    expect_ok(lapfx_context_destroy(gone));
    const std::string none = "no OpenGL context is current on this thread";
    expect_fails(lapfx_effects_draw_organ(other, &view), LAPFX_MISUSE, none);
    expect_fails(lapfx_effects_seek(other, 1.0), LAPFX_MISUSE, none);
    expect_fails(lapfx_effects_destroy(other), LAPFX_MISUSE, none);
    expect_ok(lapfx_context_make_current(context));
    expect_ok(lapfx_effects_seek(other, 1.0));
    expect_ok(lapfx_effects_destroy(other));
    expect_ok(lapfx_context_destroy(host));
}

TEST_F(UseTest, FramesAllocateNothing) {
    lapfx_sample sample = LAPFX_SAMPLE;
    lapfx_contact contact = LAPFX_CONTACT;
    lapfx_amounts amounts{};
    amounts.size = sizeof amounts;
    const lapfx_view view = from_above();
    std::vector<std::uint8_t> rgba(std::size_t{4} * width * height);
    unsigned depth = 0;
    const auto draw = [&](double time) {
        sample.time = time;
        lapfx_effects_push_sample(effects, &sample);
        lapfx_effects_set_contacts(effects, &contact, 1);
        lapfx_effects_seek(effects, time);
        lapfx_frame_begin(frame, width, height);
        lapfx_effects_draw_organ(effects, &view);
        lapfx_frame_begin_smoke(frame);
        lapfx_frame_get_depth(frame, &depth);
        lapfx_effects_draw_smoke(effects, &view, depth);
        lapfx_effects_get_amounts(effects, &amounts);
        return lapfx_frame_read(frame, nullptr, rgba.data(), rgba.size());
    };
    expect_ok(lapfx_effects_set_contacts(effects, &contact, 1));
    for (int i = 0; i < 3; ++i) expect_ok(draw(5.0 + i));
    allocations = 0;
    const lapfx_status status = draw(9.0);
    EXPECT_EQ(allocations, 0U);
    expect_ok(status);
}

}  // namespace
}  // namespace lapfx::test
