#include "ui/shell/file_system.h"

#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <system_error>

#include "ui/value/letters.h"

namespace lapfx::ui {

namespace {

class SystemFiles : public FileSystem {
  public:
    std::string list(const std::string& folder, std::vector<FileEntry>& entries) override {
        entries.clear();
        std::error_code error;
        for (std::filesystem::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
            FileEntry entry{.name = at->path().filename().native()};
            struct stat info {
            };  // one call for kind, size and time of thousands of files, where the library makes three
            if (::stat(at->path().c_str(), &info) == 0) {
                entry.folder = S_ISDIR(info.st_mode);
                entry.size = static_cast<std::uint64_t>(info.st_size);
                entry.changed = info.st_mtime;
            }
            entries.push_back(std::move(entry));
        }
        return error ? error.message() : std::string();
    }
    Kind kind(const std::string& path) override {
        struct stat info {};
        if (::stat(path.c_str(), &info) != 0) return Kind::nothing;
        return S_ISDIR(info.st_mode) ? Kind::folder : Kind::file;
    }
    std::string home() override {
        const char* home = std::getenv("HOME");
        return home != nullptr && home[0] == '/' ? resolve_path("/", home) : "/";
    }
    std::vector<FilePlace> places() override { return {{"Home", home()}, {"Computer", "/"}}; }
    std::string make_folder(const std::string& path) override {
        if (::mkdir(path.c_str(), 0777) == 0) return {};  // the user's umask removes some
        if (errno == EEXIST) return "there is a file or folder of this name already";
        return std::generic_category().message(errno);
    }
};

bool digit(char c) {
    return c >= '0' && c <= '9';
}
std::string_view cut_number(std::string_view& text) {
    std::size_t end = 0;
    while (end < text.size() && digit(text[end])) ++end;
    std::string_view number = text.substr(0, end);
    text.remove_prefix(end);
    while (number.size() > 1 && number[0] == '0') number.remove_prefix(1);
    return number;
}

}  // namespace

FileSystem& system_files() {
    static SystemFiles files;
    return files;
}

std::string resolve_path(std::string_view folder, std::string_view path) {
    std::string whole(path.starts_with('/') ? std::string_view() : folder);
    whole.append("/").append(path).append("/");
    std::string clean;
    for (std::size_t at = 0; at < whole.size();) {
        const std::size_t end = whole.find('/', at);
        const std::string_view name = std::string_view(whole).substr(at, end - at);
        at = end + 1;
        if (name == "..") {
            clean.resize(clean.rfind('/') == std::string::npos ? 0 : clean.rfind('/'));
        } else if (!name.empty() && name != ".") {
            clean.append("/").append(name);
        }
    }
    return clean.empty() ? "/" : clean;
}

std::string expand_home(std::string_view path, std::string_view home) {
    const bool at_home = path == "~" || path.starts_with("~/");
    return at_home ? std::string(home).append(path.substr(1)) : std::string(path);
}

std::string_view parent_of(std::string_view path) {
    const std::size_t at = path.rfind('/');
    return at == std::string_view::npos || at == 0 ? "/" : path.substr(0, at);
}

std::string_view name_of_path(std::string_view path) {
    const std::size_t at = path.rfind('/');
    return at == std::string_view::npos ? path : path.substr(at + 1);
}

std::string size_text(std::uint64_t bytes) {
    char text[32];
    if (bytes < 1000) {
        std::snprintf(text, sizeof text, "%d B", static_cast<int>(bytes));
        return text;
    }
    double value = static_cast<double>(bytes) / 1000;
    const char* unit = "k\0M\0G\0T\0P\0E";
    for (; value >= 999.95 && *unit != 'E'; unit += 2) value /= 1000;
    std::snprintf(text, sizeof text, "%.1f %cB", value, *unit);
    return text;
}

void date_text(std::int64_t seconds, std::string& text) {
    const auto time = static_cast<std::time_t>(seconds);
    std::tm parts{};
    char buffer[32] = "";
    if (localtime_r(&time, &parts) != nullptr) std::strftime(buffer, sizeof buffer, "%Y-%m-%d %H:%M", &parts);
    text = buffer;
}

bool natural_less(std::string_view a, std::string_view b) {
    const std::string_view whole_a = a, whole_b = b;
    while (!a.empty() && !b.empty()) {
        if (digit(a[0]) && digit(b[0])) {
            const std::string_view p = cut_number(a), q = cut_number(b);
            if (p.size() != q.size()) return p.size() < q.size();
            if (p != q) return p < q;
            continue;
        }
        const char p = lower(a[0]), q = lower(b[0]);
        if (p != q) return static_cast<unsigned char>(p) < static_cast<unsigned char>(q);
        a.remove_prefix(1), b.remove_prefix(1);
    }
    if (a.size() != b.size()) return a.size() < b.size();
    return whole_a < whole_b;  // they differ only in case or zeros, but need an order
}

}  // namespace lapfx::ui
