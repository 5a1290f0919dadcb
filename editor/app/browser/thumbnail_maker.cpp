#include "app/browser/thumbnail_maker.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#define XXH_INLINE_ALL
#include <xxhash.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstring>
#include <mutex>

#include "lapfx/authoring/clip.h"
#include "lapfx/authoring/documents.h"
#include "lapfx/authoring/file.h"
#include "lapfx/authoring/formats.h"
#include "lapfx/authoring/picture.h"
#include "lapfx/preset.h"
#include "lapfx/scene.h"

extern char** environ;

namespace lapfx::app {

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr std::size_t longest_text = std::size_t{4} << 20, longest_picture = std::size_t{4} << 20;
constexpr std::chrono::minutes left_over{10};  // what a child was writing: it is no longer there
constexpr std::chrono::milliseconds between_looks{20};
constexpr std::chrono::seconds longest_end{2};  // then the thread hangs, in a file system that is gone
constexpr rlim_t most_seconds = 600;            // of all its threads together: software rendering has many
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool limits_memory = false;  // sanitizers reserve more than there is
#else
constexpr bool limits_memory = true;
#endif

/// The same on every machine and in every version.
class Hash {
  public:
    /// One after the other, so "ab" and "c" are not "a" and "bc".
    void add(std::string_view text) { value_ = XXH3_64bits_withSeed(text.data(), text.size(), value_); }
    /// Which file it is, without reading it.
    void add_file(const fs::path& file) {
        std::error_code error;
        add(file.string());
        add(std::to_string(fs::file_size(file, error)));
        add(std::to_string(fs::last_write_time(file, error).time_since_epoch().count()));
    }
    std::string text() const {
        char buffer[17];
        std::snprintf(buffer, sizeof buffer, "%016llx", static_cast<unsigned long long>(value_));
        return buffer;
    }

  private:
    std::uint64_t value_ = 0;
};

void add_preset(Hash& hash, const fs::path& file, const ThumbnailMaker::Options& options) {
    const std::string text = read_file(file, longest_text);
    hash.add(text);
    const Preset preset = parse_preset(text, file.string(), file.parent_path());
    for (const SmokeClip& clip : preset.smoke.clips)
        hash.add_file(find_clip(clip.file, preset.folder, options.clip_folders));
}

/// `preset`: also the one that it names.
void add_scene(Hash& hash, const fs::path& file, bool preset, const ThumbnailMaker::Options& options) {
    const std::string text = read_file(file, longest_text);
    hash.add(text);
    const Scene scene = parse_scene(text, file.string(), file.parent_path());
    hash.add_file(named_path(scene.folder, scene.organ.file, Reach::anywhere));
    if (!scene.organ.texture.empty()) hash.add_file(named_path(scene.folder, scene.organ.texture, Reach::anywhere));
    if (preset && !scene.preset.empty())
        add_preset(hash, named_path(scene.folder, scene.preset, Reach::anywhere), options);
}

bool is_document(const fs::path& file) {
    return is_named_as(Content::document, file);
}

/// Whether it is shown on the scene of the request, which is asked for by none but presets. Throws Error.
bool on_scene(const ThumbnailMaker::Request& request) {
    return !request.scene.empty() && is_document(request.file) && check_document(request.file).kind == "preset";
}

/// Named after all that its picture depends on. Throws Error.
std::string name_of(const ThumbnailMaker::Request& request, bool on_scene, const ThumbnailMaker::Options& options) {
    Hash hash;
    hash.add(std::to_string(options.size.x) + 'x' + std::to_string(options.size.y));
    if (on_scene) {
        add_preset(hash, request.file, options);
        add_scene(hash, request.scene, false, options);
        hash.add(std::to_string(request.time));
    } else if (is_document(request.file)) {
        check_document(request.file).kind == "preset" ? add_preset(hash, request.file, options)
                                                      : add_scene(hash, request.file, true, options);
    } else {
        hash.add_file(request.file);
    }
    std::error_code error;
    const fs::path program = fs::canonical(options.program, error);
    hash.add_file(error ? options.program : program);
    return hash.text();
}

/// False: it is not a picture, or one that does not fit into `most`.
bool read_picture(const fs::path& file, glm::ivec2 most, ThumbnailMaker::Result& result) {
    std::error_code error;
    if (!fs::is_regular_file(file, error) || fs::file_size(file, error) > longest_picture) return false;
    try {
        Image picture = read_image(file).image;
        if (picture.width > most.x || picture.height > most.y) return false;
        result.size = {picture.width, picture.height};
        result.rgba = std::move(picture.pixels);
        for (std::size_t i = 3; i < result.rgba.size(); i += 4) result.rgba[i] = 255;
        return true;
    } catch (const std::exception&) {
        return false;
    }
}

/// Removes the pictures that were unused for longest, and what an editor that was ended has left. What cannot be listed
/// or removed stays.
void evict(const fs::path& folder) {
    std::error_code error;
    std::vector<std::pair<fs::file_time_type, fs::path>> pictures;
    const fs::file_time_type old = fs::file_time_type::clock::now() - left_over;
    for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
        const fs::path file = it->path();
        const fs::file_time_type used = it->last_write_time(error);
        if (file.extension() == ".log" || file.stem().extension() == ".part") {
            if (used < old) fs::remove(file, error);
        } else if (file.extension() == ".png") {
            pictures.emplace_back(used, file);
        }
    }
    if (pictures.size() <= ThumbnailMaker::most_kept) return;
    std::sort(pictures.begin(), pictures.end());
    for (std::size_t i = 0; i + ThumbnailMaker::most_kept < pictures.size(); ++i) fs::remove(pictures[i].second, error);
}

