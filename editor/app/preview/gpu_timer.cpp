#include "app/preview/gpu_timer.h"

#include <glad/gl.h>

namespace lapfx::app {

GpuTimer::~GpuTimer() {
    if (queries_[0] != 0) glDeleteQueries(static_cast<GLsizei>(count), queries_.data());
}

void GpuTimer::begin() {
    if (queries_[0] == 0) glCreateQueries(GL_TIME_ELAPSED, static_cast<GLsizei>(count), queries_.data());
    if (pending_[next_]) return;  // the GPU is far behind: this one is not timed
    glBeginQuery(GL_TIME_ELAPSED, queries_[next_]);
    running_ = true;
}

void GpuTimer::end() {
    if (!running_) return;
    running_ = false;
    glEndQuery(GL_TIME_ELAPSED);
    pending_[next_] = true;
    next_ = (next_ + 1) % count;
}

double GpuTimer::seconds() {
    constexpr double weight = 0.2;  // a new measurement has this share in the mean
    for (std::size_t i = 0; i < count; ++i) {
        if (!pending_[i]) continue;
        GLuint ready = GL_FALSE;
        glGetQueryObjectuiv(queries_[i], GL_QUERY_RESULT_AVAILABLE, &ready);
        if (ready == GL_FALSE) continue;
        GLuint64 nanoseconds = 0;
        glGetQueryObjectui64v(queries_[i], GL_QUERY_RESULT, &nanoseconds);
        pending_[i] = false;
        const double seconds = static_cast<double>(nanoseconds) * 1e-9;
        mean_ = mean_ == 0 ? seconds : mean_ + weight * (seconds - mean_);
    }
    return mean_;
}

}  // namespace lapfx::app
