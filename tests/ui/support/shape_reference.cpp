#include "ui/support/shape_reference.h"

namespace lapfx::ui::test {

namespace {

struct Ink {
    glm::dvec4 color{0};  // premultiplied, 0..1
    double coverage = 0;
};

glm::dvec4 premultiplied(Color c) {
    const double a = c.a / 255.0;
    return {c.r / 255.0 * a, c.g / 255.0 * a, c.b / 255.0 * a, a};
}

Color color_at(const Instance& instance, int at) {
    const unsigned low = instance.uv[at], high = instance.uv[at + 1];
    return {static_cast<std::uint8_t>(low & 255), static_cast<std::uint8_t>(low >> 8),
            static_cast<std::uint8_t>(high & 255), static_cast<std::uint8_t>(high >> 8)};
}

/// The signed distance, px, from a point to the outline of a rectangle with rounded corners; negative inside.
double distance_to_box(glm::dvec2 p, const Instance& box, double radius) {
    const glm::dvec2 low(box.x + radius, box.y + radius), high(box.x + box.w - radius, box.y + box.h - radius);
    const glm::dvec2 nearest = glm::clamp(p, low, high);
    if (nearest != p) return glm::distance(p, nearest) - radius;
    return -std::min({p.x - low.x, high.x - p.x, p.y - low.y, high.y - p.y}) - radius;
}

double distance_to_segment(glm::dvec2 p, glm::dvec2 a, glm::dvec2 b) {
    const double length = glm::dot(b - a, b - a);
    const double along = length > 0 ? std::clamp(glm::dot(p - a, b - a) / length, 0.0, 1.0) : 0;
    return glm::distance(p, a + along * (b - a));
}

double covered(double distance) {
    return std::clamp(0.5 - distance, 0.0, 1.0);
}

Ink fill(const Instance& i, glm::dvec2 p) {
    const double radius = std::min({static_cast<double>(i.radius), i.w / 2.0, i.h / 2.0});
    const double outer = distance_to_box(p, i, radius);
    const glm::dvec4 color = premultiplied(i.color);
    if (i.border == 0) return {color, covered(outer)};
    const double inside = covered(outer + i.border), frame = covered(outer) - inside;
    if (i.uv[2] == 0) return {color, frame};
    const glm::dvec4 under = premultiplied(color_at(i, 0));
    return {frame * (color + under * (1 - color.a)) + inside * under, 1};
}

Ink ink_of(const Instance& i, glm::dvec2 p) {
    const bool within = p.x >= i.x && p.y >= i.y && p.x < i.x + i.w && p.y < i.y + i.h;
    switch (i.kind) {
        case InstanceKind::fill:
            return fill(i, p);
        case InstanceKind::line:
            return {premultiplied(i.color), covered(distance_to_segment(p, {i.x, i.y}, {i.w, i.h}) - i.uv[0] / 128.0)};
        case InstanceKind::gradient: {
            const double along = i.uv[2] == 1 ? (p.y - i.y) / i.h : (p.x - i.x) / i.w;
            return {glm::mix(premultiplied(i.color), premultiplied(color_at(i, 0)), along), within ? 1.0 : 0.0};
        }
        case InstanceKind::checker: {
            const auto column = static_cast<int>((p.x - i.x) / i.uv[0]), row = static_cast<int>((p.y - i.y) / i.uv[0]);
            return {premultiplied((column + row) % 2 == 0 ? i.color : color_at(i, 2)), within ? 1.0 : 0.0};
        }
        case InstanceKind::shadow: {
            const double radius = std::min({static_cast<double>(i.radius), i.w / 2.0, i.h / 2.0});
            const double outside = std::clamp(distance_to_box(p, i, radius) / std::max(1, int{i.uv[0]}), 0.0, 1.0);
            return {premultiplied(i.color), 1 - outside * outside * (3 - 2 * outside)};
        }
        default:
            return {};
    }
}

void blend(cv::Vec4b& pixel, const Ink& ink) {
    const glm::dvec4 over = ink.color * ink.coverage;
    for (int i = 0; i < 4; ++i) {
        pixel[i] = cv::saturate_cast<std::uint8_t>(over[i] * 255 + pixel[i] * (1 - over.a));
    }
}

}  // namespace

Picture reference_picture(const DrawList& list) {
    Picture picture(list.size.y, list.size.x, cv::Vec4b(0, 0, 0, 255));
    for (const Clear& clear : list.clears) {
        for (int y = 0; y < picture.rows; ++y) {
            for (int x = 0; x < picture.cols; ++x) {
                if (clear.rect.contains({static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F})) {
                    picture(y, x) = {clear.color.r, clear.color.g, clear.color.b, 255};
                }
            }
        }
    }
    for (const Batch& batch : list.batches) {
        for (std::uint32_t at = batch.first; at < batch.first + batch.count; ++at) {
            const Rect& clip = list.clips[batch.first_clip + list.instances[at].clip];
            for (int y = 0; y < picture.rows; ++y) {
                for (int x = 0; x < picture.cols; ++x) {
                    const glm::vec2 p(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F);
                    if (clip.contains(p)) blend(picture(y, x), ink_of(list.instances[at], p));
                }
            }
        }
    }
    return picture;
}

}  // namespace lapfx::ui::test
