// What was counted in each measured frame of a video, packed: some kilobytes a frame, so that it can be drawn over the
// video while that plays.
//
//     frames.add(CountedFrames::pack(estimator, amounts));   // as each frame is measured
//     frames.draw(time, picture);
//
// Not synchronised; pack() on any thread.
#pragma once

#include <cstdint>
#include <vector>

#include "match/frame/estimator.h"

namespace lapfx::app {

class CountedFrames {
  public:
    struct Frame {
        double time = 0;                               ///< s of the video
        std::vector<std::uint8_t> blood, veil, valid;  ///< PNG; empty: not measurable
    };
    /// Of the frame that the estimator has measured last.
    static Frame pack(const match::Estimator* estimator, const match::FrameAmounts& amounts);

    /// After all that are there.
    void add(Frame frame);
    bool has(double time) const { return find(time) != nullptr; }
    /// Over the frame of that time, at its own size. False: it is not there.
    bool draw(double time, Image& picture) const;
    std::size_t size() const { return frames_.size(); }
    std::size_t memory() const { return memory_; }  ///< bytes

  private:
    const Frame* find(double time) const;
    std::vector<Frame> frames_;
    std::size_t memory_ = 0;
};

}  // namespace lapfx::app
