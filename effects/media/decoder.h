// One clip, decoded by FFmpeg's libraries. Not thread safe: one thread at a time, any thread.
//
//     Decoder decoder("plume.mp4", Layout::planar);        // throws Error: not a clip that we take
//     Picture picture;
//     decoder.read(12, picture);                            // frame 12; the next in order costs one decode
#pragma once

#include <atomic>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "lapfx/authoring/clip.h"
#include "media/picture.h"
#include "work/stages.h"

namespace lapfx::media {

struct ClipIndex;

/// How a player turns a file's pictures to show them upright: mirrored along the file's axes, then x and y exchanged.
struct Turn {
    glm::bvec2 mirrored{false};
    bool transposed = false;
};

/// What a clip is, known from looking through the file's packets without decoding them all.
struct ClipInfo {
    glm::ivec2 size{0};         ///< pixels, as it is to be shown (a rotation that the file asks for is not applied)
    bool alpha = false;         ///< brings its own opacity
    std::string codec;          ///< FFmpeg's name: "h264", "vp8", "png"
    std::string pixel_format;   ///< FFmpeg's name: "yuv420p"
    ColorMatrix color;          ///< of Layout::planar
    Turn turn;                  ///< that the file asks for; not applied
    double pixel_aspect = 1.0;  ///< width over height of a pixel; not applied either
    std::vector<double> times;  ///< s, when each frame is shown, from 0, ascending (variable frame rates are kept)
    double duration = 0.0;      ///< s, the last frame's time included
    std::string warning;        ///< what is odd about the file but does not keep it from playing; one line, or empty
    std::shared_ptr<const ClipIndex> index;  ///< the Decoder's own, for the next one of the same file

    int frame_count() const { return static_cast<int>(times.size()); }
    /// The frame that is shown at `time`, s within 0..duration; clamped.
    int frame_at(double time) const;
};

class Decoder {
  public:
    /// Opens and looks through the file. Throws Error (bad_input): not a plain local file, a playlist, not a video, no
    /// picture, no frame, a side over 8192 pixels, over `maximum_frames`.
    static constexpr int most_frames = 100'000;
    Decoder(const std::filesystem::path& path, Layout layout, int maximum_frames = most_frames,
            const work::Stages& stages = {});
    /// The same file once more, without looking through it again: `known` is another Decoder's info(). Throws Error
    /// (bad_input) when the file is gone or no video any more.
    Decoder(const std::filesystem::path& path, Layout layout, const ClipInfo& known);
    Decoder(Decoder&&) noexcept;
    Decoder& operator=(Decoder&&) noexcept;
    ~Decoder();

    const ClipInfo& info() const;
    PictureFormat format() const;
    /// Decodes all frames, in order. Throws work::Stopped.
    DecodableFrames count_decodable(const work::Stages& stages);
    /// Pictures are of this size from now on, whatever the file's.
    void scale_to(glm::ivec2 size);

    /// Frame `index` (0 .. frame_count - 1) into `into`. Going on to the next frame, or forward by a few, decodes
    /// those; any other jump seeks. A frame that the file cannot give (corrupt, missing, of another size that cannot be
    /// scaled) is the last good one before it, or black; then false. `stop`, if given, ends a long way to a frame
    /// early: false, and `into` is as it was. Throws nothing; never opens another file.
    bool read(int index, Picture& into, const std::atomic<bool>* stop = nullptr) noexcept;
    /// The same into memory of format().bytes(), which is written once, in order, and not read.
    bool read(int index, std::span<std::uint8_t> into, const std::atomic<bool>* stop = nullptr) noexcept;

    /// Closes the file and gives back what decoding takes, 10 to 13 frames. The next read() opens it again; another
    /// file under its name, or none, gives no frames then.
    void rest() noexcept;
    bool rests() const;

    /// s spent in decoding and converting, and in copying into pictures, since it was made.
    double decode_seconds() const;
    double copy_seconds() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

/// Opens and looks through the file; `stop`, if given, ends that early: Error (runtime).
Decoder open_stoppable(const std::filesystem::path& path, Layout layout, int maximum_frames,
                       const std::atomic<bool>* stop);

}  // namespace lapfx::media
