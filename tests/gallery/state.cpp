#include "gallery/state.h"

#include <cmath>

#include "gallery/gallery.h"

namespace lapfx::gallery {

namespace {

std::uint8_t byte_of(float v) {
    return static_cast<std::uint8_t>(std::clamp(v, 0.0F, 255.0F));
}

/// Smoke, grey and soft, over red tissue, in front of a green screen at the right. `smoke`: how much.
TestPicture make_picture(ui::ImageStore& images, glm::ivec2 size, float smoke) {
    TestPicture picture;
    picture.size = size;
    for (int y = 0; y < size.y; ++y) {
        for (int x = 0; x < size.x; ++x) {
            const glm::vec2 at = glm::vec2(x, y) / glm::vec2(size);
            const float waves =
                0.5F + 0.25F * std::sin(at.x * 31 + 3 * std::sin(at.y * 9)) + 0.25F * std::sin(at.y * 23);
            const bool screen = at.x > 0.72F;
            glm::vec3 color = screen ? glm::vec3(40, 170, 70) - 18 * at.y : glm::vec3(150, 62, 54) + 46 * waves;
            const float away = glm::distance(at, glm::vec2(0.55F, 0.45F));
            const float density = smoke * std::exp(-9 * away * away) * (0.55F + 0.45F * waves);
            color = glm::mix(color, glm::vec3(205, 208, 212), density);
            for (int c = 0; c < 3; ++c) picture.pixels.push_back(byte_of(color[c]));
            picture.pixels.push_back(255);
        }
    }
    picture.image = images.add(size, picture.pixels);
    return picture;
}

}  // namespace

FieldsState::FieldsState() {
    for (int i = 0; i < 10000; ++i) frame_names.push_back("frame " + std::to_string(i));
    frames.assign(frame_names.begin(), frame_names.end());
}

ListsState::ListsState(ui::ImageStore& images) {
    constexpr std::array names = {"plume_left", "plume_right", "haze", "specks",
                                  "fog_slow",   "burst",       "wisp", "curtain"};
    constexpr std::array codecs = {"ProRes 4444", "H.264", "PNG"};
    for (int i = 0; i < 200; ++i) {
        const int tenths = 17 + (i * 37) % 140;
        clips.push_back(
            {.name = std::string(names[static_cast<std::size_t>(i) % names.size()]) + "_" + std::to_string(i),
             .length = std::to_string(tenths / 10) + "." + std::to_string(tenths % 10) + " s",
             .codec = codecs[static_cast<std::size_t>(i) % codecs.size()],
             .seconds = tenths / 10.0,
             .keyed = i % 3 != 1,
             .star = i % 5 == 2});
        order.push_back(static_cast<std::size_t>(i));
        if (i < 24 && i % 7 != 6)  // some are not here yet
            clips.back().image = make_picture(images, {96, 54}, static_cast<float>(i % 8) / 7).image;
    }
    table.selection.only(2);
    presets.only(1);
}

PanelsState::PanelsState()
    : layout(ui::dock_split(
          ui::Axis::x, 0.6F, ui::dock_tabs({"View", "Compare"}),
          ui::dock_split(ui::Axis::y, 0.5F, ui::dock_tabs({"Parameters"}), ui::dock_tabs({"Scopes", "Log"})))) {}

glm::vec4 TestPicture::pixel(glm::ivec2 at) const {
    const std::size_t i = static_cast<std::size_t>(at.y * size.x + at.x) * 4;
    return {pixels[i], pixels[i + 1], pixels[i + 2], pixels[i + 3]};
}

PicturesState::PicturesState(ui::ImageStore& images)
    : clean(make_picture(images, {320, 200}, 0)),
      smoky(make_picture(images, {320, 200}, 1)),
      luma(256),
      vectors(images),
      waves(images) {
    for (std::size_t i = 0; i < smoky.pixels.size(); i += 4) {
        const glm::vec3 code(smoky.pixels[i], smoky.pixels[i + 1], smoky.pixels[i + 2]);
        ++luma[static_cast<std::size_t>(std::lround(ui::luma_chroma(code).x))];
    }
    const ui::ScopeSource source{.bytes = smoky.pixels, .size = smoky.size, .channels = 4};
    vectors.update_chroma(source);
    waves.update_luma(source);
}

std::string TestFiles::list(const std::string& folder, std::vector<ui::FileEntry>& entries) {
    constexpr std::int64_t day = 86400, then = 1'760'000'000;
    if (folder == "/locked") return "Permission denied";
    if (folder == "/") entries = {{"clips", true, 0, then}, {"locked", true, 0, then}};
    if (folder != "/clips") return "";
    for (int i = 0; i < 40; ++i)
        entries.push_back({.name = "plume " + std::to_string(i + 1) + (i % 3 == 0 ? ".mov" : ".png"),
                           .size = static_cast<std::uint64_t>(i + 1) * 1'234'567,
                           .changed = then - i * day});
    entries.push_back({.name = "a name that is not UTF-8 \xff\xfe.mov", .size = 12, .changed = then});
    return "";
}

ui::FileSystem::Kind TestFiles::kind(const std::string& path) {
    if (path == "/" || path == "/clips" || path == "/locked") return Kind::folder;
    return path.starts_with("/clips/plume ") ? Kind::file : Kind::nothing;
}

ui::FilePicture TestFilePictures::picture(ui::Ui&, const std::string& path, const ui::FileEntry&) {
    using Picture = ui::FilePicture::State;
    if (path.ends_with(".png")) return {.state = Picture::there, .image = image, .size = size};
    if (ui::name_of_path(path).starts_with("plume")) return {.state = Picture::coming};
    return {.state = Picture::failed, .fault = "is not a video that can be decoded"};
}

GraphsState::GraphsState() {
    constexpr double rate = 60;
    for (int i = 0; i < 600; ++i) {
        const double t = i / rate, speed = 12 * std::exp(-t / 4);
        measured_values.push_back(static_cast<float>(speed + 0.6 * std::sin(17 * t) * std::sin(3.1 * t)));
        simulated_values.push_back(static_cast<float>(speed * (1 + 0.04 * std::sin(t))));
        least_values.push_back(0.9F * simulated_values.back());
        most_values.push_back(1.1F * simulated_values.back() + 0.3F);
    }
    for (std::size_t i = 200; i < 215; ++i) measured_values[i] = NAN;  // a gap
    measured.set(measured_values, 0, 1 / rate);
    simulated.set(simulated_values, 0, 1 / rate);
    least.set(least_values, 0, 1 / rate);
    most.set(most_values, 0, 1 / rate);
    time.time = 3.2;
    time.has_range = true;
    time.range = {1, 9.5};
    tracks = {
        {"Tool",
         {{.name = "cauterise", .start = 1.2, .end = 4.0, .color = 1}, {.name = "suction", .start = 6, .end = 9}}},
        {"Smoke", {{.name = "plume_left.mov", .start = 1.4, .end = 7.5, .selected = true}}},
        {"Marks", {{.name = "peak", .start = 3.6, .end = 3.6}}}};
}

State::State(ui::ImageStore& images) : lists(images), pictures(images) {
    shell.file_pictures.image = pictures.smoky.image;
    shell.file_pictures.size = pictures.smoky.size;
    shell.files.show_pictures(&shell.file_pictures);
    using ui::Key;
    using ui::key_of;
    using ui::Mods;
    commands.add({.id = "file.new",
                  .title = "New preset",
                  .group = "File",
                  .chord = {key_of('N'), Mods::command},
                  .icon = ui::Icon::file,
                  .run = [this] { shell.answer = "new"; }});
    commands.add(
        {.id = "file.save", .title = "Save", .group = "File", .chord = {key_of('S'), Mods::command}, .run = [this] {
             shell.toasts.add({.kind = ui::ToastKind::good, .text = "Saved"});
         }});
    commands.add({.id = "file.close",
                  .title = "Close the window",
                  .group = "File",
                  .chord = {key_of('Q'), Mods::command},
                  .run = [this] { close = true; }});
    commands.add({.id = "edit.undo",
                  .title = "Undo",
                  .group = "Edit",
                  .chord = {key_of('Z'), Mods::command},
                  .icon = ui::Icon::undo,
                  .run = [] {},
                  .enabled = [] { return false; }});
    commands.add({.id = "view.light",
                  .title = "Light theme",
                  .group = "View",
                  .chord = {key_of('L'), Mods::command},
                  .run = [this] { light = !light; },
                  .checked = [this] { return light; }});
    commands.add({.id = "view.motion",
                  .title = "Reduced motion",
                  .group = "View",
                  .run = [this] { reduced_motion = !reduced_motion; },
                  .checked = [this] { return reduced_motion; }});
    commands.add({.id = "view.grid",
                  .title = "Grid",
                  .group = "View",
                  .chord = {key_of('G'), Mods::command},
                  .run = [this] { shell.grid = !shell.grid; },
                  .checked = [this] { return shell.grid; }});
    commands.add({.id = "view.palette",
                  .title = "Command palette",
                  .group = "View",
                  .chord = {key_of('P'), Mods::command},
                  .run = [this] { shell.wants_palette = true; }});
    commands.add({.id = "help.keys", .title = "Keys", .group = "Help", .chord = {Key::f1, Mods::none}, .run = [this] {
                      shell.wants_keys = true;
                  }});
    for (std::size_t i = 0; i < pages().size(); ++i)
        commands.add({.id = "page." + std::string(pages()[i].name),
                      .title = std::string(pages()[i].name),
                      .group = "Page",
                      .run = [this, i] { page = static_cast<int>(i); }});
}

}  // namespace lapfx::gallery