/// The environment without variables that name a display: the program that renders thumbnails opens no window.
std::vector<char*> environment_without_display() {
    std::vector<char*> all;
    for (char** variable = environ; *variable != nullptr; ++variable) {
        const std::string_view text = *variable;
        if (!text.starts_with("DISPLAY=") && !text.starts_with("WAYLAND_DISPLAY=")) all.push_back(*variable);
    }
    all.push_back(nullptr);
    return all;
}

void limit(pid_t process, decltype(RLIMIT_DATA) what, rlim_t most) {
    rlimit now{};
    if (::prlimit(process, what, nullptr, &now) != 0) return;
    now.rlim_cur = std::min(now.rlim_cur, most);
    ::prlimit(process, what, &now, nullptr);
}

/// 0: it could not be started.
pid_t start(const fs::path& program, std::vector<std::string> arguments, const fs::path& log, int niceness) {
    std::vector<char*> pointers;
    for (std::string& argument : arguments) pointers.push_back(argument.data());
    pointers.push_back(nullptr);
    std::vector<char*> environment = environment_without_display();
    posix_spawn_file_actions_t streams;
    posix_spawn_file_actions_init(&streams);
    posix_spawn_file_actions_addopen(&streams, 0, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&streams, 1, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_addopen(&streams, 2, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_NOFOLLOW, 0600);
    pid_t child = 0;
    const int error = posix_spawn(&child, program.c_str(), &streams, nullptr, pointers.data(), environment.data());
    posix_spawn_file_actions_destroy(&streams);
    if (error != 0) return 0;
    ThumbnailMaker::limit_process(child);
    setpriority(PRIO_PROCESS, static_cast<id_t>(child), niceness);
    return child;
}

std::string first_line(const fs::path& log) {
    try {
        const std::string text = read_file(log, longest_text);
        return text.substr(0, text.find('\n'));
    } catch (const Error&) {
        return {};  // the file says nothing about it
    }
}

}  // namespace

void ThumbnailMaker::limit_process(pid_t process) {
    if (limits_memory) limit(process, RLIMIT_DATA, most_memory);
    limit(process, RLIMIT_CPU, most_seconds);
    limit(process, RLIMIT_CORE, 0);
}

/// Shared with the thread.
struct ThumbnailMaker::Work {
    void run();
    Result make(const Request& request);
    std::string render(const Request& request, bool on_scene, const fs::path& file);
    bool unwanted(const Request& request);

    Options options;
    std::mutex mutex{};
    std::condition_variable changed{};
    std::vector<Request> waiting{};
    Request now{};
    bool working = false, dropped = false, stopping = false, ended = false;
    std::vector<Result> done{};
};

ThumbnailMaker::ThumbnailMaker(Options options)
    : work_(std::make_shared<Work>(std::move(options))), thread_([work = work_] { work->run(); }) {}

ThumbnailMaker::~ThumbnailMaker() {
    std::unique_lock lock(work_->mutex);
    work_->stopping = true;
    work_->waiting.clear();
    work_->changed.notify_all();
    const bool ended = work_->changed.wait_for(lock, longest_end, [this] { return work_->ended; });
    lock.unlock();
    ended ? thread_.join() : thread_.detach();
}

void ThumbnailMaker::want(std::vector<Request> requests) {
    Work& w = *work_;
    {
        const std::lock_guard lock(w.mutex);
        // A child whose picture was dropped is ended. If the picture is wanted again, another child is started.
        const auto running =
            w.working && !w.dropped ? std::find(requests.begin(), requests.end(), w.now) : requests.end();
        w.dropped = w.working && running == requests.end();
        if (running != requests.end()) requests.erase(running);
        w.waiting = std::move(requests);
    }
    w.changed.notify_all();
}

