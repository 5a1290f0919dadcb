#include "organ/stl.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>
#include <unordered_map>

#include "lapfx/authoring/letters.h"
#include "organ/soup.h"

namespace lapfx::organ {

namespace {

constexpr std::size_t stl_header = 84, stl_triangle = 50;
constexpr float huge = 1e30f;  // no coordinate of an organ; mend() leaves out much smaller ones

bool is_place(const glm::vec3& corner) {
    return std::abs(corner.x) < huge && std::abs(corner.y) < huge &&
           std::abs(corner.z) < huge;  // false for NaN as well
}

struct HashOfPlace {
    std::size_t operator()(const glm::vec3& place) const {
        std::uint64_t hash = 0;
        for (int axis = 0; axis < 3; ++axis) {
            std::uint32_t bits;
            std::memcpy(&bits, &place[axis], sizeof bits);
            hash = (hash ^ bits) * 0x9e3779b97f4a7c15ULL;
            hash ^= hash >> 32U;
        }
        return hash;
    }
};

/// The facets of a file. Corners at one place become one vertex, which the format does not say.
class Facets {
  public:
    /// A facet with two equal corners is counted and left out. One with a corner that is at no place stays, so that
    /// mend() tells that about it.
    void add(const std::array<glm::vec3, 3>& corners) {
        ++count_;
        if (full()) return;
        std::array<std::uint32_t, 3> vertices;
        for (std::size_t i = 0; i < 3; ++i) vertices[i] = vertex_at(corners[i]);
        const bool placed = std::ranges::all_of(corners, is_place);
        if (placed && (vertices[0] == vertices[1] || vertices[1] == vertices[2] || vertices[2] == vertices[0])) return;
        soup_.corners.insert(soup_.corners.end(), vertices.begin(), vertices.end());
        soup_.first.push_back(static_cast<std::uint32_t>(soup_.corners.size()));
    }
    /// More are refused.
    bool full() const { return count_ > maximum_triangles; }
    RawOrgan organ(const std::string& file) const {
        if (full()) refuse(file, "", "has more than 20 million triangles");
        RawOrgan organ;
        add_parts(soup_, {}, organ);
        organ.without_area = count_ - soup_.faces();
        return organ;
    }

  private:
    /// What is no coordinate is at no place: mend() leaves out a facet with such a corner, and says so.
    std::uint32_t vertex_at(const glm::vec3& place) {
        const auto next = static_cast<std::uint32_t>(soup_.positions.size());
        bool known = false;
        std::uint32_t vertex = next;
        if (is_place(place)) {
            const auto [at, is_new] = vertices_.try_emplace(place + 0.0f, next);  // -0 becomes 0
            vertex = at->second, known = !is_new;
        }
        if (!known) soup_.positions.push_back(place);
        return vertex;
    }

    Soup soup_;
    std::unordered_map<glm::vec3, std::uint32_t, HashOfPlace> vertices_;
    std::size_t count_ = 0;
};

/// The last line of a text STL is endsolid, "end solid", or, from careless programs, endfacet.
bool ends_whole(std::string_view text) {
    const std::size_t last = text.find_last_not_of(" \t\r\n");
    if (last == std::string_view::npos) return false;
    const std::size_t before = text.find_last_of("\r\n", last);
    std::string line(text.substr(before == std::string_view::npos ? 0 : before + 1));
    line = lower(line.substr(std::min(line.find_first_not_of(" \t"), line.size())));
    return line.starts_with("endsolid") || line.starts_with("end solid") || line.starts_with("endfacet");
}

std::string_view next_word(std::string_view& line) {
    constexpr std::string_view spaces = " \t\v\f";
    line.remove_prefix(std::min(line.find_first_not_of(spaces), line.size()));
    const std::string_view word = line.substr(0, line.find_first_of(spaces));
    line.remove_prefix(word.size());
    return word;
}

/// NaN: it is none.
float number_of(std::string_view word) {
    if (word.starts_with('+')) word.remove_prefix(1);
    float value = 0.0f;
    const auto [end, code] = std::from_chars(word.data(), word.data() + word.size(), value);
    const bool tiny = code == std::errc::result_out_of_range &&
                      (word.find("e-") != std::string_view::npos || word.find("E-") != std::string_view::npos);
    if (tiny) value = 0.0f;
    return (code == std::errc() || tiny) && end == word.data() + word.size() ? value
                                                                             : std::numeric_limits<float>::quiet_NaN();
}

/// Reads a text line by line. The name of the solid may hold words of the format. A corner that is missing or not a
/// number is NaN.
class TextReader {
  public:
    explicit TextReader(std::string_view text) {
        while (!text.empty()) {
            line(text.substr(0, text.find_first_of("\r\n")));
            text.remove_prefix(std::min(text.find_first_of("\r\n"), text.size() - 1) + 1);
        }
        end_facet();
    }
    const Facets& facets() const { return facets_; }

