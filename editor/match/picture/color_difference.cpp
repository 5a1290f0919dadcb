#include "match/picture/color_difference.h"

#include <cmath>
#include <opencv2/imgproc.hpp>

#include "match/picture/colors.h"

namespace lapfx::match {

namespace {

constexpr double turn = 360.0, half_turn = 180.0;  // degrees, as the paper counts hue
// Opposite hues are half a turn apart up to rounding; which way their mean lies must not hang on that.
constexpr double rounding = 1e-9;

using glm::radians;

/// Near 0 of dull colours, near 1 of saturated ones.
double seventh_power_share(double chroma) {
    const double power = std::pow(chroma, 7.0);
    return std::sqrt(power / (power + std::pow(25.0, 7.0)));
}

/// Lightness, chroma and hue (degrees, 0 up to 360; 0 of grey) with a* stretched, so that near grey hue counts less.
struct Polar {
    double lightness, chroma, hue;
};

Polar polar_of(const glm::dvec3& lab, double stretch) {
    const double a = stretch * lab.y, chroma = std::hypot(a, lab.z);
    const double hue = glm::degrees(std::atan2(lab.z, a));
    return {lab.x, chroma, hue < 0.0 ? hue + turn : hue};
}

/// The shorter way from one hue to the other, -180..180.
double hue_step(const Polar& from, const Polar& to) {
    const double step = to.hue - from.hue;
    if (step > half_turn + rounding) return step - turn;
    return step < -half_turn - rounding ? step + turn : step;
}

/// Half way along it. Beside a grey it does not matter: no difference of hue is seen there.
double mean_hue(const Polar& a, const Polar& b) {
    const double sum = a.hue + b.hue;
    if (std::abs(a.hue - b.hue) <= half_turn + rounding) return 0.5 * sum;
    return 0.5 * (sum < turn ? sum + turn : sum - turn);
}

}  // namespace

glm::dvec3 lab_of_linear(const glm::dvec3& linear) {
    const glm::vec3 shown = glm::clamp(glm::vec3(linear), 0.0F, 1.0F);
    const cv::Mat3f one(1, 1, cv::Vec3f(shown.r, shown.g, shown.b));
    cv::Mat3f lab;
    cv::cvtColor(one, lab, cv::COLOR_LRGB2Lab);  // of linear light: of code values OpenCV only interpolates a table
    const cv::Vec3f& found = lab(0, 0);
    return {found[0], found[1], found[2]};
}

glm::dvec3 lab_of(const glm::dvec3& srgb) {
    constexpr float most = 255.0F;
    const glm::vec3 code = most * glm::clamp(glm::vec3(srgb), 0.0F, 1.0F);
    return lab_of_linear({linear_of(code.r), linear_of(code.g), linear_of(code.b)});
}

double delta_e_2000(const glm::dvec3& a, const glm::dvec3& b) {
    const double plain_chroma = 0.5 * (std::hypot(a.y, a.z) + std::hypot(b.y, b.z));
    const double stretch = 1.0 + 0.5 * (1.0 - seventh_power_share(plain_chroma));
    const Polar from = polar_of(a, stretch), to = polar_of(b, stretch);

    const double lightness = 0.5 * (from.lightness + to.lightness), chroma = 0.5 * (from.chroma + to.chroma);
    const double hue = mean_hue(from, to);
    const double hue_weight = 1.0 - 0.17 * std::cos(radians(hue - 30.0)) + 0.24 * std::cos(radians(2.0 * hue)) +
                              0.32 * std::cos(radians(3.0 * hue + 6.0)) - 0.20 * std::cos(radians(4.0 * hue - 63.0));
    const double off_middle = (lightness - 50.0) * (lightness - 50.0);
    const double lightness_unit = 1.0 + 0.015 * off_middle / std::sqrt(20.0 + off_middle);
    const double chroma_unit = 1.0 + 0.045 * chroma, hue_unit = 1.0 + 0.015 * chroma * hue_weight;

    const double of_lightness = (to.lightness - from.lightness) / lightness_unit;
    const double of_chroma = (to.chroma - from.chroma) / chroma_unit;
    const double of_hue =
        2.0 * std::sqrt(from.chroma * to.chroma) * std::sin(radians(0.5 * hue_step(from, to))) / hue_unit;
    // Among saturated blues, chroma and hue are seen together.
    const double off_blue = (hue - 275.0) / 25.0;
    const double rotation =
        -2.0 * seventh_power_share(chroma) * std::sin(radians(60.0 * std::exp(-off_blue * off_blue)));
    return std::sqrt(of_lightness * of_lightness + of_chroma * of_chroma + of_hue * of_hue +
                     rotation * of_chroma * of_hue);
}

}  // namespace lapfx::match
