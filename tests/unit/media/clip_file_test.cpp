#include "media/clip_file.h"

#include <gmock/gmock.h>

#include "lapfx/authoring/clip.h"
#include "media/decoder.h"
#include "support/clips.h"
#include "unit/preset/support.h"

namespace lapfx::media {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;

class ClipFile : public testing::Test {
  protected:
    test::Folder folder;

    /// The fault of opening a file, without its path, which must come first.
    std::string fault(const fs::path& path) const {
        const auto lines = test::faults_of([&] { Decoder(path, Layout::planar); });
        if (lines.size() != 1) return std::to_string(lines.size()) + " faults";
        EXPECT_TRUE(lines[0].starts_with(path.string() + ": ")) << lines[0];
        return lines[0].substr(std::min(lines[0].size(), path.string().size() + 2));
    }
};

TEST_F(ClipFile, InfoTellsSizeSpeedAndFramesThatDecode) {
    const Decoder decoder(test::write_clip(folder / "c.avi", 7, {80, 32}, 12.5), Layout::planar);
    const ClipInfo& info = decoder.info();
    EXPECT_EQ(info.size, glm::ivec2(80, 32));
    EXPECT_NEAR(info.duration, 7.0 / 12.5, 1e-6);
    EXPECT_EQ(info.frame_count(), 7);
}

TEST_F(ClipFile, WhatIsNoVideoIsNamed) {
    EXPECT_EQ(fault(folder / "none.avi"), "no such file");
    EXPECT_EQ(fault(folder.path()), "is a folder; a video file is needed");
    EXPECT_EQ(fault(folder.write("empty.avi", "")), "is empty");
    EXPECT_EQ(fault(folder.write("text.avi", "This is no video, whatever its name says.\n")),
              "is not a video that can be decoded");
    EXPECT_EQ(fault("/dev/null"), "is not a plain file");
}

TEST_F(ClipFile, APlaylistIsRefusedWhateverItNames) {
    test::write_clip(folder / "real.avi", 3);
    const std::string refused = "is a playlist; a clip is a single video file";
    EXPECT_EQ(fault(folder.write("a.m3u8", "#EXTM3U\n#EXTINF:1,\nreal.avi\n#EXT-X-ENDLIST\n")), refused);
    EXPECT_EQ(fault(folder.write("a.avi", "#EXTM3U\n#EXTINF:1,\nreal.avi\n#EXT-X-ENDLIST\n")), refused);
    EXPECT_EQ(fault(folder.write("b.avi", "ffconcat version 1.0\nfile real.avi\n")), refused);
    EXPECT_EQ(fault(folder.write("c.avi", "<?xml version=\"1.0\"?><MPD></MPD>")), refused);
    EXPECT_EQ(fault(folder.write("d.avi", "v=0\no=- 0 0 IN IP4 127.0.0.1\n")), refused);
    EXPECT_EQ(fault(folder.write("e.avi", "[playlist]\nFile1=real.avi\n")), refused);
}

TEST_F(ClipFile, APlaylistBehindACommentOrSpaceIsNotFollowedEither) {
    test::write_clip(folder / "real.avi", 3);
    fs::rename(folder / "real.avi", folder / "real.mp4");  // FFmpeg also considers the extension
    const std::string manifest =
        "<MPD xmlns=\"urn:mpeg:dash:schema:mpd:2011\" type=\"static\" "
        "profiles=\"urn:mpeg:dash:profile:isoff-on-demand:2011\" "
        "mediaPresentationDuration=\"PT1S\"><Period><AdaptationSet mimeType=\"video/avi\"><Representation id=\"1\" "
        "bandwidth=\"1\"><BaseURL>real.mp4</BaseURL></Representation></AdaptationSet></Period></MPD>";
    for (const std::string& text : {"<!-- not an MPD at first sight -->" + manifest, "\n  " + manifest,
                                    std::string("\n#EXTM3U\n#EXTINF:1,\nreal.mp4\n#EXT-X-ENDLIST\n"),
                                    std::string(" ffconcat version 1.0\nfile real.mp4\n")})
        EXPECT_EQ(fault(folder.write("a.avi", text)), "is not a video that can be decoded") << text;
}

TEST_F(ClipFile, OfATruncatedFileTheFramesThatAreThereCount) {
    const std::string whole = test::read_text(test::write_clip(folder / "whole.avi", 20, {320, 240}));
    const fs::path half = folder.write("half.avi", whole.substr(0, whole.size() / 2));
    const Decoder decoder(half, Layout::planar);
    const ClipInfo& info = decoder.info();
    EXPECT_EQ(info.size, glm::ivec2(320, 240));
    EXPECT_GE(info.frame_count(), 3);
    EXPECT_LE(info.frame_count(), 12);
    const std::string why = fault(folder.write("head.avi", whole.substr(0, 200)));
    EXPECT_THAT(why, testing::AnyOf("is not a video that can be decoded", "contains no picture",
                                    "has no frame that can be decoded"));
}

class FindClip : public ClipFile {
  protected:
    void SetUp() override {
        for (const char* name : {"preset", "first", "second", "preset/sub"}) fs::create_directory(folder / name);
    }
    fs::path find(const std::string& file) const { return find_clip(file, folder / "preset", search); }
    std::vector<fs::path> search{folder / "first", folder / "second"};
};

TEST_F(FindClip, ThePresetsFolderComesFirstThenTheSearchPathInOrder) {
    folder.write("second/c.avi", "x");
    EXPECT_EQ(find("c.avi"), folder / "second/c.avi");
    folder.write("first/c.avi", "x");
    EXPECT_EQ(find("c.avi"), folder / "first/c.avi");
    folder.write("preset/c.avi", "x");
    EXPECT_EQ(find("c.avi"), folder / "preset/c.avi");
}

TEST_F(FindClip, OnlyBareNamesAreLookedUpOnTheSearchPath) {
    fs::create_directory(folder / "first/sub");
    folder.write("first/sub/c.avi", "x");
    EXPECT_THAT(test::faults_of([&] { find("sub/c.avi"); }),
                ElementsAre("sub/c.avi: no such clip; looked in " + (folder / "preset").string()));
    folder.write("preset/sub/c.avi", "x");
    EXPECT_EQ(find("sub/c.avi"), folder / "preset/sub/c.avi");
}

TEST_F(FindClip, NamesEveryFolderItLookedIn) {
    const std::string preset = (folder / "preset").string(), first = (folder / "first").string();
    EXPECT_THAT(test::faults_of([&] { find("c.avi"); }), ElementsAre("c.avi: no such clip; looked in " + preset + ", " +
                                                                     first + ", " + (folder / "second").string()));
    EXPECT_THAT(test::faults_of([&] { find_clip("no-such-clip.avi", "", {}); }),
                ElementsAre("no-such-clip.avi: no such clip; looked in ."));
}

TEST_F(FindClip, AFolderIsNoClip) {
    fs::create_directory(folder / "first/c.avi");
    folder.write("second/c.avi", "x");
    EXPECT_EQ(find("c.avi"), folder / "second/c.avi");
    for (const char* name : {"c.avi", "c%d.png"}) fs::create_directory(folder / "preset" / name);
    folder.write("preset/c0.png", "x");
    for (const std::string name : {"c.avi", "c%d.png"})
        EXPECT_THAT(test::faults_of([&] { find(name); }), ElementsAre(name + ": is a folder; a video file is needed"));
    EXPECT_THAT(clip_images(folder / "preset/c%d.png"), testing::IsEmpty());
}

TEST_F(FindClip, TheImagesOfAPatternAreThoseThatArePlayed) {
    for (const char* name : {"c_07.png", "c_08.png", "c_10.png", "c_9.png", "d.png"}) folder.write(name, "x");
    EXPECT_THAT(clip_images(folder / "c_%02d.png"), ElementsAre(folder / "c_07.png", folder / "c_08.png"));
    EXPECT_THAT(clip_images(folder / "c_%d.png"), ElementsAre(folder / "c_9.png", folder / "c_10.png"));
    EXPECT_THAT(clip_images(folder / "d.png"), testing::IsEmpty());
    EXPECT_THAT(clip_images(folder / "gone_%d.png"), testing::IsEmpty());
}

}  // namespace
}  // namespace lapfx::media