  private:
    void line(std::string_view rest) {
        std::string_view word = next_word(rest);
        for (const char* key : {"solid", "endsolid", "end"})
            if (same_letters(word, key)) return;  // the rest is a name
        for (; !word.empty(); word = next_word(rest)) {
            if (same_letters(word, "outer")) {
                end_facet();
                within_ = true;
            } else if (same_letters(word, "vertex")) {
                glm::vec3 corner;
                for (int axis = 0; axis < 3; ++axis) corner[axis] = number_of(next_word(rest));
                if (within_ && known_ < 3) corners_[known_++] = corner;
            }
        }
    }

    void end_facet() {
        if (!within_) return;
        for (; known_ < 3; ++known_) corners_[known_] = glm::vec3(std::numeric_limits<float>::quiet_NaN());
        facets_.add(corners_);
        within_ = false;
        known_ = 0;
    }

    Facets facets_;
    std::array<glm::vec3, 3> corners_{};
    std::size_t known_ = 0;  ///< of the corners
    bool within_ = false;    ///< a facet
};

/// The count of the header, unless the file goes on after it for whole triangles: some programs never fill it in, or
/// only for the first of several parts.
RawOrgan read_binary_stl(const std::string& file, const Bytes& bytes, std::size_t counted_triangles) {
    if (bytes.size() < stl_header) refuse(file, "", "truncated: the file ends within the header of an STL");
    const std::size_t length = bytes.size() - stl_header, whole = length / stl_triangle;
    if (counted_triangles > whole)
        refuse(file, "",
               "truncated: " + std::to_string(counted_triangles) + " triangles need " +
                   std::to_string(stl_header + counted_triangles * stl_triangle) + " bytes, the file has " +
                   std::to_string(bytes.size()));
    const bool all = counted_triangles == 0 || length % stl_triangle == 0;
    const std::size_t triangles = all ? whole : counted_triangles, need = stl_header + triangles * stl_triangle;
    Facets facets;
    for (std::size_t i = 0; i < triangles && !facets.full(); ++i) {
        std::array<glm::vec3, 3> corners;  // behind a normal, before two bytes
        std::memcpy(corners.data(), bytes.data() + stl_header + i * stl_triangle + sizeof(glm::vec3), sizeof corners);
        facets.add(corners);
    }
    RawOrgan organ = facets.organ(file);
    const std::string by_header = "its header counts " + counted(counted_triangles, "triangle", "triangles");
    if (triangles > counted_triangles)
        organ.warnings.push_back(by_header + ", but the file has " + std::to_string(triangles) + ": all were read");
    else if (whole > triangles)
        organ.warnings.push_back(by_header + ": " + std::to_string(bytes.size() - need) +
                                 " bytes that follow them were not read");
    return organ;
}

RawOrgan read_text_stl(const std::string& file, std::string_view text) {
    if (!ends_whole(text)) refuse(file, "", "truncated: the file ends within a facet");
    return TextReader(text).facets().organ(file);
}

/// A text begins with the word solid, in any case; the header of a binary file may do so too.
bool is_text_stl(std::string_view text) {
    constexpr std::string_view first_word = "solid";
    const std::string_view begin = text.substr(0, 64);
    const auto found = std::search(begin.begin(), begin.end(), first_word.begin(), first_word.end(),
                                   [](char a, char b) { return lower(a) == b; });
    return found != begin.end() && text.find('\0') == std::string_view::npos;
}

}  // namespace

RawOrgan read_stl(const std::string& file, const Bytes& bytes) {
    std::uint32_t triangles = 0;
    if (bytes.size() >= stl_header) std::memcpy(&triangles, bytes.data() + 80, 4);
    // A binary file may look like a text, but then its length fits exactly.
    const bool exact = bytes.size() >= stl_header && bytes.size() == stl_header + std::size_t{triangles} * stl_triangle;
    std::string storage;
    const std::string_view text = exact ? std::string_view() : text_of(bytes, storage);
    return is_text_stl(text) ? read_text_stl(file, text) : read_binary_stl(file, bytes, triangles);
}

}  // namespace lapfx::organ
