#include "bench/measure/labelled.h"

#include <map>
#include <opencv2/imgproc.hpp>
#include <regex>
#include <set>

#include "bench/measure/over.h"
#include "lapfx/authoring/video.h"
#include "lapfx/error.h"
#include "match/picture/instruments.h"
#include "match/picture/view.h"
#include "output/files.h"

namespace lapfx::bench {

namespace {

constexpr double half_white = 127.0;  // code value: labels that went through a lossy format have soft edges

Error refused(const std::filesystem::path& file, const std::string& reason) {
    return {Failure::bad_input, Fault{.file = file.string(), .place = "", .reason = reason}};
}

Image picture_of(const std::filesystem::path& file) {
    Image image;
    if (VideoReader reader(file); !reader.read(0, image)) throw refused(file, "has no picture");
    return image;
}

/// Numbers of the frames after the baseline, by sequence.
std::map<int, std::set<int>> sequences_of(const std::filesystem::path& folder) {
    static const std::regex named("frame_(0|[1-9][0-9]{0,5})_(0|[1-9][0-9]{0,5})\\.png");
    std::map<int, std::set<int>> found;
    std::error_code error;
    for (auto entry = std::filesystem::directory_iterator(folder, error);
         !error && entry != std::filesystem::directory_iterator(); entry.increment(error)) {
        const std::string name = entry->path().filename().string();
        std::smatch parts;
        if (std::regex_match(name, parts, named)) found[std::stoi(parts[1])].insert(std::stoi(parts[2]));
    }
    if (error) throw refused(folder, error.message());
    return found;
}

KnownPicture labelled(const std::filesystem::path& frame, const std::filesystem::path& labels) {
    Image picture = picture_of(frame);
    const Image label = picture_of(labels);
    const cv::Size size(picture.width, picture.height);
    if (size != cv::Size(label.width, label.height))
        throw refused(labels, "is " + std::to_string(label.width) + "x" + std::to_string(label.height) +
                                  ", where its frame is " + std::to_string(size.width) + "x" +
                                  std::to_string(size.height));
    cv::Mat code, grey;
    output::to_bgr(picture, code);
    output::to_bgr(label, grey);
    cv::cvtColor(grey, grey, cv::COLOR_BGR2GRAY);
    Shown shown{.code = code, .view = match::view_of(code), .blood = grey > half_white, .veil = {}};
    shown.view &= ~(match::instruments_of(code, shown.view) & ~shown.blood);
    shown.veil = cv::Mat::zeros(size, CV_32F);
    KnownPicture made = known(shown);
    made.picture = std::move(picture);
    return made;
}

}  // namespace

std::vector<KnownView> known_labelled(const std::filesystem::path& folder) {
    std::vector<KnownView> views;
    const auto file = [&folder](const char* kind, int sequence, int number) {
        return folder / (std::string(kind) + "_" + std::to_string(sequence) + "_" + std::to_string(number) + ".png");
    };
    for (const auto& [sequence, numbers] : sequences_of(folder)) {
        KnownView view{.baseline = picture_of(file("frame", sequence, 0)),
                       .pictures = {},
                       .labels = {{"operation", operation_of(file("frame", sequence, 0))}},
                       .real = true,
                       .labelled = true,
                       .moves = true,
                       .in_order = true};
        for (const int number : numbers)
            if (number > 0)
                view.pictures.push_back(labelled(file("frame", sequence, number), file("blood", sequence, number)));
        if (!view.pictures.empty()) views.push_back(std::move(view));
    }
    if (views.empty()) throw refused(folder, "has no frames named frame_S_0.png, frame_S_1.png, ...");
    return views;
}

}  // namespace lapfx::bench
