#include "media/clip_file.h"

#include <algorithm>
#include <array>
#include <fstream>

#include "lapfx/authoring/clip.h"
#include "lapfx/authoring/file.h"
#include "lapfx/authoring/file_guard.h"

namespace lapfx::media {

namespace fs = std::filesystem;

namespace {

constexpr int maximum_first = 999;  // number of a sequence's first image
constexpr int maximum_digits = 9;   // digits of a number in a sequence
constexpr int maximum_images = 1'000'000;
constexpr const char* is_directory = "is a folder; a video file is needed";
constexpr const char* not_plain = "is not a plain file";

void require_plain_file(const fs::path& path) {
    std::error_code error;
    const auto status = fs::status(path, error);
    if (!fs::exists(status)) throw bad_clip(path, "no such file");
    if (fs::is_directory(status)) throw bad_clip(path, is_directory);
    if (!fs::is_regular_file(status)) throw bad_clip(path, not_plain);
    if (fs::file_size(path, error) == 0) throw bad_clip(path, "is empty");
}

/// Playlists make FFmpeg open whatever they name, but a clip is one file. All playlists are text and no video is, so
/// text is never passed on: FFmpeg recognises some playlists even behind comments.
void refuse_playlist(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::array<char, 512> head{};
    if (!file.read(head.data(), head.size()) && file.gcount() == 0) throw bad_clip(path, "cannot be read");
    const std::string_view start(head.data(), static_cast<std::size_t>(file.gcount()));
    for (const std::string_view mark : {"#EXTM3U", "ffconcat", "<?xml", "<MPD", "v=0", "[playlist]"})
        if (start.starts_with(mark)) throw bad_clip(path, "is a playlist; a clip is a single video file");
    if (start.starts_with("YUV4MPEG2 ")) return;  // a line of text, then pixels
    const auto printable = [](char c) { return static_cast<unsigned char>(c) >= 0x20 || (c >= '\t' && c <= '\r'); };
    if (std::all_of(start.begin(), start.end(), printable)) throw bad_clip(path, not_decodable);
}

/// The sequence that a name means, without its images; none when it is not the name of a sequence.
std::optional<ImageSequence> parse_pattern(const fs::path& pattern) {
    const std::string name = pattern.filename().string();
    const std::size_t percent = name.find('%');
    if (percent == std::string::npos || name.find('%', percent + 1) != std::string::npos) return std::nullopt;
    ImageSequence sequence{
        .folder = pattern.parent_path(), .before = name.substr(0, percent), .after = "", .digits = 1};
    std::size_t end = percent + 1;
    if (end + 1 < name.size() && name[end] == '0') {
        sequence.digits = name[end + 1] - '0';
        end += 2;
    }
    if (sequence.digits < 1 || sequence.digits > maximum_digits || end >= name.size() || name[end] != 'd')
        return std::nullopt;
    sequence.after = name.substr(end + 1);
    return sequence;
}

bool is_file(const fs::path& path) {
    std::error_code error;
    return fs::is_regular_file(path, error);
}

}  // namespace

Error bad_clip(const fs::path& path, const std::string& reason) {
    return {Failure::bad_input, Fault{.file = path.string(), .place = "", .reason = reason}};
}

void require_clip_file(const fs::path& path) {
    require_plain_file(path);
    refuse_playlist(path);
}

fs::path ImageSequence::file(int index) const {
    std::string number = std::to_string(first + index);
    if (number.size() < static_cast<std::size_t>(digits))
        number.insert(0, static_cast<std::size_t>(digits) - number.size(), '0');
    return folder / (before + number + after);
}

std::optional<ImageSequence> find_sequence(const fs::path& pattern, int maximum) {
    std::error_code error;
    if (fs::exists(pattern, error)) return std::nullopt;
    std::optional<ImageSequence> sequence = parse_pattern(pattern);
    if (!sequence) return std::nullopt;
    while (sequence->first <= maximum_first && !is_file(sequence->file(0))) ++sequence->first;
    while (sequence->count < maximum && is_file(sequence->file(sequence->count))) ++sequence->count;
    if (sequence->count == 0) return std::nullopt;
    note_read(pattern);
    return sequence;
}

std::vector<fs::path> sequence_images(const fs::path& pattern) {
    std::vector<fs::path> images;
    if (const auto sequence = find_sequence(pattern, maximum_images))
        for (int i = 0; i < sequence->count; ++i) images.push_back(sequence->file(i));
    return images;
}

namespace {

/// The path in the preset's own folder. A name in the file of a preset stays inside; an absolute path cannot come from
/// there, so a host or a person has chosen it.
fs::path own_path(const std::string& file, const fs::path& preset_folder) {
    return fs::path(file).is_absolute() ? fs::path(file) : named_path(preset_folder, file, Reach::inside, file);
}

/// Each image of a sequence may be a link.
void require_inside(const ImageSequence& sequence, const std::string& file, const fs::path& preset_folder) {
    if (fs::path(file).is_absolute()) return;
    const fs::path below = fs::path(file).parent_path();
    for (int i = 0; i < sequence.count; ++i)
        named_path(preset_folder, (below / sequence.file(i).filename()).string(), Reach::inside, file);
}

}  // namespace

fs::path find_clip(const std::string& file, const fs::path& preset_folder, std::span<const fs::path> search_path) {
    std::error_code error;
    const fs::path own = own_path(file, preset_folder);
    if (is_file(own)) return own;
    // Something else under the name of a file or a sequence is not played, and the next folder is not tried.
    if (fs::is_directory(own, error)) throw bad_clip(file, is_directory);
    if (fs::exists(own, error)) throw bad_clip(file, not_plain);
    if (const auto sequence = find_sequence(own, maximum_images)) {
        require_inside(*sequence, file, preset_folder);
        return own;
    }
    std::string looked_in = (preset_folder.empty() ? fs::path(".") : preset_folder).string();
    if (fs::path(file).filename() == fs::path(file))
        for (const fs::path& folder : search_path) {
            const fs::path path = named_path(folder, file, Reach::anywhere, file);
            if (is_file(path) || find_sequence(path, 1)) return path;
            looked_in += ", " + (folder.empty() ? fs::path(".") : folder).string();
        }
    throw bad_clip(file, "no such clip; looked in " + looked_in);
}

fs::path clip_path(const std::string& file, const fs::path& preset_folder, std::span<const fs::path> search_path) {
    return fs::absolute(find_clip(file, preset_folder, search_path)).lexically_normal();
}

}  // namespace lapfx::media
