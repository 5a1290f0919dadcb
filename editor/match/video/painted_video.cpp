#include "match/video/painted_video.h"

#include <map>
#include <utility>

#include "lapfx/error.h"
#include "match/video/shots.h"

namespace lapfx::match {

namespace {

std::string place_of(std::size_t stroke) {
    return "/strokes/" + std::to_string(stroke) + "/time";
}

[[noreturn]] void refuse(const BloodStrokes& strokes, const std::string& place, const std::string& reason) {
    throw Error(Failure::bad_input, Fault{.file = strokes.file, .place = strokes.place + place, .reason = reason});
}

Image picture_at(VideoReader& video, int frame, const BloodStrokes& strokes, const std::string& place) {
    Image image;
    if (!video.read(frame, image))
        refuse(strokes, place, "the video cannot give its frame at " + seconds_text(video.time_of(frame)));
    return image;
}

/// What the strokes say of the frame that is compared with: it has no blood if it is the one that they name.
WithoutBlood without_blood(const VideoReader& video, const BloodStrokes& strokes, int clear) {
    for (std::size_t i = 0; i < strokes.strokes.size(); ++i) {
        if (strokes.strokes[i].marks != StrokeMark::blood || video.frame_at(strokes.strokes[i].time) != clear) continue;
        if (strokes.without_blood)
            refuse(strokes, "/without_blood", "stroke " + std::to_string(i) + " marks blood there");
        return WithoutBlood::no;
    }
    return strokes.without_blood ? WithoutBlood::yes : WithoutBlood::maybe;
}

}  // namespace

void check_times(const VideoReader& video, const BloodStrokes& strokes) {
    const auto check = [&](double time, const std::string& place) {
        if (!(time >= 0.0 && time <= video.info().duration))
            refuse(strokes, place,
                   seconds_text(time) + " is outside the video (allowed: 0 to " + seconds_text(video.info().duration) +
                       ")");
    };
    for (std::size_t i = 0; i < strokes.strokes.size(); ++i) check(strokes.strokes[i].time, place_of(i));
    if (strokes.without_blood) check(*strokes.without_blood, "/without_blood");
}

PaintedVideo learn_blood(VideoReader& video, const BloodStrokes& strokes, std::optional<double> baseline,
                         const EstimatorOptions& options) {
    check_times(video, strokes);
    std::map<int, std::vector<std::size_t>> by_frame;
    for (std::size_t i = 0; i < strokes.strokes.size(); ++i)
        by_frame[video.frame_at(strokes.strokes[i].time)].push_back(i);
    if (by_frame.size() > most_painted_frames)
        refuse(strokes, "/strokes",
               "lie over " + std::to_string(by_frame.size()) + " frames (allowed: 1 to " +
                   std::to_string(most_painted_frames) + ")");
    std::vector<PaintedPicture> pictures;
    for (auto& [frame, which] : by_frame)
        pictures.push_back({picture_at(video, frame, strokes, place_of(which.front())), std::move(which)});
    const std::optional<double> time = strokes.without_blood ? strokes.without_blood : baseline;
    Image clear;
    ClearPicture known;
    if (time) {
        const int frame = video.frame_at(*time);
        clear = picture_at(video, frame, strokes, strokes.without_blood ? "/without_blood" : "");
        known = {.picture = &clear, .without_blood = without_blood(video, strokes, frame)};
    }
    const LookedAt part{.region = options.region, .masks = options.masks, .round_view = options.round_view};
    PaintedVideo made{.file = strokes.file,
                      .blood = std::make_shared<const PaintedBlood>(strokes, pictures, known, part),
                      .without_blood = {}};
    if (made.blood->without_blood()) made.without_blood = video.time_of(video.frame_at(*time));
    return made;
}

}  // namespace lapfx::match
