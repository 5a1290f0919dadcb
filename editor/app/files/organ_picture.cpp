#include "app/files/organ_picture.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/color_space.hpp>
#include <limits>

namespace lapfx::app {

namespace {

constexpr double margin = 0.05;                    // share of the picture that stays free on each side
constexpr std::size_t most_triangles = 2'000'000;  // more take too long while one turns it
constexpr double most_pixels = 2e7;                // looked at, of all triangles' boxes: a hundred for each pixel
constexpr glm::dvec3 unlit{0.25}, lit{0.85};       // light of a surface beside the lamp, and towards it
const glm::dvec3 lamp = glm::normalize(glm::dvec3(-0.3, 0.4, 1.0));

class Picture {
  public:
    Picture(const Organ& organ, const glm::dmat3& rotation, glm::ivec2 size) : organ_(organ), size_(size) {
        places_.reserve(organ.positions.size());
        glm::dvec3 low(1e300), high(-1e300);
        for (const glm::vec3& position : organ.positions) {
            places_.push_back(rotation * glm::dvec3(position));
            low = glm::min(low, places_.back()), high = glm::max(high, places_.back());
        }
        const glm::dvec2 room = glm::dvec2(size) * (1 - 2 * margin), extent(high - low);
        made.units_per_pixel = std::max({extent.x / room.x, extent.y / room.y, 1e-12});
        for (glm::dvec3& place : places_) {
            place = (place - 0.5 * (low + high)) / made.units_per_pixel;
            place = {0.5 * size.x + place.x, 0.5 * size.y - place.y, place.z};
        }
        made.image.width = size.x, made.image.height = size.y;
        made.image.pixels.assign(4 * static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y), 0);
        depth_.assign(made.image.pixels.size() / 4, -std::numeric_limits<double>::infinity());
    }

    void draw() {
        const std::size_t step = 1 + organ_.triangle_count() / most_triangles;
        for (const Part& part : organ_.parts)
            for (std::uint32_t i = 0; i + 2 < part.index_count; i += 3 * static_cast<std::uint32_t>(step))
                triangle(part, part.first_index + i);
    }

    OrganPicture made;

  private:
    void triangle(const Part& part, std::uint32_t first) {
        const std::uint32_t* const corner = organ_.indices.data() + first;
        const glm::dvec3 &a = places_[corner[0]], &b = places_[corner[1]], &c = places_[corner[2]];
        const double area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
        if (!(std::abs(area) > 1e-12)) return;
        const glm::dvec3 normal = glm::normalize(glm::cross(b - a, c - a)) * glm::dvec3(1, -1, 1);
        const double facing = std::abs(glm::dot(normal * (normal.z < 0 ? -1.0 : 1.0), lamp));
        const glm::dvec3 light = glm::mix(unlit, lit, facing);
        const auto between = [](double low, double high, int most) {
            return std::pair(std::clamp(static_cast<int>(std::floor(low)), 0, most),
                             std::clamp(static_cast<int>(std::ceil(high)), 0, most));
        };
        const auto [left, right] = between(std::min({a.x, b.x, c.x}), std::max({a.x, b.x, c.x}), size_.x);
        const auto [top, bottom] = between(std::min({a.y, b.y, c.y}), std::max({a.y, b.y, c.y}), size_.y);
        looked_at_ += double(right - left) * double(bottom - top);
        if (looked_at_ > most_pixels) return;
        for (int y = top; y < bottom; ++y) {
            for (int x = left; x < right; ++x) {
                const double px = x + 0.5, py = y + 0.5;
                const double u = ((b.x - px) * (c.y - py) - (b.y - py) * (c.x - px)) / area;
                const double v = ((c.x - px) * (a.y - py) - (c.y - py) * (a.x - px)) / area;
                const double w = 1 - u - v;
                if (u < 0 || v < 0 || w < 0) continue;
                const double z = u * a.z + v * b.z + w * c.z;
                const std::size_t at =
                    static_cast<std::size_t>(y) * static_cast<std::size_t>(size_.x) + static_cast<std::size_t>(x);
                if (z <= depth_[at]) continue;
                depth_[at] = z;
                put(at, light * color(part, corner, {u, v, w}));
            }
        }
    }

    glm::dvec3 color(const Part& part, const std::uint32_t* corner, const glm::dvec3& weights) const {
        const Material& material = organ_.materials[static_cast<std::size_t>(part.material)];
        glm::dvec3 tint(0);
        glm::dvec2 uv(0);
        for (int i = 0; i < 3; ++i) {
            tint += weights[i] * glm::dvec3(organ_.colors[corner[i]]);
            uv += weights[i] * glm::dvec2(organ_.uvs[corner[i]]);
        }
        tint *= glm::dvec3(material.base_color);
        if (material.base_color_image < 0) return tint;
        const Image& image = organ_.images[static_cast<std::size_t>(material.base_color_image)];
        if (image.pixels.empty()) return tint;
        const glm::dvec2 within = uv - glm::floor(uv);
        const glm::ivec2 size(image.width, image.height);
        const glm::ivec2 at = glm::clamp(glm::ivec2(within * glm::dvec2(size)), glm::ivec2(0), size - 1);
        const std::uint8_t* const p =
            image.pixels.data() +
            4 * (static_cast<std::size_t>(at.y) * static_cast<std::size_t>(size.x) + static_cast<std::size_t>(at.x));
        return tint * glm::convertSRGBToLinear(glm::dvec3(p[0], p[1], p[2]) / 255.0);
    }

    void put(std::size_t at, const glm::dvec3& light) {
        const glm::dvec3 code = 255.0 * glm::convertLinearToSRGB(glm::clamp(light, 0.0, 1.0));
        std::uint8_t* const p = made.image.pixels.data() + 4 * at;
        for (int c = 0; c < 3; ++c) p[c] = static_cast<std::uint8_t>(std::lround(code[c]));
        p[3] = 255;
    }

    const Organ& organ_;
    glm::ivec2 size_;
    std::vector<glm::dvec3> places_;
    std::vector<double> depth_;
    double looked_at_ = 0;
};

}  // namespace

OrganPicture organ_picture(const Organ& organ, const glm::dmat3& rotation, glm::ivec2 size) {
    if (organ.positions.empty()) return {};
    Picture picture(organ, rotation, size);
    picture.draw();
    return std::move(picture.made);
}

}  // namespace lapfx::app
