#include "output/bundle_sources.h"

#include <gmock/gmock.h>

#include "lapfx/preset.h"
#include "unit/preset/support.h"

namespace lapfx::output {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::IsEmpty;

class BundleSources : public testing::Test {
  protected:
    BundleSources() {
        for (const char* name : {"case", "case/maps", "else", "clips"}) fs::create_directory(root() / name);
        for (const char* name : {"case/liver.obj", "case/maps/skin.png", "case/p.mp4", "else/tool.glb", "else/a.obj",
                                 "else/a.mtl", "clips/s.mp4"})
            folder_.write(name, "x");
        scene_.folder = root() / "case";
        scene_.organ.file = "liver.obj";
        preset_.folder = root() / "case";
    }
    fs::path root() const { return fs::canonical(folder_.path()); }
    std::vector<SourceFile> found(std::span<const fs::path> organ_files = {},
                                  std::span<const fs::path> tool_files = {}) const {
        return outside_files(preset_, &scene_, root() / "case", {root() / "clips"}, organ_files, tool_files);
    }

    test::Folder folder_;
    Scene scene_;
    Preset preset_;
};

TEST_F(BundleSources, NothingIsOutsideOfASceneThatHasAllInItsFolder) {
    preset_.smoke.clips = {{.file = "p.mp4"}};
    const fs::path inside[] = {root() / "case/liver.obj", root() / "case/maps/skin.png"};
    EXPECT_THAT(found(inside), IsEmpty());
}

TEST_F(BundleSources, OrganToolAndClipsFromElsewhereAreNamedOnceWithTheirPlace) {
    scene_.organ.file = "../else/a.obj";
    scene_.tool.file = (root() / "else/tool.glb").string();
    preset_.smoke.clips = {{.file = "p.mp4"}, {.file = "s.mp4"}, {.file = "s.mp4"}, {.file = "nowhere.mp4"}};
    const fs::path organ[] = {root() / "case/../else/a.obj", root() / "else/a.mtl"};
    EXPECT_THAT(found(organ),
                ElementsAre(SourceFile{"Organ", root() / "else/a.obj"}, SourceFile{"Organ", root() / "else/a.mtl"},
                            SourceFile{"Tool", root() / "else/tool.glb"}, SourceFile{"Clip", root() / "clips/s.mp4"}));
}

TEST_F(BundleSources, WhatTheToolNamesIsListedToo) {
    scene_.tool.file = "../else/a.obj";
    const fs::path tool[] = {root() / "else/a.obj", root() / "else/a.mtl"};
    EXPECT_THAT(found({}, tool),
                ElementsAre(SourceFile{"Tool", root() / "else/a.obj"}, SourceFile{"Tool", root() / "else/a.mtl"}));
}

TEST_F(BundleSources, AnImageOfASequenceThatLinksElsewhereIsListed) {
    for (const char* name : {"case/s_0001.png", "case/s_0002.png", "else/private.png"}) folder_.write(name, "x");
    fs::create_symlink("../else/private.png", root() / "case/s_0003.png");
    preset_.smoke.clips = {{.file = (root() / "case/s_%04d.png").string()}};
    EXPECT_THAT(found(), ElementsAre(SourceFile{"Clip", root() / "else/private.png"}));
}

TEST_F(BundleSources, ALinkIsWhatItLeadsTo) {
    fs::create_symlink("../else/a.obj", root() / "case/mine.obj");
    scene_.organ.file = "mine.obj";
    EXPECT_THAT(found(), ElementsAre(SourceFile{"Organ", root() / "else/a.obj"}));
}

TEST_F(BundleSources, WithoutASceneOnlyClipsCountAndWithoutAFolderAll) {
    scene_.organ.file = "../else/a.obj";
    preset_.smoke.clips = {{.file = "p.mp4"}};
    EXPECT_THAT(outside_files(preset_, nullptr, root() / "case", {}), IsEmpty());
    EXPECT_THAT(outside_files(preset_, nullptr, {}, {}), ElementsAre(SourceFile{"Clip", root() / "case/p.mp4"}));
}

}  // namespace
}  // namespace lapfx::output
