#include "support/seen_part.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <glm/glm.hpp>
#include <limits>
#include <stdexcept>
#include <string>

namespace lapfx::test {

namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr int side = 640;           // pixels of the square picture in which triangles are looked for
constexpr double half_side = 1.15;  // of half of the camera's height: its view is round, and this is around it
constexpr double mm_per_unit = 1000.0;
constexpr double nearest = 1.0;  // mm before the camera; what comes nearer hides nothing
constexpr int rings = 1;         // of triangles around those that are seen, which hides the edges of holes

glm::dvec3 vector_of(const nlohmann::json& json) {
    return {json.at(0).get<double>(), json.at(1).get<double>(), json.at(2).get<double>()};
}

/// A picture of numbers of triangles, the nearest of each pixel.
class NumbersPicture {
  public:
    explicit NumbersPicture(const nlohmann::json& camera)
        : eye_(vector_of(camera.at("eye"))),
          forward_(glm::normalize(vector_of(camera.at("target")) - eye_)),
          right_(glm::normalize(glm::cross(forward_, vector_of(camera.at("up"))))),
          up_(glm::cross(right_, forward_)),
          scale_(0.5 * side / (half_side * std::tan(glm::radians(0.5 * camera.at("field_of_view").get<double>())))) {}

    void draw(std::size_t number, const std::array<glm::dvec3, 3>& corners) {
        std::array<glm::dvec3, 3> p;  // pixels; one over the distance
        for (std::size_t i = 0; i < 3; ++i) {
            const glm::dvec3 d = corners[i] - eye_;
            const double far = glm::dot(d, forward_);
            if (far < nearest) return;
            p[i] = {0.5 * side + scale_ * glm::dot(d, right_) / far, 0.5 * side + scale_ * glm::dot(d, up_) / far,
                    1.0 / far};
        }
        const auto cross = [](glm::dvec3 a, glm::dvec3 b, double x, double y) {
            return (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
        };
        const double area = cross(p[0], p[1], p[2].x, p[2].y);
        if (area == 0.0) return;
        const auto pixel = [](double at) { return std::clamp(static_cast<int>(std::floor(at)), 0, side - 1); };
        const auto [left, right] = std::minmax({p[0].x, p[1].x, p[2].x});
        const auto [bottom, top] = std::minmax({p[0].y, p[1].y, p[2].y});
        for (int y = pixel(bottom); y <= pixel(top); ++y)
            for (int x = pixel(left); x <= pixel(right); ++x) {
                const double a = cross(p[1], p[2], x + 0.5, y + 0.5) / area,
                             b = cross(p[2], p[0], x + 0.5, y + 0.5) / area;
                if (a < 0.0 || b < 0.0 || a + b > 1.0) continue;
                const double near = a * p[0].z + b * p[1].z + (1.0 - a - b) * p[2].z;
                Pixel& there = pixels_[static_cast<std::size_t>(y * side + x)];
                if (near > there.near) there = {.near = near, .number = number};
            }
    }
    /// Whether each of so many triangles is seen.
    std::vector<bool> seen(std::size_t count) const {
        std::vector<bool> result(count, false);
        for (const Pixel& pixel : pixels_)
            if (pixel.near > 0.0) result[pixel.number] = true;
        return result;
    }

  private:
    struct Pixel {
        double near = 0.0;
        std::size_t number = 0;
    };
    glm::dvec3 eye_, forward_, right_, up_;
    double scale_;
    std::vector<Pixel> pixels_ = std::vector<Pixel>(std::size_t{side} * side);
};

/// A part of the organ: its triangles and where their corners are.
struct Part {
    const nlohmann::json* primitive;
    std::vector<std::uint32_t> indices = {};
    std::vector<glm::dvec3> positions = {};  // mm
};

template <class Value>
std::vector<Value> values_of(const Bytes& bytes) {
    std::vector<Value> values(bytes.size() / sizeof(Value));
    std::memcpy(values.data(), bytes.data(), values.size() * sizeof(Value));
    return values;
}

template <class Value>
Bytes bytes_of(const std::vector<Value>& values) {
    Bytes bytes(values.size() * sizeof(Value));
    std::memcpy(bytes.data(), values.data(), bytes.size());
    return bytes;
}

constexpr int of_16_bits = 5123;  // glTF's componentType

struct Glb {
    nlohmann::json& json;
    std::vector<Bytes>& views;

