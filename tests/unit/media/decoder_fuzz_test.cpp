// Small clips with seeded damage: opening and reading any of them ends (or the suite does not), with no more frames
// than were allowed, and every fault is one line that names the file.
#include <algorithm>
#include <opencv2/imgcodecs.hpp>
#include <random>

#include "support/clips.h"
#include "unit/media/decoder_support.h"

namespace lapfx::media {
namespace {

using Random = std::mt19937;

constexpr int maximum_frames = 1000;

std::size_t below(Random& random, std::size_t limit) {
    return random() % std::max<std::size_t>(limit, 1);
}

/// Where a change goes: every other one into the first bytes, where the sizes and tables are.
std::size_t place(Random& random, std::size_t size) {
    return random() % 2 == 0 ? below(random, std::min<std::size_t>(size, 400)) : below(random, size);
}

void flip_bytes(std::string& data, Random& random) {
    constexpr unsigned char edges[] = {0x00, 0x01, 0x7f, 0x80, 0xff};
    for (std::size_t i = 1 + below(random, 8); i > 0; --i) {
        char& byte = data[place(random, data.size())];
        byte = static_cast<char>(random() % 2 == 0 ? edges[below(random, std::size(edges))] : random() & 0xff);
    }
}

void cut_off(std::string& data, Random& random) {
    data.resize(1 + below(random, data.size()));
}

/// Copies a part of the file over another, or between two others.
void copy_block(std::string& data, Random& random) {
    const std::size_t length = 1 + below(random, data.size() / 4), from = below(random, data.size() - length);
    const std::string block = data.substr(from, length);
    const std::size_t to = below(random, data.size() - length);
    data.replace(to, random() % 2 == 0 ? length : 0, block);
}

void drop_block(std::string& data, Random& random) {
    const std::size_t length = 1 + below(random, data.size() / 8);
    data.erase(below(random, data.size() - length), length);
}

std::string damaged(std::string data, unsigned seed) {
    Random random(seed);
    constexpr void (*changes[])(std::string&, Random&) = {flip_bytes, flip_bytes, cut_off, copy_block, drop_block};
    for (std::size_t i = 1 + below(random, 2); i > 0; --i)
        if (data.size() > 16) changes[below(random, std::size(changes))](data, random);
    return data;
}

/// The results for the damaged files of one clip.
struct Tally {
    int refused = 0, read = 0, broken = 0;
};

class DecoderFuzz : public DecoderTest {
  protected:
    void read_all(Decoder& decoder, Random& random, Tally& tally) const {
        const int count = decoder.info().frame_count();
        ASSERT_GE(count, 1);
        ASSERT_LE(count, maximum_frames);
        ASSERT_EQ(decoder.info().times.size(), static_cast<std::size_t>(count));
        ASSERT_TRUE(std::is_sorted(decoder.info().times.begin(), decoder.info().times.end()));
        ASSERT_EQ(decoder.info().warning.find('\n'), std::string::npos);
        Picture picture;
        const int in_order = std::min(count, 40);
        for (int step = 0; step < in_order + 8; ++step) {
            const int index = step < in_order ? step : static_cast<int>(below(random, static_cast<std::size_t>(count)));
            if (!decoder.read(index, picture)) ++tally.broken;
            ASSERT_EQ(picture.bytes.size(), decoder.format().bytes());
        }
        ++tally.read;
    }

    void try_file(const fs::path& path, unsigned seed, Tally& tally) const {
        try {
            Decoder decoder(path, seed % 2 == 0 ? Layout::planar : Layout::rgb, maximum_frames);
            Random random(seed);
            read_all(decoder, random, tally);
        } catch (const Error& error) {
            ++tally.refused;
            EXPECT_EQ(error.failure(), Failure::bad_input);
            ASSERT_EQ(error.faults().size(), 1u);
            const std::string line = error.faults()[0].text();
            EXPECT_TRUE(line.starts_with(path.string() + ": ")) << line;
            EXPECT_EQ(line.find('\n'), std::string::npos) << line;
        }
    }

    /// Adds the results for `rounds` damaged copies to `tally`.
    void fuzz(const fs::path& clip, unsigned rounds, Tally& tally) const {
        const std::string whole = test::read_text(clip);
        Tally sound;
        try_file(clip, 0, sound);
        EXPECT_EQ(sound.read, 1) << clip << ": the clip itself is whole";
        EXPECT_EQ(sound.broken, 0) << clip;
        for (unsigned seed = 1; seed <= rounds; ++seed) {
            SCOPED_TRACE(clip.filename().string() + ", seed " + std::to_string(seed));
            try_file(folder.write("damaged" + clip.extension().string(), damaged(whole, seed)), seed, tally);
        }
    }
};

// The bounds below ensure that the damage is neither too light to be noticed nor too heavy to reach a decoder.

TEST_F(DecoderFuzz, DamagedMotionJpegIsReadOrRefused) {
    Tally tally;
    fuzz(test::write_clip(folder / "c.avi", 6, {32, 24}), 120, tally);
    EXPECT_GT(tally.refused, 5);
    EXPECT_GT(tally.read, 30);
    EXPECT_GT(tally.broken, 10);
}

TEST_F(DecoderFuzz, DamagedImagesAreReadOrRefused) {
    cv::Mat noise(24, 32, CV_8UC3);
    cv::RNG random(3);
    random.fill(noise, cv::RNG::UNIFORM, 0, 256);
    Tally tally;
    for (const char* name : {"c.png", "c.jpg", "c.bmp", "c.tiff"}) {
        cv::imwrite((folder / name).string(), noise);
        fuzz(folder / name, 40, tally);
    }
    EXPECT_GT(tally.refused, 30);
    EXPECT_GT(tally.read, 15);
}

TEST_F(DecoderFuzz, DamagedVideosAreReadOrRefused) {
    if (!have_ffmpeg()) GTEST_SKIP() << "no ffmpeg program to make clips with";
    const std::string source = "-f lavfi -i testsrc2=size=48x32:rate=10:duration=1.2,format=rgba ";
    Tally tally;
    for (const char* options :
         {"-pix_fmt yuv420p -c:v libx264 -bf 2 -g 5 -movflags +faststart c.mp4",
          "-pix_fmt yuv420p -c:v libx264 -g 5 c.ts", "-c:v mpeg4 -bf 2 -g 5 c.avi",
          "-vf geq=r=220:g=30:b=40:a=20*N -pix_fmt yuva420p -c:v libvpx -auto-alt-ref 0 -g 5 c.webm", "-c:v ffv1 c.mkv",
          "c.gif"})
        fuzz(make(source + options), 60, tally);
    EXPECT_GT(tally.refused, 50);
    EXPECT_GT(tally.read, 100);
    EXPECT_GT(tally.broken, 100);
}

}  // namespace
}  // namespace lapfx::media
