#include "match/frame/blood_strokes.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <numeric>
#include <set>
#include <utility>

#include "lapfx/error.h"

namespace lapfx::match {

namespace {

using nlohmann::json;

constexpr std::string_view format = "lapfx.blood_strokes";
constexpr int version = 1;
constexpr double longest_video = 86'400.0;  // s
constexpr std::size_t shown_letters = 40;   // of a value, in a message
constexpr int deepest_level = 32;           // what is nested deeper is no file of ours

std::string text_of(double number) {
    char text[32];
    std::snprintf(text, sizeof text, "%.6g", number);
    return text;
}

/// Not within a character.
std::string cut(const std::string& text) {
    std::size_t end = shown_letters;
    if (text.size() <= end) return text;
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) --end;
    return text.substr(0, end) + "...";
}

std::string shown(const json& value) {
    return cut(value.dump(-1, ' ', false, json::error_handler_t::replace));
}

/// Reads one file; the first thing that is wrong is thrown.
class StrokesReader {
  public:
    StrokesReader(const std::string& name, glm::ivec2 size) : name_(name), size_(size) {}

    BloodStrokes read(std::string_view text) const {
        const json all = parsed(text);
        if (!all.is_object()) refuse("", "is no JSON object with \"format\": \"" + std::string(format) + "\"");
        check_format(all);
        check_keys(all, "", {"format", "version", "without_blood", "strokes"});
        BloodStrokes made{.file = name_, .without_blood = {}, .strokes = {}};
        if (all.contains("without_blood")) made.without_blood = number(all, "", "without_blood", 0.0, longest_video);
        const json& strokes = list(all, "", "strokes", most_blood_strokes);
        const glm::dvec2 whole = in_fractions(strokes) ? glm::dvec2(1.0) : glm::dvec2(size_);
        for (std::size_t i = 0; i < strokes.size(); ++i)
            made.strokes.push_back(stroke_of(strokes[i], "/strokes/" + std::to_string(i), whole));
        const auto points =
            std::accumulate(made.strokes.begin(), made.strokes.end(), std::size_t{0},
                            [](std::size_t sum, const BloodStroke& stroke) { return sum + stroke.points.size(); });
        if (points > most_points)
            refuse("/strokes", "have " + std::to_string(points) + " points together (allowed: up to " +
                                   std::to_string(most_points) + ")");
        if (std::ranges::none_of(made.strokes, [](const BloodStroke& s) { return s.marks == StrokeMark::blood; }))
            refuse("/strokes", "no stroke marks blood");
        return made;
    }

  private:
    [[noreturn]] void refuse(const std::string& place, const std::string& reason) const {
        throw Error(Failure::bad_input, Fault{.file = name_, .place = place, .reason = reason});
    }

    /// A key that is there twice would hide a value.
    json parsed(std::string_view text) const {
        std::vector<std::set<std::string>> keys;
        const auto seen = [&](int depth, json::parse_event_t event, json& value) {
            if (depth > deepest_level) refuse("", "is nested deeper than " + std::to_string(deepest_level) + " levels");
            if (event == json::parse_event_t::object_start) keys.emplace_back();
            if (event == json::parse_event_t::object_end) keys.pop_back();
            if (event == json::parse_event_t::key && !keys.back().insert(value.get<std::string>()).second)
                refuse("", "the key " + shown(value) + " is there twice");
            return true;
        };
        try {
            return json::parse(text, seen);
        } catch (const json::parse_error& error) {
            const auto line = 1 + std::count(text.begin(), text.begin() + std::min(error.byte, text.size()), '\n');
            refuse("line " + std::to_string(line), "is no JSON");
        } catch (const json::out_of_range&) {
            refuse("", "has a number that is too large");
        }
    }

