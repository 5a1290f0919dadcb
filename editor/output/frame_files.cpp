#include "output/frame_files.h"

#include <opencv2/core.hpp>
#include <optional>
#include <string_view>
#include <vector>

#include "lapfx/authoring/formats.h"
#include "lapfx/authoring/letters.h"
#include "lapfx/authoring/picture.h"
#include "lapfx/error.h"
#include "output/files.h"
#include "output/kinds.h"

namespace lapfx::output {

namespace fs = std::filesystem;

namespace {

std::size_t hash_of(const cv::Mat& bgr) {
    return std::hash<std::string_view>{}({reinterpret_cast<const char*>(bgr.data), bgr.total() * bgr.elemSize()});
}

/// Where a name has its number: "%04d".
struct NumberPlace {
    std::size_t begin, end;
    bool zeros;          ///< a number that is shorter than `digits` say gets zeros in front; else blanks
    std::string digits;  ///< how long it is at least; may be empty
};

std::optional<NumberPlace> number_in(const std::string& name) {
    const std::size_t begin = name.find('%');
    if (begin == std::string::npos) return std::nullopt;
    const bool zeros = name[begin + 1] == '0';
    const std::size_t digits = begin + (zeros ? 2 : 1);
    const std::size_t end = std::min(name.find_first_not_of("0123456789", digits), name.size());
    if (name[end] != 'd') return std::nullopt;
    return NumberPlace{.begin = begin, .end = end + 1, .zeros = zeros, .digits = name.substr(digits, end - digits)};
}

/// Pictures, which are in a folder of their own until all have been written.
class PngFiles : public FrameFiles {
  public:
    PngFiles(const fs::path& name, glm::ivec2 size, int count)
        : name_(fs::absolute(name)), sequence_(is_sequence_name(name)), size_(size) {
        for (int i = 0; i < count; ++i) require_replaceable(target(i));
        beside_ = std::make_unique<Beside>(name_, Beside::Kind::folder);
    }

    void add(const Image& image) override {
        const int index = static_cast<int>(hashes_.size());
        try {
            write_png(beside(index), image);
        } catch (const Error& error) {  // it names the file that nobody sees
            throw cannot_write(target(index), error.faults().front().reason);
        }
        to_bgr(image, bgr_);
        hashes_.push_back(hash_of(bgr_));
    }

    bool check() override {
        if (checked_ == hashes_.size()) return false;
        const int index = static_cast<int>(checked_);
        if (!same_when_read(index))
            throw cannot_write(target(index), "the picture is not the same when read back; is the disk damaged?");
        ++checked_;
        return true;
    }

    void publish() override {
        for (std::size_t i = 0; i < hashes_.size(); ++i) require_replaceable(target(static_cast<int>(i)));
        for (std::size_t i = 0; i < hashes_.size(); ++i)
            give_name(beside(static_cast<int>(i)), target(static_cast<int>(i)));
        beside_.reset();
    }

  private:
    bool same_when_read(int index) {
        try {
            to_bgr(read_image(beside(index)).image, bgr_);
        } catch (const Error&) {
            return false;
        }
        return bgr_.cols == size_.x && bgr_.rows == size_.y && hash_of(bgr_) == hashes_[checked_];
    }
    fs::path target(int index) const { return sequence_ ? sequence_name(name_, index) : name_; }
    fs::path beside(int index) const { return beside_->path() / target(index).filename(); }

    fs::path name_;
    bool sequence_;
    glm::ivec2 size_;
    std::unique_ptr<Beside> beside_;
    std::vector<std::size_t> hashes_;  ///< each picture has a hash of the pixels that were added
    std::size_t checked_ = 0;
    cv::Mat bgr_;
};

class VideoFrames : public FrameFiles {
  public:
    VideoFrames(const fs::path& name, const FrameFormat& f) : video_(name, f.fps, f.size, f.codec, f.quality) {}
    void add(const Image& image) override { video_.add(image); }
    bool check() override { return video_.check(); }
    void publish() override { video_.publish(); }

  private:
    VideoFile video_;
};

}  // namespace

bool is_sequence_name(const fs::path& path) {
    const std::string name = path.filename().string();
    const std::optional<NumberPlace> number = number_in(name);
    if (!number || number->digits.size() > 2 || name.find('%', number->end) != std::string::npos) return false;
    const std::string ending = name.substr(std::max(number->end, name.size() - std::min<std::size_t>(name.size(), 4)));
    return same_letters(ending, ".png");
}

bool is_picture_name(const fs::path& path) {
    const FileFormat* const format = format_named(path);
    return format != nullptr && format->content == Content::picture && format->written &&
           path.filename().native().find('%') == fs::path::string_type::npos;
}

fs::path sequence_name(const fs::path& pattern, int index) {
    const std::string name = pattern.filename().string();
    const NumberPlace number = number_in(name).value();
    std::string digits = std::to_string(index);
    const std::size_t width = number.digits.empty() ? 0 : std::stoul(number.digits);
    if (digits.size() < width) digits.insert(0, width - digits.size(), number.zeros ? '0' : ' ');
    return pattern.parent_path() / (name.substr(0, number.begin) + digits + name.substr(number.end));
}

std::unique_ptr<FrameFiles> make_png_files(const fs::path& name, const FrameFormat& format) {
    return std::make_unique<PngFiles>(name, format.size, format.count);
}

std::unique_ptr<FrameFiles> make_video_frames(const fs::path& name, const FrameFormat& format) {
    return std::make_unique<VideoFrames>(name, format);
}

std::unique_ptr<FrameFiles> make_frame_files(const fs::path& name, const FrameFormat& format) {
    return row_of(kind_named(name).value()).frames(name, format);
}

}  // namespace lapfx::output
