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

/// A file as it is on its disk. Asking for it may take long there, so nobody holds the mutex meanwhile.
struct Place {
    explicit Place(fs::path path) : real(std::move(path)), identity(identity_of(real)) {}
    fs::path real;
    std::optional<Identity> identity;  ///< none: there is no such file
};

/// A pattern such as frame_%04d.png, whose number may have any width.
struct Pattern {
    fs::path folder;
    std::string before, after;  ///< of its number
    friend bool operator==(const Pattern&, const Pattern&) = default;
};

std::optional<Pattern> pattern_of(const fs::path& path) {
    const std::string form = path.filename().string();
    const std::size_t percent = form.find('%');
    if (percent == std::string::npos) return std::nullopt;
    const std::size_t letter = form.find_first_not_of("0123456789", percent + 1);
    if (letter == std::string::npos || form[letter] != 'd') return std::nullopt;
    return Pattern{.folder = path.parent_path(), .before = form.substr(0, percent), .after = form.substr(letter + 1)};
}

/// Whether `path` is an image of the pattern, such as frame_0003.png of frame_%04d.png, in the same folder.
bool is_numbered(const Pattern& pattern, const fs::path& path) {
    const auto& [folder, before, after] = pattern;
    const std::string name = path.filename().string();
    if (name.size() <= before.size() + after.size() || !name.starts_with(before) || !name.ends_with(after))
        return false;
    return path.parent_path() == folder && std::all_of(name.begin() + static_cast<std::ptrdiff_t>(before.size()),
                                                       name.end() - static_cast<std::ptrdiff_t>(after.size()),
                                                       [](char c) { return (c >= '0' && c <= '9') || c == ' '; });
}

bool is_numbered(const fs::path& pattern, const fs::path& path) {
    const std::optional<Pattern> known = pattern_of(pattern);
    return known && is_numbered(*known, path);
}

struct Output {
    std::string option;
    fs::path name, real;  ///< the name as it was given, and the place where that is
};

/// Asks no disk.
class Register {
  public:
    FileGuard guard = FileGuard::off;

    /// False: it was noted before, alone or by a pattern. A long sequence of images is one pattern here.
    bool note(const Place& place) {
        if (is_covered(place.real) || !read_.insert(place.real).second) return false;
        if (place.identity) by_identity_.emplace(*place.identity, place.real);
        if (std::optional<Pattern> pattern = pattern_of(place.real)) patterns_.push_back(std::move(*pattern));
        return true;
    }
    /// Whether it is read by this name. If not, `same` gets the names of the noted files that had its identity.
    bool is_read(const Place& place, std::vector<fs::path>& same) const {
        if (may_be_replaced_.contains(place.real)) return false;
        if (read_.contains(place.real) || has_noted_number(place.real)) return true;
        if (!place.identity) return false;
        if (is_covered(place.real)) return true;
        const auto [from, to] = by_identity_.equal_range(*place.identity);
        for (auto noted = from; noted != to; ++noted) same.push_back(noted->second);
        return false;
    }
    void allow(fs::path real) { may_be_replaced_.insert(std::move(real)); }
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
    bool is_covered(const fs::path& real) const {
        return std::ranges::any_of(patterns_, [&](const Pattern& pattern) { return is_numbered(pattern, real); });
    }
    /// Whether it is a pattern, and one of its images was noted, alone or by a pattern.
    bool has_noted_number(const fs::path& real) const {
        const std::optional<Pattern> pattern = pattern_of(real);
        if (!pattern) return false;
        return std::ranges::find(patterns_, *pattern) != patterns_.end() ||
               std::ranges::any_of(read_, [&](const fs::path& noted) {
                   return is_numbered(*pattern, noted) && !may_be_replaced_.contains(noted);
               });
    }

    std::set<fs::path> read_, may_be_replaced_;  // real paths, as all others here
    std::multimap<Identity, fs::path> by_identity_;
    std::vector<Pattern> patterns_;
    std::vector<Output> outputs_;
};

std::mutex mutex;

/// Call with the mutex locked.
Register& all() {
    static Register made;
    return made;
}

FileGuard current_guard() {
    const std::lock_guard lock(mutex);
    return all().guard;
}

bool is_read(const Place& place) {
    std::vector<fs::path> same;
    {
        const std::lock_guard lock(mutex);
        if (all().is_read(place, same)) return true;
    }
    // A number of a file that is gone is given to another one, so the file has to be there still.
    return std::ranges::any_of(same, [&](const fs::path& noted) { return identity_of(noted) == place.identity; });
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
    if (path.empty() || current_guard() == FileGuard::off) return;
    const Place place(real_path(path));
    std::vector<Output> outputs;
    {
        const std::lock_guard lock(mutex);
        if (all().guard == FileGuard::off || !all().note(place) || all().guard != FileGuard::refuse) return;
        outputs = all().outputs();
    }
    for (const Output& output : outputs)
        if (is_read(Place(output.real))) throw read_too(output);
}

void claim_output(const std::string& option, const fs::path& path) {
    if (current_guard() != FileGuard::refuse) return;
    Output output{.option = option, .name = path, .real = real_path(path)};
    {
        const std::lock_guard lock(mutex);
        if (const Output* const other = all().output_of_another(output))
            throw refused("", option, '"' + path.string() + "\" is the file of " + other->option + ", too");
        all().claim(output);
    }
    // After the claim: what is noted in between is told here or by its reader.
    if (is_read(Place(output.real))) throw read_too(output);
}

bool is_read(const fs::path& path) {
    return !path.empty() && current_guard() != FileGuard::off && is_read(Place(real_path(path)));
}

void require_not_read(const fs::path& path) {
    if (current_guard() != FileGuard::refuse) return;
    if (is_read(path)) throw refused(path.string(), "", "is a file that is read here, so it is not written");
}

void allow_rewriting(const fs::path& path) {
    fs::path real = real_path(path);
    const std::lock_guard lock(mutex);
    all().allow(std::move(real));
}

}  // namespace lapfx
