// Memory of the editor: after each action and its undo, the editor uses as much as before.
#include "app/memory.h"

#include <gmock/gmock.h>

#include "app/clips/keying_bench.h"
#include "app/measure/amounts.h"
#include "app/reference/reference.h"
#include "app/tuning/snapshots.h"
#include "editor/support/editor_test.h"
#include "lapfx/prepared_organ.h"
#include "support/wait_until.h"

namespace lapfx::test {
namespace {

class EditorMemory : public SampleTest {
  protected:
    /// Plays all clips, which loads them into graphics memory. The picture is small to make that quick.
    void play_through() {
        constexpr int longest_clip = 180;
        app::PreviewHost& host = editor().preview;
        const glm::ivec2 size = host.size();
        host.resize({32, 24});
        app::Shot shot = editor().shot();
        for (int i = 0; i < longest_clip + 16; ++i) {
            shot.time = 1 + i / 30.0;
            host.draw(shot);
        }
        host.resize(size);
        ui().frame();
    }
    MemoryUse use() { return editor().preview.memory_use(); }
    std::size_t clips() { return use().clips; }
    void change(const std::function<void(document::Content&)>& what) {
        editor().document.change("Test", what);
        ui().frame().frame();
    }
    void undo() {
        editor().document.undo();
        ui().frame().frame();
    }
};

/// An organ that nobody else holds.
class EditorMemoryOfOrgan : public EditorMemory {
  protected:
    EditorMemoryOfOrgan() { shares_organ = false; }
};

/// With the textures and clips that are shipped.
class EditorMemoryInFull : public EditorMemoryOfOrgan {
  protected:
    EditorMemoryInFull() { scene_scale = 1, whole_sample = true; }
};

TEST_F(EditorMemoryInFull, APlayedSampleHoldsItsClipsAndLittleElse) {
    play_through();
    constexpr std::size_t frame = 720 * 480 * 3 / 2;
    EXPECT_EQ(clips(), (150 + 150 + 180) * frame) << "each frame of three clips once, and no buffers";
    const MemoryUse held = use();
    EXPECT_LT(held.pixels, 4'000'000U) << "textures are on the GPU, and no more in main memory";
    const std::size_t texels = 2 * 2048 * 2048 + 4 * 1024 * 1024;  // of the textures with a density map
    EXPECT_LT(held.densities, texels * 17 / 8 + 13'000'000) << "two bytes and a bit a texel, and the mesh";
    EXPECT_LT(held.surface, 40'000'000U);
    EXPECT_LT(held.total() - held.clips - held.targets, 200'000'000U);
}

TEST_F(EditorMemory, AClipThatIsTakenOutTakesItsMemoryWithIt) {
    play_through();
    constexpr std::size_t frame = 180 * 120 * 3 / 2;
    const std::size_t before = clips();
    change([](document::Content& c) { c.preset.smoke.clips.push_back({.file = "plume_green.mp4"}); });
    play_through();
    EXPECT_EQ(clips(), before + 150 * frame);
    undo();
    EXPECT_EQ(clips(), before);
    editor().document.redo();
    ui().frame();
    play_through();
    const std::size_t with = clips();
    change([](document::Content& c) { c.preset.smoke.clips.pop_back(); });
    EXPECT_EQ(clips(), before);
    undo();
    play_through();
    EXPECT_EQ(clips(), with) << "it comes back, whole";
}

TEST_F(EditorMemory, SnapshotsShownToAndFroHoldWhatIsShown) {
    play_through();
    const std::size_t before = use().total();
    editor().snapshots().keep(0);
    change([](document::Content& c) {
        c.preset.smoke.clips = {{.file = "plume_green.mp4"}};
        c.preset.vessels.vessel_low = 0.07;
        c.preset.vessels.smoothing = 0.3;
    });
    editor().snapshots().keep(1);
    for (int i = 0; i < 2; ++i) {
        editor().snapshots().show(0);
        ui().frame().frame();
        play_through();
        EXPECT_EQ(use().total(), before) << i;
        editor().snapshots().show(1);
        ui().frame().frame();
        play_through();
        EXPECT_LT(use().total(), before) << i << ": it has one clip";
    }
}

TEST_F(EditorMemoryOfOrgan, TheFormerOrganGoesAlsoFromThoseWhoHaveWorkedWithIt) {
    ui().click("Workspace/tabs/Amounts").click("**/Amounts/On organ");
    editor().looking.overlay = Overlay::vessels;
    ui().frame().frame();
    ASSERT_NE(editor().amounts().scene(), nullptr);
    layout("Tune");  // the amounts are not shown any more
    editor().looking.overlay = Overlay::none;
    ui().frame().frame();
    const std::weak_ptr<const PreparedOrgan> former = editor().preview.organ_of(editor().document.scene());
    ASSERT_FALSE(former.expired());
    const std::size_t before = use().total() - use().clips;
    change([](document::Content& c) { c.scene.organ.file = "liver_lobe.glb"; });
    ui().frame().frame();
    EXPECT_TRUE(former.expired()) << "by " << former.use_count();
    EXPECT_LT(use().total() - use().clips, before);
    undo();
    ui().frame().frame();
    EXPECT_LE(use().total() - use().clips, before) << "textures of overlays aside it is what it was";
    EXPECT_GE(use().total() - use().clips + 4'000'000, before);
}

TEST_F(EditorMemory, ZoomStepsBesideTheReferenceLeaveNoTargetsBehind) {
    layout("Compare");
    app::Reference& reference = editor().reference();
    reference.comparison().show_at(1);
    ui().frame().frame();
    const auto held = [&] { return reference.comparison().memory() + use().targets; };
    const std::size_t before = held();
    for (int i = 0; i < 3; ++i) {
        for (const double zoom : {1.5, 0.4, 2.2, 0.7}) {
            reference.comparison().show_at(zoom);
            ui().frame().frame();
        }
    }
    reference.comparison().show_at(1);
    ui().frame().frame();
    EXPECT_EQ(held(), before);
}

TEST_F(EditorMemory, TheKeyingBenchHoldsNothingWhileNobodyLooks) {
    constexpr std::size_t picture_bytes = 180 * 120 * 4;
    const auto pictures = [&] {
        std::size_t bytes = 0;
        for (const ui::StoredImage& image : editor().images.all()) bytes += image.pixels.size();
        return bytes;
    };
    layout("Key");
    layout("Tune");
    ui().frame().frame();
    const std::size_t before = pictures();
    layout("Key");
    ui().frame().frame();
    ASSERT_TRUE(editor().keying().ready());
    EXPECT_GE(pictures(), before + 4 * picture_bytes) << "source, matte, keyed, composite";
    const glm::vec4 matte = editor().keying().picture(app::BenchView::matte).pixels->pixel({90, 60});
    layout("Tune");
    ui().frame().frame();
    EXPECT_EQ(pictures(), before);
    EXPECT_FALSE(editor().keying().ready());
    layout("Key");
    ui().frame().frame();
    ASSERT_TRUE(editor().keying().ready());
    EXPECT_EQ(editor().keying().picture(app::BenchView::matte).pixels->pixel({90, 60}), matte);
}

TEST_F(EditorMemoryInFull, ThePictureIsTheSameFromPixelsThatWereDecodedAgain) {
    const Image first = picture(6);
    const auto organ = editor().preview.organ_of(editor().document.scene());
    Preview again(editor().document.scene(), editor().document.preset(), organ,
                  {.clip_folders = editor().options().clip_folders,
                   .wait_for_clips = true,
                   .clip_cache = editor().preview.clip_cache()});
    const Image second = again.image(6, {first.width, first.height});
    EXPECT_TRUE(second.pixels == first.pixels);
    change([](document::Content& c) { c.preset.vessels.vessel_low = 0.12; });
    const Image other = picture(6);
    undo();
    EXPECT_TRUE(picture(6).pixels == first.pixels) << "so do maps that are made anew";
    EXPECT_FALSE(other.pixels == first.pixels) << "which other values had made others of";
}

TEST_F(EditorMemoryOfOrgan, TheStatusBarSaysWhatHoldsIt) {
    start({1440, 900}, false);
    open_sample();
    std::string tip;
    EXPECT_TRUE(wait_until([&] { return tip.find("Smoke clips") != std::string::npos; },
                           [&] {
                               ui().frame(0.1);
                               if (clips() > 1'000'000) tip = ui().frame(2).tip("Status bar/Memory");
                           }));
    for (const char* part : {"Smoke clips", "Organ's textures", "Maps of vessels and fat", "Organ's surface",
                             "Pictures of the scene", "Program and libraries", "Driver, decoders, all else"})
        EXPECT_THAT(tip, testing::HasSubstr(part));
    std::size_t sum = 0;
    for (const app::MemoryPart& part :
         app::memory_parts(editor().preview, editor().reference(), editor().measuring(), editor().preview_measuring(),
                           editor().images, editor().document))
        sum += part.bytes;
    const app::ProcessMemory process = app::ProcessMemory::now();
    EXPECT_GT(process.all, process.files + sum / 2) << "what is counted is there";
}

}  // namespace
}  // namespace lapfx::test
