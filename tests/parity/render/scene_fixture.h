// A tiny scene for tests of whole pictures: a flat sheet of tissue seen from above, a cut and a burn, a smoke clip.
#pragma once

#include <fstream>

#include "lapfx/authoring/preview.h"
#include "lapfx/frame.h"
#include "support/clips.h"
#include "support/gpu_test.h"
#include "support/meshes.h"
#include "unit/preset/support.h"

namespace lapfx::test {

inline void write_obj(const std::filesystem::path& path, const Organ& organ) {
    std::ofstream file(path);
    for (const glm::vec3& p : organ.positions) file << "v " << p.x << ' ' << p.y << ' ' << p.z << '\n';
    for (std::size_t i = 0; i < organ.indices.size(); i += 3)
        file << "f " << organ.indices[i] + 1 << ' ' << organ.indices[i + 1] + 1 << ' ' << organ.indices[i + 2] + 1
             << '\n';
}

class SceneTest : public GpuTest {
  protected:
    static constexpr glm::ivec2 size{96, 72};

    SceneTest() {
        write_obj(folder / "sheet.obj", plane(80.0, 60));
        write_clip(folder / "clip.avi", 12);
        scene.folder = preset.folder = folder.path();
        scene.organ.file = "sheet.obj";
        scene.gravity = {0.0, -1.0, 0.0};  // straight into the sheet
        scene.camera = {.eye = {0.0, 60.0, 0.0}, .target = {0.0, 0.0, 0.0}, .up = {0.0, 0.0, -1.0}, .vignette = 0.0};
        const glm::dvec3 cut(-8.0, 0.0, 4.0), burn(10.0, 0.0, -3.0);
        scene.events = {{.action = ToolAction::cut, .time = 0.0, .duration = 0.1, .position = cut, .to = cut},
                        {.action = ToolAction::cauterise, .time = 0.5, .duration = 3.0, .position = burn, .to = burn}};
        preset.smoke.clips = {{.file = "clip.avi", .role = ClipRole::plume},
                              {.file = "clip.avi", .role = ClipRole::haze}};
    }

    Preview preview() const { return Preview(scene, preset, {.clip_folders = {}, .wait_for_clips = true}); }

    test::Folder folder;
    Scene scene;
    Preset preset;
};

/// The same, drawn as a host does: by Effects into a Frame.
class FrameTest : public SceneTest {
  protected:
    using Picture = std::vector<std::uint8_t>;
    static constexpr double time = 2.0;  // s: it bleeds and smokes

    void SetUp() override {
        SceneTest::SetUp();
        if (!IsSkipped()) frame.emplace();
    }
    static Picture blank(glm::ivec2 of = size) { return Picture(std::size_t{4} * of.x * of.y); }
    /// `smoke`: false leaves it out.
    void draw(Effects& effects, const View& view, Picture& picture, bool smoke = true) {
        frame->begin(size);
        effects.draw_organ(view);
        frame->begin_smoke();
        if (smoke) effects.draw_smoke(view, frame->depth());
        frame->read(picture);
    }

    std::optional<Frame> frame;
};

/// Pixels of which some channel differs by more than `least`.
inline int differing(const Image& a, const Image& b, int least = 2) {
    EXPECT_EQ(a.pixels.size(), b.pixels.size());
    int count = 0;
    for (std::size_t i = 0; i + 3 < a.pixels.size(); i += 4) {
        int largest = 0;
        for (std::size_t c = 0; c < 3; ++c) largest = std::max(largest, std::abs(a.pixels[i + c] - b.pixels[i + c]));
        count += largest > least ? 1 : 0;
    }
    return count;
}

}  // namespace lapfx::test
