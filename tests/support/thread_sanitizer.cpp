// In every program of TSan's build: OpenCV works in the calling thread. Debian's gives its parallel loops to TBB; TSan
// does not see what that synchronises, and would call each of them a data race.
namespace cv {
__attribute__((weak)) void setNumThreads(int count);
}

namespace {
__attribute__((constructor)) void work_in_the_calling_thread() {
    if (cv::setNumThreads != nullptr) cv::setNumThreads(1);
}
}  // namespace
