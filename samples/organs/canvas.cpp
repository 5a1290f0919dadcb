#include "canvas.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

namespace organs {
namespace {

constexpr int gutter = 6;  // texels painted past a patch's edge, so that filtering finds tissue there

/// For every node the direction across the vessel, within the surface, turning smoothly along it.
std::vector<dvec3> sides(const Patch& patch, const VesselTree& tree) {
    std::vector<std::size_t> onward(tree.size());
    for (std::size_t i = 0; i < tree.size(); ++i) onward[i] = i;
    for (std::size_t i = tree.size(); i-- > 0;) {  // the widest child continues
        if (tree[i].parent < 0) continue;
        std::size_t& next = onward[static_cast<std::size_t>(tree[i].parent)];
        if (next == static_cast<std::size_t>(tree[i].parent) || tree[i].radius >= tree[next].radius) next = i;
    }
    std::vector<dvec3> found(tree.size(), dvec3(0.0));
    for (std::size_t i = 0; i < tree.size(); ++i) {
        std::size_t from = i;
        std::size_t to = i;
        for (int k = 0; k < 2; ++k) {
            if (tree[from].parent >= 0) from = static_cast<std::size_t>(tree[from].parent);
            to = onward[to];
        }
        const dvec3 normal = sample(patch, tree[i].uv.x, tree[i].uv.y).vertex.normal;
        const dvec3 side = glm::cross(normal, tree[to].position - tree[from].position);
        const double length = glm::length(side);
        if (length > 1e-9) found[i] = side / length;
    }
    return found;
}

/// The normal in tangent space of a surface whose height changes by `slope` mm over the whole patch along u and v.
dvec3 bent_normal(const SurfacePoint& at, const dvec2& slope) {
    const dvec3 up = glm::cross(at.dv, at.du);
    const double area = glm::dot(up, up);
    if (area < 1e-12) return {0.0, 0.0, 1.0};
    const dvec3 gradient = (slope.x * glm::cross(up, at.dv) + slope.y * glm::cross(at.du, up)) / area;
    const dvec3 normal = glm::normalize(up);
    const dvec3 tangent = glm::normalize(at.du - normal * glm::dot(normal, at.du));
    const dvec3 bitangent = glm::cross(normal, tangent);
    return glm::normalize(dvec3(-glm::dot(gradient, tangent), -glm::dot(gradient, bitangent), 1.0));
}

std::vector<std::uint8_t> jpeg(const cv::Mat& image, int quality) {
    std::vector<std::uint8_t> bytes;
    cv::imencode(".jpg", image, bytes, {cv::IMWRITE_JPEG_QUALITY, quality, cv::IMWRITE_JPEG_OPTIMIZE, 1});
    return bytes;
}

}  // namespace

Canvas::Canvas(int size)
    : size_(size),
      vessels_(size, size, CV_32FC3, cv::Scalar::all(0)),
      color_(size, size, CV_32FC3, cv::Scalar(0.3, 0.35, 0.6)),
      height_(size, size, CV_32F, cv::Scalar::all(0)),
      normal_(size, size, CV_32FC3, cv::Scalar(1, 0, 0)) {}

cv::Rect Canvas::texels(const Patch& patch, int margin) const {
    const int left = static_cast<int>(std::floor(patch.uv_min.x * size_)) - margin;
    const int top = static_cast<int>(std::floor(patch.uv_min.y * size_)) - margin;
    const int right = static_cast<int>(std::ceil(patch.uv_max.x * size_)) + margin;
    const int bottom = static_cast<int>(std::ceil(patch.uv_max.y * size_)) + margin;
    return cv::Rect(left, top, right - left, bottom - top) & cv::Rect(0, 0, size_, size_);
}

dvec2 Canvas::patch_uv(const Patch& patch, int x, int y) const {
    return (dvec2(x + 0.5, y + 0.5) / static_cast<double>(size_) - patch.uv_min) / (patch.uv_max - patch.uv_min);
}

void Canvas::draw(const Patch& patch, const VesselTree& tree, const VesselStyle& style) {
    const std::vector<dvec3> side = sides(patch, tree);
    for (std::size_t i = 0; i < tree.size(); ++i) {
        if (tree[i].parent < 0 || tree[i].radius < style.thinnest) continue;
        const std::size_t parent = static_cast<std::size_t>(tree[i].parent);
        VesselNode from = tree[parent];
        VesselNode to = tree[i];
        from.radius = std::min(from.radius, to.radius * 1.3);
        from.position += side[parent] * (style.aside * from.radius);
        to.position += side[i] * (style.aside * to.radius);
        segment(patch, from, to, style);
    }
}

void Canvas::segment(const Patch& patch, const VesselNode& from, const VesselNode& to, const VesselStyle& style) {
    const SurfacePoint at = sample(patch, to.uv.x, to.uv.y);
    const dvec2 size = (patch.uv_max - patch.uv_min) * static_cast<double>(size_);
    const double texel = 0.5 * (glm::length(at.du) / size.x + glm::length(at.dv) / size.y);  // mm
    const double widest = std::max(from.radius, to.radius) * (style.width + std::abs(style.aside)) + 2.0 * texel;
    const dvec2 reach(widest / std::max(glm::length(at.du), 1e-6) * size.x + 2.0,
                      widest / std::max(glm::length(at.dv), 1e-6) * size.y + 2.0);
    const dvec2 low = glm::min(from.uv, to.uv) * size + patch.uv_min * static_cast<double>(size_) - reach * 1.4;
    const dvec2 high = glm::max(from.uv, to.uv) * size + patch.uv_min * static_cast<double>(size_) + reach * 1.4;
    const cv::Rect box = cv::Rect(cv::Point(static_cast<int>(low.x), static_cast<int>(low.y)),
                                  cv::Point(static_cast<int>(high.x) + 1, static_cast<int>(high.y) + 1)) &
                         texels(patch, gutter);
    const dvec3 along = to.position - from.position;
    const double squared = std::max(glm::dot(along, along), 1e-12);
    for (int y = box.y; y < box.y + box.height; ++y) {
        for (int x = box.x; x < box.x + box.width; ++x) {
            const dvec2 uv = patch_uv(patch, x, y);
            const dvec3 p = sample(patch, uv.x, uv.y).vertex.position;
            const double t = clamp01(glm::dot(p - from.position, along) / squared);
            const double radius = glm::mix(from.radius, to.radius, t) * style.width;
            const double distance = glm::distance(p, from.position + t * along);
            const double soft = 0.35 * radius + 0.7 * texel;
            // Vessels thinner than a texel become fainter, not thinner.
            const double opacity = style.strength * std::min(1.0, radius / (0.45 * texel)) * ramp(0.0, 0.22, radius);
            const double cover = opacity * (1.0 - ramp(radius - 0.5 * soft, radius + 0.8 * soft, distance));
            if (cover <= 0.0) continue;
            cv::Vec3f& found = vessels_.at<cv::Vec3f>(y, x);
            float& share = found[style.vein ? 1 : 0];
            share = std::max(share, static_cast<float>(cover));
            const double round =
                std::sqrt(std::max(0.0, 1.0 - (distance / (1.6 * radius)) * (distance / (1.6 * radius))));
            found[2] = std::max(found[2], static_cast<float>(style.raised * radius * round));
        }
    }
}

void Canvas::paint(const Patch& patch, const Tissue& tissue) {
    const cv::Rect box = texels(patch, gutter);
    for (int y = box.y; y < box.y + box.height; ++y) {
        for (int x = box.x; x < box.x + box.width; ++x) {
            const dvec2 uv = patch_uv(patch, x, y);
            const cv::Vec3f& found = vessels_.at<cv::Vec3f>(y, x);
            const Texel texel = tissue(sample(patch, uv.x, uv.y), {found[0], found[1], found[2]});
            color_.at<cv::Vec3f>(y, x) = cv::Vec3f(static_cast<float>(texel.color.z), static_cast<float>(texel.color.y),
                                                   static_cast<float>(texel.color.x));
            height_.at<float>(y, x) = static_cast<float>(texel.height);
        }
    }
    find_normals(patch, box);
}

void Canvas::find_normals(const Patch& patch, const cv::Rect& box) {
    const dvec2 size = (patch.uv_max - patch.uv_min) * static_cast<double>(size_);
    for (int y = box.y; y < box.y + box.height; ++y) {
        for (int x = box.x; x < box.x + box.width; ++x) {
            const int left = std::max(x - 1, box.x);
            const int right = std::min(x + 1, box.x + box.width - 1);
            const int above = std::max(y - 1, box.y);
            const int below = std::min(y + 1, box.y + box.height - 1);
            const double across = height_.at<float>(y, right) - height_.at<float>(y, left);
            const double down = height_.at<float>(below, x) - height_.at<float>(above, x);
            const dvec2 uv = patch_uv(patch, x, y);
            const dvec2 slope = dvec2(across / (right - left), down / (below - above)) * size;
            const dvec3 normal = bent_normal(sample(patch, uv.x, uv.y), slope);
            normal_.at<cv::Vec3f>(y, x) =
                cv::Vec3f(static_cast<float>(normal.z), static_cast<float>(normal.y), static_cast<float>(normal.x));
        }
    }
}

std::vector<std::uint8_t> Canvas::color_jpeg(int quality) const {
    cv::Mat bytes;
    color_.convertTo(bytes, CV_8UC3, 255.0);
    return jpeg(bytes, quality);
}

std::vector<std::uint8_t> Canvas::normal_jpeg(int size, int quality) const {
    cv::Mat smaller;
    cv::resize(normal_, smaller, cv::Size(size, size), 0, 0, cv::INTER_AREA);
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x)
            smaller.at<cv::Vec3f>(y, x) /= static_cast<float>(cv::norm(smaller.at<cv::Vec3f>(y, x)));
    }
    cv::Mat bytes;
    smaller.convertTo(bytes, CV_8UC3, 127.5, 127.5);
    return jpeg(bytes, quality);
}

}  // namespace organs
