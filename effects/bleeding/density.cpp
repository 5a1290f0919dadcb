#include "bleeding/density.h"

#include <future>
#include <opencv2/imgproc.hpp>

#include "bleeding/texture_blur.h"
#include "bleeding/tissue_color.h"
#include "lapfx/authoring/srgb.h"
#include "lapfx/authoring/tissue_report.h"

namespace lapfx::bleeding {

namespace {

constexpr double redness_step = 1.0 / 4096;  // finer than 8-bit texels; +-8 fits

/// 8-bit sRGB of a channel after it has been multiplied, in linear light.
cv::Mat multiplied(const glm::vec3& factor) {
    cv::Mat table(1, 256, CV_8UC3);
    for (int i = 0; i < 256; ++i)
        for (int c = 0; c < 3; ++c) {
            const double by = std::isfinite(factor[c]) ? glm::clamp(double(factor[c]), 0.0, 1.0) : 1.0;
            table.at<cv::Vec3b>(0, i)[c] =
                static_cast<std::uint8_t>(std::lround(255.0 * srgb_of_linear(linear_of_srgb(i / 255.0) * by)));
        }
    return table;
}

glm::vec3 factor_of(const Organ& organ, int image) {
    for (const Material& material : organ.materials)
        if (material.base_color_image == image) return glm::vec3(material.base_color);
    return glm::vec3(1.0f);
}

/// A coordinate within the one or two repetitions that differ.
float within(float place, bool any, Wrap wrap) {
    if (!any || wrap == Wrap::clamp) return glm::clamp(place, 0.0f, 1.0f);
    const float period = wrap == Wrap::mirror ? 2.0f : 1.0f;
    return place - period * std::floor(place / period);
}

/// The texel of that number among `count`, where it may lie beyond them.
std::size_t texel_at(int index, int count, bool any, Wrap wrap) {
    if (!any || wrap == Wrap::clamp) return static_cast<std::size_t>(std::clamp(index, 0, count - 1));
    const int period = wrap == Wrap::mirror ? 2 * count : count, inside = (index % period + period) % period;
    return static_cast<std::size_t>(inside < count ? inside : period - 1 - inside);
}

/// A function of a* and b* for every value that they have in 8 bits.
template <class F>
std::vector<float> chroma_table(const F& f) {
    std::vector<float> table(65536);
    for (int a = 0; a < 256; ++a)
        for (int b = 0; b < 256; ++b)
            table[static_cast<std::size_t>(a * 256 + b)] = static_cast<float>(f(a - 128, b - 128));
    return table;
}

/// Two tasks that do not depend on each other.
template <class A, class B>
void side_by_side(const A& a, const B& b) {
    auto other = std::async(std::launch::async, a);
    b();
    other.get();
}

}  // namespace

bool same_maps(const VesselParameters& a, const VesselParameters& b) {
    return a.vessel_low == b.vessel_low && a.vessel_high == b.vessel_high && a.vessel_width == b.vessel_width &&
           a.vessel_color == b.vessel_color && a.vessel_tolerance == b.vessel_tolerance && a.fat_low == b.fat_low &&
           a.fat_high == b.fat_high && a.smoothing == b.smoothing;
}

DensityMap::DensityMap(const Organ& organ, int image)
    : DensityMap(organ, image,
                 std::make_shared<const organ::Pixels>(organ.images[static_cast<std::size_t>(image)], nullptr)) {}

DensityMap::DensityMap(const Organ& organ, int image, std::shared_ptr<const organ::Pixels> pixels) {
    auto source = std::make_shared<Source>();
    source->pixels = std::move(pixels);
    const std::shared_ptr<const Image> known = source->pixels->get();
    source->size = {known->width, known->height};
    source->factor = factor_of(organ, image);
    const std::size_t texels = static_cast<std::size_t>(known->width) * static_cast<std::size_t>(known->height);
    const bool whole = known->pixels.size() == 4 * texels;
    source->tells = whole && !source->of_one_color();
    if (source->tells) {
        source->layout = layout_of(organ, image);
        const std::vector<std::uint8_t> used = std::move(source->layout.used);
        source->used.assign(used.begin(), used.end());
    }
    auto made = std::make_shared<Made>();
    made->values.assign(whole ? texels : 0, Density(0));
    made_ = std::move(made);
    source_ = std::move(source);
}

std::size_t DensityMap::shared_memory() const {
    const std::lock_guard lock(source_->mutex);
    return source_->used.size() / 8 + (source_->newest ? source_->newest->values.size() * sizeof(Density) : 0);
}

std::size_t DensityMap::own_memory() const {
    const std::lock_guard lock(source_->mutex);
    return made_ && made_ != source_->newest ? made_->values.size() * sizeof(Density) : 0;
}

bool DensityMap::Source::of_one_color() const {
    const std::shared_ptr<const Image> image = pixels->get();
    const cv::Mat table = multiplied(factor);
    const std::uint8_t* first = image->pixels.data();
    for (const std::uint8_t *texel = first, *end = first + image->pixels.size(); texel != end; texel += 4)
        for (int c = 0; c < 3; ++c)
            if (table.at<cv::Vec3b>(0, texel[c])[c] != table.at<cv::Vec3b>(0, first[c])[c]) return false;
    return true;
}

DensityMap::Converted DensityMap::Source::convert() const {
    const std::shared_ptr<const Image> image = pixels->get();
    Converted out;
    out.redness.resize(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
    out.lab.resize(out.redness.size());
    const cv::Mat given(image->height, image->width, CV_8UC4, const_cast<std::uint8_t*>(image->pixels.data()));
    cv::Mat rgb, converted;
    cv::cvtColor(given, rgb, cv::COLOR_RGBA2RGB);
    cv::LUT(rgb, multiplied(factor), rgb);
    cv::cvtColor(rgb, converted, cv::COLOR_RGB2Lab);
    std::array<std::int16_t, 256> red, green;
    for (std::size_t i = 0; i < 256; ++i) {
        const double light = linear_of_srgb(static_cast<double>(i) / 255.0), one = 1.0 - least_light;  // log(one) is 0
        red[i] = static_cast<std::int16_t>(std::lround(bleeding::redness(light, one) / redness_step));
        green[i] = static_cast<std::int16_t>(std::lround(bleeding::redness(one, light) / redness_step));
    }
    std::size_t i = 0;
    for (int y = 0; y < size.y; ++y) {
        const cv::Vec3b *colors = rgb.ptr<cv::Vec3b>(y), *found = converted.ptr<cv::Vec3b>(y);
        for (int x = 0; x < size.x; ++x, ++i) {
            out.redness[i] = static_cast<std::int16_t>(red[colors[x][0]] + green[colors[x][1]]);
            out.lab[i] = {found[x][0], found[x][1], found[x][2]};
        }
    }
    return out;
}

void DensityMap::Source::weigh(const Converted& image, cv::Mat& weights, cv::Mat& red) const {
    weights.create(size.y, size.x, CV_32F);
    auto one = used.begin();
    for (int y = 0; y < size.y; ++y)
        for (float *weight = weights.ptr<float>(y), *end = weight + size.x; weight != end; ++weight, ++one)
            *weight = *one ? 1.0f : 0.0f;
    // Mat does not take const data; it only reads it here.
    cv::Mat(size.y, size.x, CV_16S, const_cast<std::int16_t*>(image.redness.data()))
        .convertTo(red, CV_32F, redness_step);
    cv::multiply(red, weights, red);
}

cv::Mat DensityMap::Source::colored(const Converted& image, const cv::Mat& weights, const VesselParameters& p) const {
    const ColorBand band(p.vessel_color, p.vessel_tolerance);
    cv::Mat found(weights.size(), CV_32F);
    cv::parallel_for_(cv::Range(0, size.y), [&](const cv::Range& rows) {
        for (int y = rows.start; y < rows.end; ++y) {
            const glm::u8vec3* color = &image.lab[static_cast<std::size_t>(y) * static_cast<std::size_t>(size.x)];
            for (int x = 0; x < size.x; ++x)
                found.at<float>(y, x) =
                    weights.at<float>(y, x) *
                    static_cast<float>(band({color[x].x * (100.0 / 255), color[x].y - 128.0, color[x].z - 128.0}));
        }
    });
    return found;
}

void DensityMap::set(const VesselParameters& p, const work::Stages& stages) {
    if (!tells()) return;
    {
        const std::lock_guard lock(source_->mutex);
        if (source_->newest && same_maps(source_->newest->of, p)) {
            made_ = source_->newest;
            return;
        }
    }
    made_ = make(p, stages);
    const std::lock_guard lock(source_->mutex);
    source_->newest = made_;
}

std::shared_ptr<const DensityMap::Made> DensityMap::make(const VesselParameters& p, const work::Stages& stages) const {
    const Converted image = source_->convert();
    const TextureLayout& layout = source_->layout;
    const auto texels = [&](double mm) { return mm * layout.texels_per_mm; };
    const cv::Size size(source_->size.x, source_->size.y);
    cv::Mat weights, red;
    source_->weigh(image, weights, red);
    stages.reach(0.1);
    cv::Mat near, around;
    side_by_side([&] { near = TextureBlur(weights, texels(near_share * p.vessel_width), layout.beyond)(red); },
                 [&] { around = TextureBlur(weights, texels(around_share * p.vessel_width), layout.beyond)(red); });
    stages.reach(0.5);

    static const auto blood = chroma_table([](double a, double b) { return bloodiness(a, b); });
    const auto fatty = chroma_table([&](double a, double b) { return fattiness(a, b, p.fat_low, p.fat_high); });
    cv::Mat& vessels = near;
    cv::Mat& fat = red;
    const auto low = static_cast<float>(p.vessel_low);
    const auto scale = static_cast<float>(1.0 / std::max(p.vessel_high - p.vessel_low, 1e-6));
    cv::Mat colored, colored_around;
    if (p.vessel_tolerance > 0.0) {
        colored = source_->colored(image, weights, p);
        colored_around = TextureBlur(weights, texels(around_share * p.vessel_width), layout.beyond)(colored);
    }
    cv::parallel_for_(cv::Range(0, size.height), [&](const cv::Range& rows) {
        for (int y = rows.start; y < rows.end; ++y) {
            float *vessel = vessels.ptr<float>(y), *fatness = fat.ptr<float>(y);
            const float *far = around.ptr<float>(y), *weight = weights.ptr<float>(y);
            const glm::u8vec3* lab = &image.lab[static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width)];
            for (int x = 0; x < size.width; ++x) {
                const auto color = static_cast<std::size_t>(lab[x].y * 256 + lab[x].z);
                float found = std::clamp((vessel[x] - far[x] - low) * scale, 0.0f, 1.0f) * blood[color];
                if (!colored.empty())
                    found =
                        std::max(found, static_cast<float>(ColorBand::standing_out(
                                            double(colored.at<float>(y, x)), double(colored_around.at<float>(y, x)))));
                vessel[x] = found * weight[x];
                fatness[x] = fatty[color] * weight[x];
            }
        }
    });
    const double surface = cv::sum(weights)[0];
    auto made = std::make_shared<Made>();
    made->of = p;
    made->shows_vessels = surface > 0.0 && cv::sum(vessels)[0] >= least_vessels * surface;
    stages.reach(0.6);
    const TextureBlur smooth(weights, texels(p.smoothing), layout.beyond);
    cv::Mat planes[2];
    side_by_side([&] { planes[0] = smooth(vessels); }, [&] { planes[1] = smooth(fat); });
    stages.reach(0.9);
    for (cv::Mat& plane : planes) plane.convertTo(plane, CV_8U, 255.0);
    made->values.resize(image.lab.size());
    cv::Mat both(size, CV_8UC2, made->values.data());
    cv::merge(planes, 2, both);
    return made;
}

void DensityMap::count(const VesselParameters& p, TissueHistogram& histogram) const {
    if (!tells()) return;
    const TextureLayout& layout = source_->layout;
    const cv::Size size(source_->size.x, source_->size.y);
    const Converted image = source_->convert();
    cv::Mat weights, red;
    source_->weigh(image, weights, red);
    const auto blurred = [&](double mm) { return TextureBlur(weights, mm * layout.texels_per_mm, layout.beyond)(red); };
    const cv::Mat near = blurred(near_share * p.vessel_width), around = blurred(around_share * p.vessel_width);
    static const auto hues = chroma_table([](double a, double b) { return hue_of(a, b); });
    static const auto colored = chroma_table([](double a, double b) { return std::hypot(a, b); });
    static const auto blood = chroma_table([](double a, double b) { return bloodiness(a, b); });
    for (int y = 0; y < size.height; ++y) {
        const float *sharp = near.ptr<float>(y), *far = around.ptr<float>(y), *used = weights.ptr<float>(y);
        const glm::u8vec3* lab = &image.lab[static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width)];
        for (int x = 0; x < size.width; ++x) {
            if (used[x] < 0.5f) continue;
            const auto color = static_cast<std::size_t>(lab[x].y * 256 + lab[x].z);
            if (blood[color] > 0.5f) histogram.add_contrast(double(sharp[x]) - double(far[x]));
            if (colored[color] > least_chroma) histogram.add_hue(double(hues[color]));
        }
    }
}

glm::vec2 DensityMap::sample(glm::vec2 uv) const noexcept {
    if (!(std::isfinite(uv.x) && std::isfinite(uv.y)) || values().empty()) return glm::vec2(0.0f);
    const Beyond& beyond = source_->layout.beyond;
    const std::vector<Density>& values = made_->values;
    const glm::ivec2 size = source_->size;
    const glm::vec2 inside(within(uv.x, beyond.any, beyond.u), within(uv.y, beyond.any, beyond.v));
    const glm::vec2 at = inside * glm::vec2(size) - 0.5f;
    const glm::vec2 low = glm::floor(at), part = at - low;
    const auto texel = [&](int x, int y) {
        const std::size_t row = texel_at(static_cast<int>(low.y) + y, size.y, beyond.any, beyond.v);
        const std::size_t column = texel_at(static_cast<int>(low.x) + x, size.x, beyond.any, beyond.u);
        return glm::vec2(values[row * static_cast<std::size_t>(size.x) + column]);
    };
    return glm::mix(glm::mix(texel(0, 0), texel(1, 0), part.x), glm::mix(texel(0, 1), texel(1, 1), part.x), part.y) /
           255.0f;
}

}  // namespace lapfx::bleeding
