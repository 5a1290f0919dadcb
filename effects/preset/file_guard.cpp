#include "lapfx/authoring/file_guard.h"

#include <sys/stat.h>

#include <algorithm>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <vector>

#include "lapfx/error.h"

namespace lapfx {

namespace fs = std::filesystem;

namespace {

/// What a file is on its disk, whatever it is called.
using Identity = std::pair<dev_t, ino_t>;

std::optional<Identity> identity_of(const fs::path& path) {
    struct stat found {};
    if (::stat(path.c_str(), &found) != 0) return std::nullopt;
    return Identity(found.st_dev, found.st_ino);
}

/// Absolute, and links followed as far as there are any. A path that cannot be followed stays as it was written.
fs::path real_path(const fs::path& path) {
    std::error_code error;
    fs::path real = fs::weakly_canonical(fs::absolute(path, error), error);
    return error ? path.lexically_normal() : real;
}

/// Whether `path` is an image of the pattern, such as frame_0003.png of frame_%04d.png, in the same folder.
bool is_numbered(const fs::path& pattern, const fs::path& path) {
    const std::string form = pattern.filename().string(), name = path.filename().string();
    const std::size_t percent = form.find('%');
    const std::size_t letter =
        percent == std::string::npos ? percent : form.find_first_not_of("0123456789", percent + 1);
    if (letter == std::string::npos || form[letter] != 'd' || pattern.parent_path() != path.parent_path()) return false;
    const std::string before = form.substr(0, percent), after = form.substr(letter + 1);
    if (name.size() <= before.size() + after.size() || !name.starts_with(before) || !name.ends_with(after))
        return false;
    return std::all_of(name.begin() + static_cast<std::ptrdiff_t>(before.size()),
                       name.end() - static_cast<std::ptrdiff_t>(after.size()),
                       [](char c) { return (c >= '0' && c <= '9') || c == ' '; });
}

bool is_pattern(const fs::path& path) {
    return path.filename().native().find('%') != std::string::npos;
}

struct Output {
    std::string option;
    fs::path name, real;  ///< as it was given, and where that is
};

class Register {
  public:
    FileGuard guard = FileGuard::off;

    /// False: it was noted before.
    bool note(const fs::path& real) {
        if (!read_.insert(real).second) return false;
        if (const auto identity = identity_of(real)) by_identity_.emplace(*identity, real);
        if (is_pattern(real)) patterns_.push_back(real);
        return true;
    }
    bool is_read(const fs::path& real) const {
        if (may_be_replaced_.contains(real)) return false;
        if (read_.contains(real)) return true;
        const auto identity = identity_of(real);
        if (!identity) return false;
        // A number of a file that is gone is given to another one, so the file has to be there still.
        const auto [from, to] = by_identity_.equal_range(*identity);
        return std::any_of(from, to, [&](const auto& noted) { return identity_of(noted.second) == identity; }) ||
               std::ranges::any_of(patterns_, [&](const fs::path& pattern) { return is_numbered(pattern, real); });
    }
    void allow(const fs::path& real) { may_be_replaced_.insert(real); }
    /// The output of another option that this is, or one of whose images it is, or that is one of its images.
    const Output* output_of_another(const Output& one) const {
        const auto found = std::ranges::find_if(outputs_, [&](const Output& other) {
            return other.option != one.option &&
                   (other.real == one.real || is_numbered(other.real, one.real) || is_numbered(one.real, other.real));
        });
        return found == outputs_.end() ? nullptr : &*found;
    }
    void claim(Output output) { outputs_.push_back(std::move(output)); }
    const std::vector<Output>& outputs() const { return outputs_; }

  private:
    std::set<fs::path> read_, may_be_replaced_;  // real paths, as all others here
    std::multimap<Identity, fs::path> by_identity_;
    std::vector<fs::path> patterns_;
    std::vector<Output> outputs_;
};

std::mutex mutex;

/// Call with the mutex locked.
Register& all() {
    static Register made;
    return made;
}

Error refused(const std::string& file, const std::string& place, const std::string& reason) {
    return {Failure::bad_input, Fault{.file = file, .place = place, .reason = reason}};
}

Error read_too(const Output& output) {
    return refused("", output.option, '"' + output.name.string() + "\" is a file that is read here");
}

}  // namespace

void guard_files(FileGuard guard) {
    const std::lock_guard lock(mutex);
    all() = {};
    all().guard = guard;
}

void note_read(const fs::path& path) {
    const std::lock_guard lock(mutex);
    if (all().guard == FileGuard::off || path.empty()) return;
    if (!all().note(real_path(path)) || all().guard != FileGuard::refuse) return;
    for (const Output& output : all().outputs())
        if (all().is_read(output.real)) throw read_too(output);
}

void claim_output(const std::string& option, const fs::path& path) {
    const std::lock_guard lock(mutex);
    if (all().guard != FileGuard::refuse) return;
    Output output{.option = option, .name = path, .real = real_path(path)};
    if (all().is_read(output.real)) throw read_too(output);
    if (const Output* const other = all().output_of_another(output))
        throw refused("", option, '"' + path.string() + "\" is the file of " + other->option + ", too");
    all().claim(std::move(output));
}

bool is_read(const fs::path& path) {
    const std::lock_guard lock(mutex);
    return all().guard != FileGuard::off && !path.empty() && all().is_read(real_path(path));
}

void require_not_read(const fs::path& path) {
    {
        const std::lock_guard lock(mutex);
        if (all().guard != FileGuard::refuse) return;
    }
    if (is_read(path)) throw refused(path.string(), "", "is a file that is read here, so it is not written");
}

void allow_rewriting(const fs::path& path) {
    const std::lock_guard lock(mutex);
    all().allow(real_path(path));
}

}  // namespace lapfx
