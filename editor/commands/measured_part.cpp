#include "commands/measured_part.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>

#include "commands/options.h"
#include "lapfx/authoring/file.h"
#include "lapfx/authoring/file_guard.h"
#include "lapfx/error.h"
#include "lapfx/scene.h"

namespace lapfx::commands {

namespace {

constexpr std::size_t longest_file = 4 << 20;  // bytes
constexpr double slack = 1e-9;
constexpr double least_view_radius = 0.1, most_view_radius = 2.0;  // heights

std::string text_of(glm::ivec2 size) {
    return std::to_string(size.x) + "x" + std::to_string(size.y);
}

/// Numbers with commas between them; nothing if it is something else.
std::optional<std::vector<double>> numbers_of(const std::string& text) {
    std::vector<double> numbers;
    std::stringstream in(text);
    for (std::string cell; std::getline(in, cell, ',');) {
        char* end = nullptr;
        numbers.push_back(std::strtod(cell.c_str(), &end));
        if (cell.empty() || *end != 0 || !std::isfinite(numbers.back())) return {};
    }
    return numbers;
}

bool are_fractions(const std::vector<double>& numbers) {
    return std::all_of(numbers.begin(), numbers.end(), [](double n) { return n <= 1.0; });
}

/// Corners as fractions of the picture; nothing if one is not inside.
std::optional<match::MaskPolygon> part_of(const std::vector<double>& numbers, bool fractions, glm::ivec2 size) {
    const glm::dvec2 whole = fractions ? glm::dvec2(1.0) : glm::dvec2(size);
    match::MaskPolygon part;
    for (std::size_t i = 0; i + 1 < numbers.size(); i += 2) {
        const glm::dvec2 corner = glm::dvec2(numbers[i], numbers[i + 1]) / whole;
        if (corner.x < 0.0 || corner.y < 0.0 || corner.x > 1.0 || corner.y > 1.0) return {};
        part.push_back(corner);
    }
    return part;
}

bool fits_polygon(std::size_t corners) {
    return corners >= 3 && corners <= most_part_corners;
}

std::string polygon_rule() {
    return "x,y of 3 to " + std::to_string(most_part_corners) + " corners";
}

match::MaskPolygon mask_of_corners(const std::string& text, glm::ivec2 size) {
    const auto numbers = numbers_of(text);
    if (!numbers) throw wrong_option("--mask", "\"" + text + "\" is not x,y,x,y,x,y");
    if (numbers->size() % 2 != 0 || !fits_polygon(numbers->size() / 2))
        throw wrong_option("--mask", "\"" + text + "\" is not " + polygon_rule());
    const auto part = part_of(*numbers, are_fractions(*numbers), size);
    if (!part) throw wrong_option("--mask", "\"" + text + "\" is not inside the picture of " + text_of(size));
    return *part;
}

/// The polygons of a file are all in pixels, or all in fractions.
std::vector<match::MaskPolygon> masks_of_file(const std::string& file, glm::ivec2 size) {
    const auto refuse = [&file](const std::string& place, const std::string& reason) {
        throw Error(Failure::bad_input, Fault{.file = file, .place = place, .reason = reason});
    };
    note_read(file);
    const nlohmann::json all = nlohmann::json::parse(read_file(file, longest_file), nullptr, false);
    if (!all.is_array()) refuse("", "is no JSON list of polygons, [[[x,y],...],...]");
    std::vector<std::vector<double>> polygons;
    bool fractions = true;
    for (const nlohmann::json& polygon : all) {
        const std::string place = "/" + std::to_string(polygons.size());
        if (!polygon.is_array() || !fits_polygon(polygon.size())) refuse(place, "is not " + polygon_rule());
        std::vector<double>& numbers = polygons.emplace_back();
        for (const nlohmann::json& corner : polygon) {
            if (!corner.is_array() || corner.size() != 2 || !corner[0].is_number() || !corner[1].is_number())
                refuse(place + "/" + std::to_string(numbers.size() / 2), "is not [x,y]");
            numbers.push_back(corner[0].get<double>());
            numbers.push_back(corner[1].get<double>());
        }
        fractions = fractions && are_fractions(numbers);
    }
    std::vector<match::MaskPolygon> parts;
    for (const std::vector<double>& numbers : polygons) {
        const auto part = part_of(numbers, fractions, size);
        if (!part) refuse("/" + std::to_string(parts.size()), "is not inside the picture of " + text_of(size));
        parts.push_back(*part);
    }
    return parts;
}

}  // namespace

std::vector<match::MaskPolygon> masks_of(const std::string& text, glm::ivec2 size) {
    if (std::filesystem::path(text).extension() == ".json") return masks_of_file(text, size);
    return {mask_of_corners(text, size)};
}

glm::dvec4 region_of(const std::string& text, glm::ivec2 size) {
    const auto v = numbers_of(text);
    if (!v || v->size() != 4) throw wrong_option("--roi", "\"" + text + "\" is not x,y,width,height");
    const glm::dvec2 whole = are_fractions(*v) ? glm::dvec2(1.0) : glm::dvec2(size);
    const glm::dvec4 region((*v)[0] / whole.x, (*v)[1] / whole.y, (*v)[2] / whole.x, (*v)[3] / whole.y);
    const bool inside = region.x >= 0.0 && region.y >= 0.0 && region.z > 0.0 && region.w > 0.0 &&
                        region.x + region.z <= 1.0 + slack && region.y + region.w <= 1.0 + slack;
    if (!inside) throw wrong_option("--roi", "\"" + text + "\" is not inside the picture of " + text_of(size));
    return region;
}

glm::dvec3 round_view_of(const std::string& text, glm::ivec2 size) {
    const auto v = numbers_of(text);
    if (!v || v->size() != 3) throw wrong_option("--view", "\"" + text + "\" is not x,y,r");
    // A radius of more than one height is no fraction that is above 1.
    const glm::dvec2 whole = are_fractions({(*v)[0], (*v)[1]}) ? glm::dvec2(1.0) : glm::dvec2(size);
    const glm::dvec3 view((*v)[0] / whole.x, (*v)[1] / whole.y, (*v)[2] / whole.y);
    if (view.x < 0.0 || view.y < 0.0 || view.x > 1.0 || view.y > 1.0)
        throw wrong_option("--view", "the middle of \"" + text + "\" is not inside the picture of " + text_of(size));
    if (view.z < least_view_radius || view.z > most_view_radius)
        throw wrong_option("--view", "the radius of \"" + text + "\" is outside 0.1 to 2 heights of the picture");
    return view;
}

match::BloodStrokes strokes_of(const std::string& file, glm::ivec2 size) {
    note_read(file);
    return match::read_blood_strokes(read_file(file, match::longest_strokes), file, size);
}

}  // namespace lapfx::commands
