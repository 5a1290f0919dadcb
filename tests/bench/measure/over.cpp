#include "bench/measure/over.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <optional>

#include "bench/measure/composite.h"
#include "commands/session.h"
#include "lapfx/authoring/video.h"
#include "lapfx/error.h"
#include "match/frame/estimator.h"
#include "match/picture/colors.h"
#include "match/picture/instruments.h"
#include "match/picture/view.h"

namespace lapfx::bench {

namespace {

constexpr int longer_side = 256;  // px that frames are laid over at
constexpr double shifted_share = 0.5;
constexpr double noise = 2.0;  // code values, beside that of the real camera
constexpr double veilless = 0.2, least_veil = 0.03, most_veil = 0.8;
constexpr double bloodless = 0.25, least_area = 0.005, most_area = 0.3;
constexpr double soonest = 1.0, latest = 4.0;  // s after the baseline
constexpr double leading_rate = 12.5;          // per s, of the frames that lead to those

/// A frame of the sample plume, 0..1.
cv::Mat draw_plume(Random& random) {
    VideoReader clip(commands::data_folder() / "samples/clips/plume_thick.mp4");
    Image image;
    clip.read(random.below(clip.info().frames), image);
    cv::Mat grey, plume;
    cv::cvtColor(cv::Mat(image.height, image.width, CV_8UC4, image.pixels.data()), grey, cv::COLOR_RGBA2GRAY);
    grey.convertTo(plume, CV_32F, 1.0 / 255.0);
    return plume;
}

cv::Mat code_of(const cv::Mat& linear) {
    cv::Mat code(linear.size(), CV_8UC3);
    const match::QuickCode quick_code;
    for (int y = 0; y < code.rows; ++y)
        for (int x = 0; x < code.cols; ++x)
            for (int k = 0; k < 3; ++k)
                code.at<cv::Vec3b>(y, x)[k] =
                    cv::saturate_cast<std::uint8_t>(quick_code(linear.at<cv::Vec3f>(y, x)[k]));
    return code;
}

/// One file, and what is the same in all pictures over its frames.
class Clip {
  public:
    Clip(const std::filesystem::path& file, Random& random)
        : random_(random), reader_(file), plume_(draw_plume(random)) {
        const glm::ivec2 whole = reader_.info().size;
        const double scale = std::min(1.0, static_cast<double>(longer_side) / std::max(whole.x, whole.y));
        size_ = {std::max(16, static_cast<int>(std::lround(whole.x * scale))),
                 std::max(16, static_cast<int>(std::lround(whole.y * scale)))};
        light_ = composite::draw_light(random, size_);
    }

    const VideoInfo& info() const { return reader_.info(); }
    int frame_at(double time) const { return reader_.frame_at(time); }

    /// Nothing: the file cannot give it.
    std::optional<cv::Mat> frame(int number) {
        Image image;
        if (!reader_.read(number, image)) return {};
        cv::Mat code;
        match::shrink(image, size_, code);
        return code;
    }

    Image clear(const cv::Mat& code) {
        Image image = filmed(random_, code, cv::Scalar::all(1.0), noise);
        compress(random_, image);
        return image;
    }

    /// Blood on the tissue and smoke before it, both by chance.
    KnownPicture composite(const cv::Mat& code) {
        Shown shown{.code = {}, .view = match::view_of(code), .blood = {}, .veil = {}};
        cv::Mat inside, linear;
        cv::blur(shown.view, inside, {3, 3});
        inside.convertTo(inside, CV_32F, 1.0 / 255.0);
        shown.view &= ~match::instruments_of(code, shown.view);
        match::to_linear(code, linear);
        const double area = random_.chance(bloodless) ? 0.0 : random_.log_in(least_area, most_area);
        const cv::Mat film = composite::blood_shape(random_, size_);
        shown.blood =
            composite::lay_blood(linear, composite::thickness_of(film, shown.view, area, random_.in(0.3, 1.0)));
        const double mean = random_.chance(veilless) ? 0.0 : random_.in(least_veil, most_veil);
        shown.veil = composite::veil_of(composite::veil_shape(random_, size_, plume_), shown.view, mean);
        composite::lay_veil(linear, shown.veil.mul(inside), light_);
        shown.code = code_of(linear);
        const Move move = draw_move(random_, shifted_share);
        shown = moved(shown, move, size_);
        KnownPicture picture = known(shown);
        picture.shifted = move.any();
        picture.picture = filmed(random_, shown.code, draw_gains(random_), noise);
        compress(random_, picture.picture);
        return picture;
    }