    void check_format(const json& all) const {
        const auto found = all.find("format"), number = all.find("version");
        if (found == all.end()) refuse("/format", "missing; expected \"" + std::string(format) + "\"");
        if (*found != std::string(format)) refuse("/format", shown(*found) + " is not \"" + std::string(format) + "\"");
        if (number == all.end()) refuse("/version", "missing; expected " + std::to_string(version));
        if (*number != version) refuse("/version", shown(*number) + " is not " + std::to_string(version));
    }

    void check_keys(const json& object, const std::string& place, std::initializer_list<std::string_view> known) const {
        for (const auto& [key, value] : object.items()) {
            if (std::ranges::find(known, key) != known.end()) continue;
            std::string allowed;
            for (const std::string_view name : known) allowed += (allowed.empty() ? "" : ", ") + std::string(name);
            refuse(place + "/" + cut(key), "unknown key (allowed: " + allowed + ")");
        }
    }

    const json& member(const json& object, const std::string& place, const char* key) const {
        const auto found = object.find(key);
        if (found == object.end()) refuse(place + "/" + key, "missing");
        return *found;
    }

    double number(const json& object, const std::string& place, const char* key, double least, double most) const {
        const json& value = member(object, place, key);
        if (!value.is_number()) refuse(place + "/" + key, shown(value) + " is not a number");
        const double number = value.get<double>();
        if (!(number >= least && number <= most))
            refuse(place + "/" + key,
                   shown(value) + " is outside the allowed " + text_of(least) + " to " + text_of(most));
        return number;
    }

    const json& list(const json& object, const std::string& place, const char* key, std::size_t most) const {
        const json& value = member(object, place, key);
        if (!value.is_array()) refuse(place + "/" + key, shown(value) + " is not a list");
        if (value.empty() || value.size() > most)
            refuse(place + "/" + key,
                   "has " + std::to_string(value.size()) + " (allowed: 1 to " + std::to_string(most) + ")");
        return value;
    }

    /// Points are all in px, or all in fractions; what else they are is told later.
    static bool in_fractions(const json& strokes) {
        for (const json& stroke : strokes) {
            if (!stroke.is_object() || !stroke.contains("points")) continue;
            for (const json& point : stroke["points"])
                for (const json& along : point)
                    if (along.is_number() && along.get<double>() > 1.0) return false;
        }
        return true;
    }

    /// `whole`: the picture's width and height in the units of the file.
    BloodStroke stroke_of(const json& stroke, const std::string& place, glm::dvec2 whole) const {
        if (!stroke.is_object()) refuse(place, shown(stroke) + " is not an object");
        check_keys(stroke, place, {"time", "marks", "radius", "points"});
        BloodStroke made{.time = number(stroke, place, "time", 0.0, longest_video),
                         .marks = mark_of(member(stroke, place, "marks"), place + "/marks"),
                         .radius = number(stroke, place, "radius", 0.0, most_stroke_radius * whole.x) / whole.x};
        if (made.radius <= 0.0) refuse(place + "/radius", "0 is not above 0");
        const json& points = list(stroke, place, "points", most_stroke_points);
        for (std::size_t i = 0; i < points.size(); ++i)
            made.points.push_back(point_of(points[i], place + "/points/" + std::to_string(i), whole));
        return made;
    }

    StrokeMark mark_of(const json& value, const std::string& place) const {
        if (value == "blood") return StrokeMark::blood;
        if (value == "other") return StrokeMark::other;
        refuse(place, shown(value) + " is not \"blood\" or \"other\"");
    }

    PicturePlace point_of(const json& point, const std::string& place, glm::dvec2 whole) const {
        if (!point.is_array() || point.size() != 2 || !point[0].is_number() || !point[1].is_number())
            refuse(place, shown(point) + " is not [x,y]");
        const glm::dvec2 made = glm::dvec2(point[0].get<double>(), point[1].get<double>()) / whole;
        if (!(made.x >= 0.0 && made.y >= 0.0 && made.x <= 1.0 && made.y <= 1.0))
            refuse(place, shown(point) + " is not inside the picture of " + std::to_string(size_.x) + "x" +
                              std::to_string(size_.y));
        return {made.x, made.y};
    }

