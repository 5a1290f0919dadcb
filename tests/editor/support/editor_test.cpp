#include "editor/support/editor_test.h"

#include <cstdlib>

#include "app/base/layouts.h"
#include "app/files/files.h"
#include "app/files/open.h"
#include "app/measure/measured_videos.h"
#include "app/preview/preview_host.h"
#include "lapfx/authoring/clip.h"
#include "lapfx/authoring/prepared_scene.h"
#include "panels/panels.h"
#include "support/folders.h"

namespace lapfx::test {

namespace fs = std::filesystem;

namespace {

/// A sample scene's organ and the facts about its clips, which the editors of all tests share: to load them takes a
/// second.
struct Loaded {
    explicit Loaded(const fs::path& shipped) {
        const document::Content content = app::open_sample(shipped).content;
        scene = content.scene;
        organ = prepare_organ(scene, content.preset.vessels);
        clips->look_through(content.preset, std::vector{shipped / "samples" / "clips"});
    }
    Scene scene;
    std::shared_ptr<const PreparedOrgan> organ;
    std::shared_ptr<ClipCache> clips = std::make_shared<ClipCache>();
};

std::shared_ptr<app::EarlyLoad> sample_loaded(bool whole) {
    const auto handed_out = [](const Loaded& l) { return app::loaded_already(l.scene, l.organ, l.clips); };
    if (whole) {
        static const Loaded sample(source_folder());
        return handed_out(sample);
    }
    static const Loaded light(light_folder());
    return handed_out(light);
}

std::shared_ptr<app::MeasuredVideos> measured_videos() {
    static const auto all = std::make_shared<app::MeasuredVideos>();
    return all;
}

}  // namespace

void EditorTest::SetUp() {
    GpuTest::SetUp();
    if (IsSkipped()) return;
    std::string pattern = (fs::temp_directory_path() / "lapfx-editor-XXXXXX").string();
    folder_ = ::mkdtemp(pattern.data());
    start(begins.window, begins.exact);
}

void SampleTest::SetUp() {
    EditorTest::SetUp();
    if (IsSkipped()) return;
    if (!begins.view) editor().layouts().shown.close("View");
    open_sample();
    if (!begins.layout.empty()) layout(begins.layout);
    if (!begins.time) return;
    editor().timeline.seek(*begins.time);
    ui().frame();
}

void EditorTest::TearDown() {
    editor_.reset();  // its threads wake the UI
    ui_.reset();
    std::error_code error;
    fs::remove_all(folder_, error);
    GpuTest::TearDown();
}

void EditorTest::start(glm::ivec2 size, bool exact) {
    editor_.reset();
    ui_.reset();
    const fs::path data = shipped();
    editor_ =
        std::make_unique<app::Editor>(images_,
                                      app::EditorOptions{.data_folder = data,
                                                         .clip_folders = {data / "samples" / "clips"},
                                                         .folders = {.config = folder_ / "config",
                                                                     .state = folder_ / "state",
                                                                     .cache = folder_ / "cache",
                                                                     .documents = folder_},
                                                         .exact = exact,
                                                         .exact_scale = scene_scale,
                                                         .measures_preview = measures_preview || !exact,
                                                         .measured_side = measured_side,
                                                         .measured = shares_measured ? measured_videos() : nullptr,
                                                         .renderer = "test",
                                                         .software = true,
                                                         .clock = clock,
                                                         .files = nullptr},
                                      shares_organ ? sample_loaded(whole_sample) : nullptr);
    panels::set_up(*editor_);
    ui_ = std::make_unique<ui::Harness>([this](ui::Ui& u) { panels::workspace(u, *editor_); }, size, 1.0F,
                                        &editor_->commands, &images_);
    ui_->around([this](double now, const std::function<void()>& build) { editor_->frame(now, build); });
}

fs::path EditorTest::shipped() const {
    if (!own_shipped.empty()) return own_shipped;
    return whole_sample ? source_folder() : light_folder();
}

void EditorTest::open_sample() {
    app::Opened opened = app::open_sample(shipped());
    editor_->document.open(std::move(opened.content), opened.scene_file, opened.preset_file);
    editor_->looking.camera = editor_->document.scene().camera;
    ui_->frame().frame();
}

void EditorTest::open(const std::vector<std::string>& files) {
    editor_->files().open(files);
    ui_->frame().frame();
}

void EditorTest::layout(std::string_view name) {
    ASSERT_TRUE(editor_->layouts().choose(name));
    ui_->frame().frame();
}

Image EditorTest::picture(double time) {
    editor_->timeline.speed = 0;
    editor_->timeline.seek(time);
    ui_->frame();
    return editor_->preview.read();
}

std::size_t EditorTest::differing(const Image& a, const Image& b, int tolerance) {
    if (a.width != b.width || a.height != b.height) return a.pixels.size() / 4;
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.pixels.size(); i += 4) {
        int most = 0;
        for (std::size_t c = 0; c < 3; ++c) most = std::max(most, std::abs(a.pixels[i + c] - b.pixels[i + c]));
        count += most > tolerance ? 1 : 0;
    }
    return count;
}

}  // namespace lapfx::test
