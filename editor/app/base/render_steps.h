// Steps of drawing that a thread beside the UI asks the render thread for: each is carried out in a frame of the UI,
// and waited for by whoever asked.
//
//     RenderSteps steps([&jobs] { jobs.wake(); });
//     beside:           if (!steps.carry_out([&] { picture = preview.image(time, size); })) return;  // stopped
//     each UI frame:    steps.serve(8e-3);
//
// No OpenGL of its own.
#pragma once

#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>

namespace lapfx::app {

class RenderSteps {
  public:
    /// `wake`: any thread; a step waits, so the UI has to come to its next frame.
    explicit RenderSteps(std::function<void()> wake) : wake_(std::move(wake)) {}
    RenderSteps(const RenderSteps&) = delete;
    RenderSteps& operator=(const RenderSteps&) = delete;

    /// One thread beside the render thread. Waits until the step has been carried out, and throws what it threw. False:
    /// stop() came before that.
    bool carry_out(const std::function<void()>& step);

    /// Render thread: carries out what waits, and what is asked for next, for about `budget` s.
    void serve(double budget);
    bool waiting() const;  ///< a step is to be carried out
    /// Any thread, for good: carry_out() gives false from now on.
    void stop();

  private:
    std::function<void()> wake_;
    mutable std::mutex mutex_;
    std::condition_variable asked_, done_;
    const std::function<void()>* step_ = nullptr;  ///< that waits
    bool under_way_ = false, stopped_ = false;
    std::exception_ptr thrown_;
};

}  // namespace lapfx::app
