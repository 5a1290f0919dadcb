#include "bench/measure/composite.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "match/frame/film.h"
#include "match/picture/colors.h"

namespace lapfx::bench::composite {

namespace {

constexpr double even_share = 0.2, plume_share = 0.6;
constexpr double wide = 90.0, narrow = 35.0;    // px of noise
constexpr double lobe = 28.0, fine_lobe = 9.0;  // px of noise
constexpr double long_streak = 70.0, thin_streak = 8.0;
constexpr double streaks_share = 0.5;
constexpr double rim_light = 0.7;
constexpr float visible_change = 0.1F, least_light = 1e-4F;  // as Preview::layers

/// 0..1, smooth over so many pixels.
cv::Mat noise(Random& random, cv::Size size, double across, double down) {
    cv::Mat coarse(static_cast<int>(size.height / down) + 4, static_cast<int>(size.width / across) + 4, CV_32F), fine;
    for (int y = 0; y < coarse.rows; ++y)
        for (int x = 0; x < coarse.cols; ++x) coarse.at<float>(y, x) = static_cast<float>(random.in(0.0, 1.0));
    cv::resize(coarse, fine, {}, across, down, cv::INTER_CUBIC);
    const int left = static_cast<int>(random.in(across, 2.0 * across)),
              top = static_cast<int>(random.in(down, 2.0 * down));
    return cv::max(fine(cv::Rect({left, top}, size)), 0.0F);
}

/// The plume somewhere in the view, in either direction.
cv::Mat placed(Random& random, cv::Size size, const cv::Mat& plume) {
    cv::Mat source, there;
    cv::flip(plume, source, 1);
    if (random.chance(0.5)) source = plume;
    const double scale = random.in(0.8, 1.6) * size.height / plume.rows;
    const cv::Point2f middle(static_cast<float>(plume.cols) / 2.0F, static_cast<float>(plume.rows) / 2.0F);
    cv::Matx23d matrix = cv::getRotationMatrix2D(middle, random.in(-40.0, 40.0), scale);
    matrix(0, 2) += size.width * random.in(0.25, 0.75) - static_cast<double>(middle.x);
    matrix(1, 2) += size.height * random.in(0.3, 0.7) - static_cast<double>(middle.y);
    cv::warpAffine(source, there, matrix, size, cv::INTER_LINEAR, cv::BORDER_CONSTANT);
    return there;
}

cv::Mat dimmed(const cv::Mat& shape, double factor) {
    cv::Mat power;
    cv::exp(shape * -factor, power);
    return 1.0F - power;
}

}  // namespace

cv::Mat veil_shape(Random& random, cv::Size size, const cv::Mat& plume) {
    if (random.chance(even_share)) return {size, CV_32F, cv::Scalar(1.0)};
    const cv::Mat slow = noise(random, size, wide, wide), quick = noise(random, size, narrow, narrow);
    cv::Mat shape = 0.2 + slow + 0.5 * quick;
    if (!plume.empty() && random.chance(plume_share)) shape = 0.5 * shape + 1.5 * placed(random, size, plume);
    return shape;
}

cv::Mat veil_of(const cv::Mat& shape, const cv::Mat& view, double mean) {
    if (mean <= 0.0) return cv::Mat::zeros(shape.size(), CV_32F);
    double low = 0.0, high = 1.0;
    while (high < 1e4 && cv::mean(dimmed(shape, high), view)[0] < mean) high *= 2.0;
    for (int i = 0; i < 40; ++i) {
        const double middle = 0.5 * (low + high);
        (cv::mean(dimmed(shape, middle), view)[0] < mean ? low : high) = middle;
    }
    return dimmed(shape, high);
}

cv::Mat draw_light(Random& random, cv::Size size) {
    const double brightness = random.in(0.55, 0.95);
    const double tint[3] = {1.0, random.in(0.92, 1.0), random.in(0.78, 1.0)};
    cv::Mat light(size, CV_32FC3);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            const double across = (2.0 * x + 1.0) / size.width - 1.0, down = (2.0 * y + 1.0) / size.height - 1.0;
            const double dim = 1.0 - (1.0 - rim_light) * std::min(across * across + down * down, 1.0);
            for (int k = 0; k < 3; ++k)
                light.at<cv::Vec3f>(y, x)[k] = match::linear_of(static_cast<float>(255.0 * brightness * tint[k] * dim));
        }
    return light;
}