    const std::string& name_;
    glm::ivec2 size_;
};

double distance_to(glm::dvec2 p, glm::dvec2 from, glm::dvec2 to) {
    const glm::dvec2 along = to - from;
    const double length = glm::dot(along, along);
    const double share = length > 0.0 ? std::clamp(glm::dot(p - from, along) / length, 0.0, 1.0) : 0.0;
    return glm::length(p - from - share * along);
}

/// Pixels whose middle is within `radius` of a line, and those below its ends; all in px. Gives whether one was in
/// view.
bool paint(cv::Mat& marks, const cv::Mat& view, glm::dvec2 from, glm::dvec2 to, double radius, StrokeMark mark) {
    const auto limit = [](double at, int length) { return std::clamp(static_cast<int>(at), 0, length - 1); };
    bool any = false;
    const auto put = [&](int x, int y) {
        if (view.at<std::uint8_t>(y, x) == 0) return;
        marks.at<std::uint8_t>(y, x) = value_of(mark);
        any = true;
    };
    for (const glm::dvec2 end : {from, to}) put(limit(end.x, view.cols), limit(end.y, view.rows));
    const glm::dvec2 least = glm::min(from, to) - radius, most = glm::max(from, to) + radius;
    for (int y = limit(least.y, view.rows); y <= limit(most.y, view.rows); ++y)
        for (int x = limit(least.x, view.cols); x <= limit(most.x, view.cols); ++x)
            if (distance_to({x + 0.5, y + 0.5}, from, to) <= radius) put(x, y);
    return any;
}

}  // namespace

BloodStrokes read_blood_strokes(std::string_view json, const std::string& name, glm::ivec2 size) {
    return StrokesReader(name, size).read(json);
}

std::string write_blood_strokes(const BloodStrokes& strokes) {
    using nlohmann::ordered_json;
    std::string text =
        "{\"format\": " + ordered_json(format).dump() + ", \"version\": " + std::to_string(version) + ",\n";
    if (strokes.without_blood) text += " \"without_blood\": " + ordered_json(*strokes.without_blood).dump() + ",\n";
    text += " \"strokes\": [";
    bool first = true;
    for (const BloodStroke& stroke : strokes.strokes) {
        if (stroke.points.empty()) continue;
        ordered_json points = ordered_json::array();
        for (const PicturePlace& at : stroke.points) points.push_back({at.x, at.y});
        const ordered_json made{{"time", stroke.time},
                                {"marks", stroke.marks == StrokeMark::blood ? "blood" : "other"},
                                {"radius", stroke.radius},
                                {"points", points}};
        text += (std::exchange(first, false) ? "\n  " : ",\n  ") + made.dump();
    }
    return text + "\n]}\n";
}

cv::Mat marks_of(const BloodStrokes& strokes, std::span<const std::size_t> which, const cv::Mat& view) {
    cv::Mat marks = cv::Mat::zeros(view.size(), CV_8U);
    const glm::dvec2 size(view.cols, view.rows);
    const auto at = [size](const PicturePlace& place) { return size * glm::dvec2(place.x, place.y); };
    for (const std::size_t number : which) {
        const BloodStroke& stroke = strokes.strokes[number];
        bool any = false;
        for (std::size_t i = 0; i < stroke.points.size(); ++i)
            any |= paint(marks, view, at(stroke.points[i > 0 ? i - 1 : 0]), at(stroke.points[i]),
                         size.x * stroke.radius, stroke.marks);
        if (!any && !stroke.points.empty())
            throw Error(Failure::bad_input, Fault{.file = strokes.file,
                                                  .place = strokes.place + "/strokes/" + std::to_string(number),
                                                  .reason = "lies outside of the view that is measured"});
    }
    return marks;
}

}  // namespace lapfx::match
