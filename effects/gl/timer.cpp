#include "gl/timer.h"

namespace lapfx::gl {

void release_query(GLuint name) {
    glDeleteQueries(1, &name);
}

Timer::Timer(bool on) {
    GLint bits = 0;
    if (on) glGetQueryiv(GL_TIME_ELAPSED, GL_QUERY_COUNTER_BITS, &bits);
    on_ = bits > 0;
    if (!on_) return;
    for (auto& name : names_) {
        GLuint query = 0;
        glCreateQueries(GL_TIME_ELAPSED, 1, &query);
        name = Name<release_query>(query);
    }
}

void Timer::begin() noexcept {
    if (!on_) return;
    collect();
    // This span is left out when all queries are still running, or when the host times something itself, because GL
    // allows one at a time.
    GLint current = 0;
    glGetQueryiv(GL_TIME_ELAPSED, GL_CURRENT_QUERY, &current);
    if (current != 0 || begun_ - collected_ == queries) return;
    glBeginQuery(GL_TIME_ELAPSED, names_[begun_ % queries].get());
    running_ = true;
}

void Timer::end() noexcept {
    if (!running_) return;
    glEndQuery(GL_TIME_ELAPSED);
    running_ = false;
    ++begun_;
}

void Timer::collect() noexcept {
    for (; collected_ < begun_; ++collected_) {
        const GLuint query = names_[collected_ % queries].get();
        GLuint ready = 0;
        glGetQueryObjectuiv(query, GL_QUERY_RESULT_AVAILABLE, &ready);
        if (ready == 0) return;
        GLuint64 nanoseconds = 0;
        glGetQueryObjectui64v(query, GL_QUERY_RESULT, &nanoseconds);
        seconds_ += static_cast<double>(nanoseconds) * 1e-9;
        ++spans_;
    }
}

}  // namespace lapfx::gl