void lay_veil(cv::Mat& picture, const cv::Mat& veil, const cv::Mat& light) {
    for (int y = 0; y < picture.rows; ++y)
        for (int x = 0; x < picture.cols; ++x) {
            const float v = veil.at<float>(y, x);
            cv::Vec3f& here = picture.at<cv::Vec3f>(y, x);
            here = here * (1.0F - v) + light.at<cv::Vec3f>(y, x) * v;
        }
}

cv::Mat blood_shape(Random& random, cv::Size size) {
    if (random.chance(streaks_share)) {
        const cv::Mat straight = noise(random, size, long_streak, thin_streak);
        const cv::Point2f middle(static_cast<float>(size.width) / 2.0F, static_cast<float>(size.height) / 2.0F);
        cv::Mat turned;
        cv::warpAffine(straight, turned, cv::getRotationMatrix2D(middle, random.in(0.0, 180.0), 1.0), size,
                       cv::INTER_LINEAR, cv::BORDER_REFLECT_101);
        return turned + 0.6 * noise(random, size, wide, wide);
    }
    const cv::Mat lobes = noise(random, size, lobe, lobe), fine = noise(random, size, fine_lobe, fine_lobe);
    cv::Mat shape = lobes + 0.4 * fine;
    const double x0 = size.width * random.in(0.25, 0.75), y0 = size.height * random.in(0.25, 0.75);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            shape.at<float>(y, x) -= static_cast<float>(3.0 * std::hypot(x - x0, y - y0) / size.height);
    return shape;
}

cv::Mat thickness_of(const cv::Mat& shape, const cv::Mat& view, double area, double deepest) {
    std::vector<float> values;
    for (int y = 0; y < shape.rows; ++y)
        for (int x = 0; x < shape.cols; ++x)
            if (view.at<std::uint8_t>(y, x) != 0) values.push_back(shape.at<float>(y, x));
    cv::Mat film = cv::Mat::zeros(shape.size(), CV_32F);
    const auto bloody = static_cast<std::size_t>(std::lround(area * static_cast<double>(values.size())));
    if (bloody == 0) return film;
    std::sort(values.begin(), values.end(), std::greater<>());
    const float highest = values.front(), edge = values[bloody - 1], rise = std::max(highest - edge, 1e-6F);
    for (int y = 0; y < shape.rows; ++y)
        for (int x = 0; x < shape.cols; ++x) {
            const float here = shape.at<float>(y, x);
            if (view.at<std::uint8_t>(y, x) == 0 || here < edge) continue;
            // A film swells like a drop: fast at its rim.
            const float swell = std::sqrt((here - edge) / rise);
            film.at<float>(y, x) = least_thickness + (static_cast<float>(deepest) - least_thickness) * swell;
        }
    return film;
}

cv::Mat lay_blood(cv::Mat& picture, const cv::Mat& thickness) {
    cv::Mat blood = cv::Mat::zeros(picture.size(), CV_8U);
    for (int y = 0; y < picture.rows; ++y)
        for (int x = 0; x < picture.cols; ++x) {
            const float film = thickness.at<float>(y, x);
            if (film <= 0.0F) continue;
            cv::Vec3f& here = picture.at<cv::Vec3f>(y, x);
            const float light = std::max({here[0], here[1], here[2], least_light});
            float most = 0.0F;
            for (int k = 0; k < 3; ++k) {
                const float passed = here[k] * std::exp2(-match::blood_absorption[k] * film);
                most = std::max(most, here[k] - passed);
                here[k] = passed;
            }
            if (most > visible_change * light) blood.at<std::uint8_t>(y, x) = 255;
        }
    return blood;
}

}  // namespace lapfx::bench::composite