  private:
    Random& random_;
    VideoReader reader_;
    cv::Size size_;
    cv::Mat plume_, light_;
};

bool measurable(const Image& baseline) {
    try {
        match::Estimator estimator(baseline, {});
        return estimator.measure(baseline, 0.0).measurable();
    } catch (const Error& error) {
        if (error.failure() != Failure::bad_input) throw;
        return false;  // it is black
    }
}

KnownPicture leading(Image picture) {
    KnownPicture made;
    made.picture = std::move(picture);
    made.counted = false;
    return made;
}

struct Taken {
    int frame;
    bool counted;
};

/// Pictures over frames with `baseline` before them. Those that are not counted stay clear: they lead to the others, as
/// the frames of a video do.
void add_view(Clip& clip, int baseline, const std::vector<Taken>& frames, KnownView view, OverCounts& counts,
              std::vector<KnownView>& views) {
    const std::optional<cv::Mat> before = clip.frame(baseline);
    if (!before) {
        ++counts.missing;
        return;
    }
    ++counts.views;
    view.baseline = clip.clear(*before);
    if (!measurable(view.baseline)) {
        ++counts.refused;
        return;
    }
    for (const Taken& taken : frames) {
        const std::optional<cv::Mat> code = taken.frame == baseline ? before : clip.frame(taken.frame);
        if (code && taken.counted) view.pictures.push_back(clip.composite(*code));
        if (code && !taken.counted) view.pictures.push_back(leading(clip.clear(*code)));
        if (!code) ++counts.missing;
    }
    if (!view.pictures.empty()) views.push_back(std::move(view));
}

}  // namespace

std::string operation_of(const std::filesystem::path& file) {
    const std::string name = file.stem().string(),
                      folder = std::filesystem::absolute(file).parent_path().filename().string();
    return folder + "/" + name.substr(0, name.rfind('_'));
}

std::vector<KnownView> known_over(const std::filesystem::path& file, std::uint32_t seed, int number, int composites,
                                  OverCounts& counts) {
    Random random(seed, 3, static_cast<std::uint32_t>(number));
    Clip clip(file, random);
    std::vector<KnownView> views;
    KnownView same{.baseline = {}, .pictures = {}, .labels = {{"operation", operation_of(file)}}, .real = true};
    const int there = random.below(clip.info().frames);
    add_view(clip, there, std::vector<Taken>(static_cast<std::size_t>(composites), {there, true}), same, counts, views);

    // The last frame begins before the end.
    const double end = clip.info().duration - 1.0 / std::max(clip.info().frames_per_second, 1.0);
    if (clip.info().frames < 2 || end < soonest) {
        ++counts.without_later;
        return views;
    }
    KnownView later = same;
    later.moves = later.in_order = true;
    const double start = random.in(0.0, std::max(end - latest, 0.0)), last = std::min(start + latest, end);
    std::vector<Taken> frames;
    double leading = start;
    for (int i = 1; i <= composites; ++i) {
        const double time = start + soonest + (last - start - soonest) * i / composites;
        while ((leading += 1.0 / leading_rate) < time)
            if (const int frame = clip.frame_at(leading); frames.empty() || frames.back().frame != frame)
                frames.push_back({frame, false});
        frames.push_back({clip.frame_at(time), true});
    }
    add_view(clip, clip.frame_at(start), frames, later, counts, views);
    return views;
}

}  // namespace lapfx::bench
