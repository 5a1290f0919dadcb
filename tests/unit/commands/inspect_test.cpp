// `lapfx inspect` as a program: its stdout, stderr and exit code.
#include <sys/wait.h>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/videoio.hpp>
#include <sstream>

#include "lapfx/preset.h"
#include "media/decoder.h"
#include "media/playhead.h"
#include "support/folders.h"
#include "unit/organ/fixtures.h"

namespace lapfx::test {
namespace {

struct Result {
    int code = -1;
    std::string out, err;
};

std::string read_text(const fs::path& file) {
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
}

class InspectCommand : public testing::Test {
  protected:
    void SetUp() override {
        if (!fs::exists(build_folder() / "lapfx")) GTEST_SKIP() << "the program is not built";
    }
    Result run(const std::string& arguments) {
        const std::string command = "cd '" + folder.path().string() + "' && timeout 600 '" +
                                    (build_folder() / "lapfx").string() + "' inspect " + arguments +
                                    " > out.txt 2> err.txt < /dev/null";
        const int status = std::system(command.c_str());
        return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_text(folder.path() / "out.txt"),
                read_text(folder.path() / "err.txt")};
    }
    void write_video(const char* name, int frames = 5, double rate = 10.0) {
        cv::VideoWriter writer((folder.path() / name).string(), cv::CAP_FFMPEG,
                               cv::VideoWriter::fourcc('M', 'J', 'P', 'G'), rate, cv::Size(64, 48));
        for (int i = 0; i < frames; ++i) writer.write(cv::Mat(48, 64, CV_8UC3, cv::Scalar(i * 20, 0, 0)));
    }
    TemporaryFolder folder;
};

TEST_F(InspectCommand, Mesh) {
    folder.write("cube.obj", cube_obj);
    const Result result = run("cube.obj");
    EXPECT_EQ(result.code, 0);
    EXPECT_EQ(result.err, "");
    EXPECT_EQ(result.out,
              "cube.obj: mesh\n"
              "  vertices            8\n"
              "  triangles           12\n"
              "  in the file         12 triangles, none left out\n"
              "  split for blood     into 768 triangles, no edge longer than 2 mm\n"
              "  components          1\n"
              "  boundary edges      0\n"
              "  non-manifold edges  0\n"
              "  size                10.0 x 10.0 x 10.0 mm\n"
              "  scale               1 mm per unit of the file\n"
              "  texture coordinates made\n"
              "  vertex colours      none\n"
              "  parts               1\n"
              "                      (unnamed): 12 triangles, material default\n"
              "  materials           1\n"
              "                      default: base colour texture none, normal map none, roughness 0.50\n"
              "  textures            0\n"
              "  warning             it has only one colour: density of vessels and fat is not known, and every cut "
              "bleeds equally\n");
}

TEST_F(InspectCommand, VideoAndImage) {
    write_video("clip.avi");
    cv::imwrite((folder.path() / "grey.png").string(), cv::Mat(3, 5, CV_16UC1, cv::Scalar(7)));
    const Result result = run("clip.avi grey.png");
    EXPECT_EQ(result.code, 0) << result.err;
    EXPECT_EQ(result.out,
              "clip.avi: video\n  size                64x48\n  frames per second   10\n  frames              5\n"
              "  duration            0.500 s\n  codec               mjpeg\n"
              "  pixel format        yuvj420p\n"
              "grey.png: image\n  size                5x3\n  channels            grey, 16 bit\n");
}

TEST_F(InspectCommand, AnimatedPicturesAreVideosOrToldAsWhatTheyAre) {
    std::vector<unsigned char> png;
    cv::imencode(".png", cv::Mat(3, 5, CV_8UC1, cv::Scalar(7)), png);
    std::string still(png.begin(), png.end()), moving = still;
    // One frame, shown for a tenth of a second. FFmpeg does not check the sums of these chunks.
    constexpr char chunks[] =
        "\0\0\0\x08"
        "acTL\0\0\0\x01\0\0\0\0"
        "\0\0\0\0"
        "\0\0\0\x1a"
        "fcTL\0\0\0\0\0\0\0\x05\0\0\0\x03\0\0\0\0\0\0\0\0\0\x01\0\x0a\0\0"
        "\0\0\0\0";
    constexpr std::size_t header = 33;  // bytes of the signature and IHDR
    moving.insert(header, std::string(chunks, sizeof chunks - 1));
    folder.write("a.png", moving);
    folder.write("a.webp", std::string("RIFF\x20\0\0\0WEBPVP8X\x0a\0\0\0\x02\0\0\0\x0f\0\0\x0f\0\0ANIM\0\0", 36));
    const Result result = run("a.png a.webp");
    EXPECT_TRUE(result.out.starts_with("a.png: video\n  size                5x3\n")) << result.out;
    EXPECT_EQ(
        result.err,
        "lapfx: a.webp: is an animated WebP, which is not read; save it as a video, or as an animated PNG or GIF\n");
    EXPECT_EQ(result.code, 2);
}

TEST_F(InspectCommand, FramesThatCannotBeDecodedAreTold) {
    write_video("clip.avi");
    std::string bytes = read_text(folder.path() / "clip.avi");
    const std::size_t second = bytes.find("\xff\xd8", bytes.find("\xff\xd8") + 2);  // where a JPEG begins
    ASSERT_NE(second, std::string::npos);
    const std::size_t third = bytes.find("\xff\xd8", second + 2);
    ASSERT_NE(third, std::string::npos);
    bytes.replace(second, third - second - 16, third - second - 16, '\0');
    folder.write("clip.avi", bytes);
    const Result result = run("clip.avi");
    EXPECT_EQ(result.code, 0) << result.err;
    EXPECT_NE(result.out.find("  frames              5, of which 4 can be decoded; the one before is shown\n"),
              std::string::npos)
        << result.out;
}

TEST_F(InspectCommand, OutAtTheTimeThatIsToldPlaysNoFrameThatCannotBeDecoded) {
    write_video("clip.avi", 60, 30.0);
    std::string bytes = read_text(folder.path() / "clip.avi");
    const std::size_t index = bytes.rfind("idx1"), last = bytes.rfind("\xff\xd8", index);
    ASSERT_NE(index, std::string::npos);
    ASSERT_NE(last, std::string::npos);
    bytes.replace(last, index - last, index - last, '\0');
    folder.write("clip.avi", bytes);
    const Result result = run("clip.avi");
    EXPECT_EQ(result.code, 0) << result.err;
    EXPECT_NE(
        result.out.find("  frames              60, of which 59 can be decoded; the one before is shown, none after "
                        "1.966 s (a clip's \"out\" there leaves them out)\n"),
        std::string::npos)
        << result.out;
    const media::Decoder decoder(folder.path() / "clip.avi", media::Layout::planar);
    const auto last_played = [&](double out) {
        return media::main_loop(decoder.info(), SmokeClip{.file = "clip.avi", .out = out}).last;
    };
    EXPECT_EQ(last_played(1.966), 58);
    EXPECT_EQ(last_played(1.967), 59) << "59 / 30 s is less";
}

TEST_F(InspectCommand, EveryBadFileIsOneLineAndTheGoodOnesAreStillTold) {
    folder.write("cube.obj", cube_obj);
    folder.write("empty.glb", "");
    folder.write("text.mp4", "no video at all, but some text that is long enough to look at");
    write_video("video.avi");
    fs::copy_file(folder.path() / "video.avi", folder.path() / "video.obj");
    ASSERT_EQ(mkfifo((folder.path() / "pipe.mp4").c_str(), 0600), 0);
    folder.write("skin.mtl", "newmtl skin\nmap_Kd skin.png\n");
    const Result result = run("gone.glb empty.glb text.mp4 video.obj pipe.mp4 cube.obj . skin.mtl");
    EXPECT_EQ(result.code, 2);
    EXPECT_TRUE(result.out.starts_with("cube.obj: mesh\n"));
    EXPECT_EQ(result.err,
              "lapfx: gone.glb: no such file\n"
              "lapfx: empty.glb: is empty\n"
              "lapfx: text.mp4: is not a video that can be decoded\n"
              "lapfx: video.obj: is not an OBJ: it is not a text file\n"
              "lapfx: pipe.mp4: is a pipe or device, expected a plain file\n"
              "lapfx: .: is a folder, expected a file\n"
              "lapfx: skin.mtl: is a text, but not a preset, a scene or a mesh\n");
}

TEST_F(InspectCommand, NoProtocolAndNoPlaylist) {
    write_video("clip.avi");
    folder.write("list.mp4", "ffconcat version 1.0\nfile clip.avi\n");
    folder.write("hls.mp4", "#EXTM3U\n#EXT-X-TARGETDURATION:1\n#EXTINF:1,\nclip.avi\n#EXT-X-ENDLIST\n");
    const Result result = run("list.mp4 hls.mp4 concat:clip.avi file:clip.avi");
    EXPECT_EQ(result.code, 2);
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(result.err,
              "lapfx: list.mp4: is a playlist; a clip is a single video file\n"
              "lapfx: hls.mp4: is a playlist; a clip is a single video file\n"
              "lapfx: concat:clip.avi: no such file\n"
              "lapfx: file:clip.avi: no such file\n");
}

TEST_F(InspectCommand, TruncatedVideo) {
    write_video("clip.avi");
    const std::string whole = read_text(folder.path() / "clip.avi");
    folder.write("short.avi", whole.substr(0, 300));
    EXPECT_EQ(run("short.avi").code, 2);
}

TEST_F(InspectCommand, SuggestedKeyingIsReadyForAPreset) {
    cv::VideoWriter writer((folder.path() / "smoke.avi").string(), cv::CAP_FFMPEG,
                           cv::VideoWriter::fourcc('M', 'J', 'P', 'G'), 10.0, cv::Size(128, 96));
    for (int i = 0; i < 8; ++i) {
        cv::Mat frame(96, 128, CV_8UC3, cv::Scalar(64, 177, 0));
        frame(cv::Rect(40 + i, 40, 30, 30)) = cv::Scalar(200, 200, 200);
        writer.write(frame);
    }
    writer.release();
    const Result result = run("--keying smoke.avi");
    ASSERT_EQ(result.code, 0) << result.err;
    ASSERT_TRUE(result.out.starts_with("smoke.avi: video\n  size                128x96\n"));
    EXPECT_NE(result.out.find("\n  keying              the background is green (0, 17"), std::string::npos)
        << result.out;
    EXPECT_NE(result.out.find("\n  confidence          "), std::string::npos);
    const std::string clip = result.out.substr(std::min(result.out.find("\"polarity\""), result.out.size()));
    const Preset preset = parse_preset(R"({"format": "lapfx.preset", "version": 1, "name": "x", "smoke": {"clips": [
        {"file": "smoke.avi", )" + clip + "}]}}",
                                       "test");
    const KeyingParameters& keying = preset.smoke.clips.at(0).keying;
    EXPECT_TRUE(preset.smoke.clips[0].own_keying);
    EXPECT_NEAR(keying.key_color.g, 177.0 / 255.0, 0.02);
    EXPECT_NEAR(keying.chroma_high, 84.0, 5.0);
    EXPECT_EQ(keying.spill, 1.0);
}