std::vector<ThumbnailMaker::Result> ThumbnailMaker::take() {
    const std::lock_guard lock(work_->mutex);
    return std::exchange(work_->done, {});
}

bool ThumbnailMaker::busy() const {
    const std::lock_guard lock(work_->mutex);
    return work_->working || !work_->waiting.empty();
}

void ThumbnailMaker::finish() {
    std::unique_lock lock(work_->mutex);
    work_->changed.wait(lock, [this] { return !work_->working && work_->waiting.empty(); });
}

void ThumbnailMaker::Work::run() {
    std::unique_lock lock(mutex);
    while (true) {
        changed.wait(lock, [this] { return stopping || !waiting.empty(); });
        if (stopping) break;
        now = waiting.front();
        waiting.erase(waiting.begin());
        working = true;
        dropped = false;
        const Request request = now;
        lock.unlock();
        Result result = make(request);
        lock.lock();
        working = false;
        if (!dropped) done.push_back(std::move(result));
        changed.notify_all();
        if (!dropped && !stopping && options.wake) options.wake();
    }
    ended = true;
    changed.notify_all();
}

ThumbnailMaker::Result ThumbnailMaker::Work::make(const Request& request) {
    Result result{.file = request.file, .size = {}, .rgba = {}, .fault = {}};
    if (options.cache.empty()) return result;
    const fs::path folder = options.cache / "thumbnails";
    std::error_code error;
    try {
        const bool preset = on_scene(request);
        const fs::path file = folder / (name_of(request, preset, options) + ".png");
        if (read_picture(file, options.size, result)) {
            fs::last_write_time(file, fs::file_time_type::clock::now(), error);  // it was used: it is removed last
            return result;
        }
        if (!options.render) return result;
        fs::create_directories(folder, error);
        result.fault = render(request, preset, file);
        if (result.fault.empty() && !read_picture(file, options.size, result))
            result.fault = "what was made is not a picture";
        evict(folder);
    } catch (const Error& failure) {
        result.fault = failure.faults().front().text();
    } catch (const std::exception& failure) {  // no memory
        result.fault = request.file.string() + ": " + failure.what();
    }
    return result;
}

bool ThumbnailMaker::Work::unwanted(const Request& request) {
    std::unique_lock lock(mutex);
    changed.wait_for(lock, between_looks, [&] { return stopping || dropped; });
    return stopping || dropped || now != request;
}

/// Gives what went wrong.
std::string ThumbnailMaker::Work::render(const Request& request, bool on_scene, const fs::path& file) {
    const std::string stem =
        file.stem().string() + '-' + std::to_string(::getpid());  // another editor may make it, too
    const fs::path part = file.parent_path() / (stem + ".part.png"), log = file.parent_path() / (stem + ".log");
    std::vector<std::string> arguments{"lapfx", "picture", request.file.string()};
    if (on_scene)
        arguments = {"lapfx",
                     "render",
                     request.scene.string(),
                     "--preset",
                     request.file.string(),
                     "--at",
                     std::to_string(request.time)};
    arguments.insert(arguments.end(), {"--size", std::to_string(options.size.x) + 'x' + std::to_string(options.size.y),
                                       "-o", part.string()});
    const pid_t child = start(options.program, std::move(arguments), log, options.niceness);
    std::error_code error;
    if (child == 0) {
        fs::remove(log, error);
        return options.program.string() + " cannot be started";
    }
    const Clock::time_point end = Clock::now() + options.longest;
    std::string fault;
    int status = 0;
    while (::waitpid(child, &status, WNOHANG) == 0) {
        const bool late = Clock::now() > end;
        if (!unwanted(request) && !late) continue;
        ::kill(child, SIGKILL);
        ::waitpid(child, &status, 0);
        fault = late ? "the picture took more than " + std::to_string(options.longest.count()) + " s"
                     : std::string("no longer needed");
        break;
    }
    if (fault.empty() && (!WIFEXITED(status) || WEXITSTATUS(status) != 0)) {
        fault = first_line(log);
        if (fault.empty())
            fault = WIFSIGNALED(status) ? "the picture could not be made: the program that makes it crashed"
                                        : "rendering ended without a picture";
    }
    if (fault.empty()) {
        fs::rename(part, file, error);
        if (error) fault = file.string() + ": cannot be written: " + error.message();
    }
    fs::remove(part, error);
    fs::remove(log, error);
    return fault;
}

}  // namespace lapfx::app
