// One clip, decoded by FFmpeg's libraries. Not thread safe: one thread at a time, any thread.
//
//     Decoder decoder("plume.mp4", Layout::planar);        // throws Error: not a clip that we take
//     Picture picture;
//     decoder.read(12, picture);                            // frame 12; the next in order costs one decode
#pragma once

#include <atomic>
#include <cstdint>
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

/// How a player turns pictures to show them upright: it mirrors them along the file's axes, then exchanges x and y.
struct Turn {
    glm::bvec2 mirrored{false};
    bool transposed = false;
};

/// What the packets of a file say about a clip, without decoding all of them.
struct ClipInfo {
    glm::ivec2 size{0};                     ///< pixels, without the rotation that the file asks for
    bool alpha = false;                     ///< it has its own opacity
    std::string codec;                      ///< FFmpeg's name: "h264", "vp8", "png"
    std::string pixel_format;               ///< FFmpeg's name: "yuv420p"
    ColorMatrix color;                      ///< of Layout::planar
    std::string transfer, primaries, scan;  ///< of its light, in words, and what is done with it; empty: not said
    bool interlaced = false;                ///< some frames may be, by the file or its first 4; read deinterlaced
    Turn turn;                              ///< the file asks for it; not applied
    double pixel_aspect = 1.0;              ///< width over height of a pixel; not applied either
    std::vector<double> times;  ///< s, when each frame is shown, from 0, ascending (variable frame rates are kept)
    double duration = 0.0;      ///< s, including the time of the last frame
    std::string warning;        ///< what is unusual about a file that plays; one line, or empty
    std::shared_ptr<const ClipIndex> index;  ///< data of the Decoder, for the next Decoder of the same file

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
    /// Opens a file again without looking through it: `known` is the info() of another Decoder. Throws Error
    /// (bad_input) when the file does not exist or is not a video any more.
    Decoder(const std::filesystem::path& path, Layout layout, const ClipInfo& known);
    Decoder(Decoder&&) noexcept;
    Decoder& operator=(Decoder&&) noexcept;
    ~Decoder();

    const ClipInfo& info() const;
    PictureFormat format() const;
    /// Decodes all frames, in order. Throws work::Stopped.
    DecodableFrames count_decodable(const work::Stages& stages);
    /// Pictures have this size from now on, whatever the size of the file.
    void scale_to(glm::ivec2 size);

    /// Frame `index` (0 .. frame_count - 1) into `into`. The next frame, or a step forward by a few, decodes those
    /// frames; any other jump seeks. A frame that cannot be had (corrupt, missing, of another size that cannot be
    /// scaled) is the last good one before it, or black, and then the answer is false. If given, `stop` ends a long
    /// search early: then the answer is false and `into` is unchanged. Throws nothing and never opens another file.
    bool read(int index, Picture& into, const std::atomic<bool>* stop = nullptr) noexcept;
    /// The same into memory of format().bytes(), which is written once, in order, and not read.
    bool read(int index, std::span<std::uint8_t> into, const std::atomic<bool>* stop = nullptr) noexcept;

    /// Closes the file and frees the memory of decoding, 10 to 13 frames. The next read() opens it again; if another
    /// file has its name by then, or none, it gives no frames.
    void rest() noexcept;
    bool rests() const;

    /// Time spent since construction in decoding and converting, and in copying into pictures, s.
    double decode_seconds() const;
    double copy_seconds() const;
    /// Packets decoded since the file was opened: the work of reading, whatever the machine. 0 for a sequence of
    /// images.
    std::int64_t decoded_packets() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

/// Opens and looks through the file. If given, `stop` ends that early with Error (runtime).
Decoder open_stoppable(const std::filesystem::path& path, Layout layout, int maximum_frames,
                       const std::atomic<bool>* stop);

}  // namespace lapfx::media