TEST_F(InspectCommand, KeyingIsSuggestedForVideosOnly) {
    folder.write("cube.obj", cube_obj);
    const Result result = run("--keying cube.obj");
    EXPECT_EQ(result.code, 2);
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(result.err, "lapfx: cube.obj: is not a clip, so there is no keying to suggest\n");
}

TEST_F(InspectCommand, NumberedImagesAreAClip) {
    for (const char* name : {"s_0003.png", "s_0004.png"})
        cv::imwrite((folder.path() / name).string(), cv::Mat(48, 64, CV_8UC3, cv::Scalar::all(9)));
    const Result result = run("s_%04d.png t_%04d.png");
    EXPECT_EQ(result.code, 2);
    EXPECT_EQ(result.out,
              "s_%04d.png: video\n  size                64x48\n  frames per second   25\n  frames              2\n"
              "  duration            0.080 s\n  codec               png\n  pixel format        rgb24\n");
    EXPECT_EQ(result.err, "lapfx: t_%04d.png: no such file\n");
}

TEST_F(InspectCommand, KeyingThatIsAGuessIsWarnedOf) {
    cv::imwrite((folder.path() / "plain.png").string(), cv::Mat(96, 128, CV_8UC3, cv::Scalar::all(0)));
    const Result result = run("--keying plain.png");
    EXPECT_EQ(result.code, 0);
    EXPECT_TRUE(result.out.starts_with("plain.png: image\n  size                128x96\n")) << result.out;
    EXPECT_NE(result.out.find("\n\"polarity\""), std::string::npos) << result.out;
    EXPECT_EQ(
        result.err,
        "lapfx: warning: plain.png: this keying is a guess; check the clip with it before you use it in a preset\n");
}

TEST_F(InspectCommand, AClipWithOpacityOfItsOwnHasNoKeyingToPaste) {
    cv::Mat smoke(96, 128, CV_8UC4, cv::Scalar(200, 200, 200, 0));
    smoke(cv::Rect(40, 40, 30, 30)) = cv::Scalar(200, 200, 200, 128);
    cv::imwrite((folder.path() / "alpha.png").string(), smoke);
    const Result result = run("--keying alpha.png");
    EXPECT_EQ(result.code, 0);
    EXPECT_EQ(result.err, "");
    EXPECT_NE(result.out.find("\n  keying              the clip has its own opacity"), std::string::npos);
    EXPECT_EQ(result.out.find("polarity"), std::string::npos) << result.out;
    EXPECT_EQ(result.out.find("confidence"), std::string::npos) << result.out;
}

TEST_F(InspectCommand, WrongUsage) {
    EXPECT_EQ(run("").code, 2);
}

}  // namespace
}  // namespace lapfx::test