    nlohmann::json& accessor(const nlohmann::json& number) {
        return json.at("accessors").at(number.get<std::size_t>());
    }
    Bytes& bytes(const nlohmann::json& number) {
        return views.at(accessor(number).at("bufferView").get<std::size_t>());
    }
    Part part_of(const nlohmann::json& primitive) {
        Part part{.primitive = &primitive};
        const nlohmann::json &indices = primitive.at("indices"), &positions = primitive.at("attributes").at("POSITION");
        if (accessor(indices).at("componentType") == of_16_bits)
            for (const std::uint16_t index : values_of<std::uint16_t>(bytes(indices))) part.indices.push_back(index);
        else
            part.indices = values_of<std::uint32_t>(bytes(indices));
        part.indices.resize(accessor(indices).at("count").get<std::size_t>());
        for (const glm::vec3& at : values_of<glm::vec3>(bytes(positions)))
            part.positions.push_back(mm_per_unit * glm::dvec3(at));
        return part;
    }
    /// Only these vertices, in this order.
    void take(const nlohmann::json& number, const std::vector<std::uint32_t>& vertices) {
        nlohmann::json& about = accessor(number);
        Bytes& all = bytes(number);
        const std::size_t stride = all.size() / about.at("count").get<std::size_t>();
        Bytes taken;
        for (const std::uint32_t vertex : vertices)
            taken.insert(taken.end(), all.begin() + static_cast<std::ptrdiff_t>(vertex * stride),
                         all.begin() + static_cast<std::ptrdiff_t>((vertex + 1) * stride));
        all = taken;
        about["count"] = vertices.size();
    }
    void write(const Part& part, const std::vector<bool>& kept) {
        std::vector<std::uint32_t> indices, vertices,
            renamed(part.positions.size(), std::numeric_limits<std::uint32_t>::max());
        for (std::size_t i = 0; i < part.indices.size(); ++i) {
            if (!kept[i / 3]) continue;
            std::uint32_t& name = renamed[part.indices[i]];
            if (name == std::numeric_limits<std::uint32_t>::max()) {
                name = static_cast<std::uint32_t>(vertices.size());
                vertices.push_back(part.indices[i]);
            }
            indices.push_back(name);
        }
        const nlohmann::json& number = part.primitive->at("indices");
        accessor(number)["count"] = indices.size();
        if (accessor(number).at("componentType") == of_16_bits)
            bytes(number) = bytes_of(std::vector<std::uint16_t>(indices.begin(), indices.end()));
        else
            bytes(number) = bytes_of(indices);
        for (const auto& attribute : part.primitive->at("attributes")) take(attribute, vertices);
        nlohmann::json& about = accessor(part.primitive->at("attributes").at("POSITION"));
        const auto places = values_of<glm::vec3>(bytes(part.primitive->at("attributes").at("POSITION")));
        glm::vec3 low = places.at(0), high = places.at(0);
        for (const glm::vec3& at : places) low = glm::min(low, at), high = glm::max(high, at);
        about["min"] = {low.x, low.y, low.z}, about["max"] = {high.x, high.y, high.z};
    }
};

/// Adds the triangles that share a vertex with those that are kept.
void grow(const Part& part, std::vector<bool>& kept) {
    std::vector<bool> used(part.positions.size(), false);
    for (std::size_t i = 0; i < part.indices.size(); ++i)
        if (kept[i / 3]) used[part.indices[i]] = true;
    for (std::size_t i = 0; i < part.indices.size(); ++i)
        if (used[part.indices[i]]) kept[i / 3] = true;
}

}  // namespace

void keep_seen_part(nlohmann::json& glb, std::vector<Bytes>& views, const nlohmann::json& scene) {
    if (glb.at("accessors").size() + glb.at("images").size() != views.size())
        throw std::runtime_error("accessors of the organ share buffer views");
    for (const nlohmann::json& node : glb.at("nodes"))
        for (const char* transform : {"matrix", "translation", "rotation", "scale"})
            if (node.contains(transform)) throw std::runtime_error("a node of the organ has a transform");
    Glb file{.json = glb, .views = views};
    std::vector<Part> parts;
    for (const nlohmann::json& mesh : glb.at("meshes"))
        for (const nlohmann::json& primitive : mesh.at("primitives")) parts.push_back(file.part_of(primitive));

    NumbersPicture picture(scene.at("camera"));
    std::size_t count = 0;
    for (const Part& part : parts)
        for (std::size_t i = 0; i < part.indices.size(); i += 3)
            picture.draw(count++, {part.positions.at(part.indices[i]), part.positions.at(part.indices[i + 1]),
                                   part.positions.at(part.indices[i + 2])});
    const std::vector<bool> seen = picture.seen(count);
    auto begin = seen.begin();
    for (const Part& part : parts) {
        const auto end = begin + static_cast<std::ptrdiff_t>(part.indices.size() / 3);
        std::vector<bool> kept(begin, end);
        for (int i = 0; i < rings; ++i) grow(part, kept);
        if (std::find(kept.begin(), kept.end(), true) == kept.end()) kept.at(0) = true;
        file.write(part, kept);
        begin = end;
    }
}

}  // namespace lapfx::test
