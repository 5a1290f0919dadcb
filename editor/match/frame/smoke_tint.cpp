#include "match/frame/smoke_tint.h"

#include <algorithm>
#include <vector>

namespace lapfx::match {

namespace {

constexpr double least_veil = 0.1;  // that is seen
constexpr std::size_t least_places = 1000;
// Shares of the view, by how dark its tissue is. The very darkest are noise.
constexpr double darkest_from = 0.02, darkest_to = 0.1, darker_from = 0.05, darker_to = 0.25;
// A known smoke in the sample reference differs by 0.12 between both; frames of another view by 0.3 and more.
constexpr double most_apart = 0.15;
constexpr double least_tint = 0.6, most_tint = 1.6;
constexpr double most_red = 1.2;  // smoke throws back more blue than red: what is redder is tissue

struct Place {
    float tissue;  ///< how bright it is, without smoke
    cv::Vec3f color;
    float veil;
};
using Places = std::vector<Place>;

float brightness(const cv::Vec3f& bgr) {
    return 0.0722F * bgr[0] + 0.7152F * bgr[1] + 0.2126F * bgr[2];
}

void sort(Places& places) {
    std::ranges::stable_sort(places, {}, &Place::tissue);
}

Places smoky_places(const SmokeLayers& layers) {
    constexpr float most_veil = 0.9F;  // behind more, tissue is not told
    Places places;
    for (int y = 0; y < layers.seen.rows; ++y)
        for (int x = 0; x < layers.seen.cols; ++x) {
            const float veil = layers.veil.at<float>(y, x);
            if (layers.valid.at<std::uint8_t>(y, x) == 0 || veil > most_veil) continue;
            const auto& color = layers.seen.at<cv::Vec3f>(y, x);
            const float smoke = veil * brightness(layers.light.at<cv::Vec3f>(y, x));
            places.push_back({(brightness(color) - smoke) / (1.0F - veil), color, veil});
        }
    sort(places);
    return places;
}

Places clear_places(const SmokeLayers& layers) {
    Places places;
    for (int y = 0; y < layers.clear.rows; ++y)
        for (int x = 0; x < layers.clear.cols; ++x) {
            if (layers.valid.at<std::uint8_t>(y, x) == 0) continue;
            const auto& color = layers.clear.at<cv::Vec3f>(y, x);
            places.push_back({brightness(color), color, 0.0F});
        }
    sort(places);
    return places;
}

struct Mean {
    glm::dvec3 color{0.0};
    double veil = 0.0;
};
Mean mean_of(const Places& places, double from, double to) {
    const auto count = static_cast<double>(places.size());
    const auto first = static_cast<std::size_t>(from * count), last = static_cast<std::size_t>(to * count);
    Mean mean;
    for (std::size_t i = first; i < last; ++i) {
        mean.color += glm::dvec3(places[i].color[2], places[i].color[1], places[i].color[0]);
        mean.veil += places[i].veil;
    }
    const auto taken = static_cast<double>(last - first);
    return {mean.color / taken, mean.veil / taken};
}

std::optional<glm::dvec3> tint_between(const Places& seen, const Places& clear, double from, double to) {
    const Mean smoky = mean_of(seen, from, to), tissue = mean_of(clear, from, to);
    if (smoky.veil < least_veil) return {};
    const glm::dvec3 light = smoky.color - (1.0 - smoky.veil) * tissue.color;
    if (std::min({light.r, light.g, light.b}) <= 0.0) return {};
    return light * (3.0 / (light.r + light.g + light.b));
}

}  // namespace

std::optional<glm::dvec3> smoke_tint(const SmokeLayers& layers) {
    const Places smoky = smoky_places(layers), tissue = clear_places(layers);
    if (smoky.size() < least_places) return {};
    const std::optional<glm::dvec3> darkest = tint_between(smoky, tissue, darkest_from, darkest_to),
                                    darker = tint_between(smoky, tissue, darker_from, darker_to);
    if (!darkest || !darker) return {};
    for (int c = 0; c < 3; ++c) {
        if (std::abs((*darkest)[c] - (*darker)[c]) > most_apart) return {};
        if ((*darkest)[c] < least_tint || (*darkest)[c] > most_tint) return {};
    }
    if (darkest->r > most_red) return {};
    return darkest;
}

}  // namespace lapfx::match
