#include "organ/openmesh_formats.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>

#include "organ/openmesh_reader.h"

namespace lapfx::organ {

namespace {

constexpr std::size_t stl_header = 84, stl_triangle = 50;

/// "nan" and "inf" stop a number reader, and the rest would be read as something else. Instead they become a large
/// number, whose triangles mend() leaves out.
void replace_words_for_not_finite(std::string& text) {
    const auto letter = [&](std::size_t i) {
        return i < text.size() && std::isalpha(static_cast<unsigned char>(text[i]));
    };
    for (std::size_t i = 0; i + 2 < text.size(); ++i) {
        if (letter(i - 1)) continue;
        const auto is = [&](const char* word) {
            const std::size_t length = std::strlen(word);
            if (i + length > text.size() || letter(i + length)) return false;
            return std::equal(word, word + length, text.begin() + static_cast<std::ptrdiff_t>(i),
                              [](char a, char b) { return a == std::tolower(static_cast<unsigned char>(b)); });
        };
        for (const char* word : {"nan", "inf", "infinity"})
            if (is(word)) text.replace(i, std::strlen(word), "1e30");
    }
}

/// The last line of a text STL is endsolid, "end solid", or, from careless programs, endfacet.
bool ends_whole(std::string_view text) {
    const std::size_t last = text.find_last_not_of(" \t\r\n");
    if (last == std::string_view::npos) return false;
    const std::size_t before = text.find_last_of("\r\n", last);
    std::string line(text.substr(before == std::string_view::npos ? 0 : before + 1));
    for (char& c : line) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    line = line.substr(std::min(line.find_first_not_of(" \t"), line.size()));
    return line.starts_with("endsolid") || line.starts_with("end solid") || line.starts_with("endfacet");
}

RawOrgan organ_of(const Soup& soup) {
    RawOrgan organ;
    add_parts(soup, {}, organ);
    return organ;
}

/// One facet of a binary STL: normal, three corners, two bytes.
std::array<glm::vec3, 3> corners_at(const std::string& stl, std::size_t facet) {
    std::array<glm::vec3, 3> corners;
    std::memcpy(corners.data(), stl.data() + stl_header + facet * stl_triangle + sizeof(glm::vec3), sizeof corners);
    return corners;
}

void set_corners(std::string& stl, std::size_t facet, const std::array<glm::vec3, 3>& corners) {
    std::memcpy(stl.data() + stl_header + facet * stl_triangle + sizeof(glm::vec3), corners.data(), sizeof corners);
}

/// OpenMesh reads as many facets as the header counts.
void set_count(std::string& stl, std::size_t facets) {
    const auto count = static_cast<std::uint32_t>(facets);
    std::memcpy(stl.data() + stl_header - sizeof count, &count, sizeof count);
}

/// OpenMesh joins corners with an ordered map, which a NaN would break, and hides facets with two equal corners from
/// us. A number that is not finite becomes so large that mend() leaves the facet out, and differs at each corner.
void replace_not_finite(std::string& stl, std::size_t facets) {
    constexpr float huge = 1e30f;
    for (std::size_t facet = 0; facet < facets; ++facet) {
        std::array<glm::vec3, 3> corners = corners_at(stl, facet);
        bool all_finite = true;
        for (std::size_t i = 0; i < 3; ++i)
            for (int axis = 0; axis < 3; ++axis) {
                float& value = corners[i][axis];
                if (std::abs(value) < huge) continue;  // false for NaN as well
                value = huge * static_cast<float>(i + 1);
                all_finite = false;
            }
        if (all_finite) continue;
        for (std::size_t i = 1; i < 3; ++i)
            if (corners[i] == corners[0] || corners[i] == corners[i - 1])
                corners[i].x = huge * static_cast<float>(i + 1);
        set_corners(stl, facet, corners);
    }
}

/// `stl` is a whole binary one.
RawOrgan read_facets(const std::string& file, std::string stl, std::size_t facets) {
    if (facets > maximum_triangles) refuse(file, "", "has more than 20 million triangles");
    replace_not_finite(stl, facets);
    Soup soup;
    if (!read_with_openmesh(OpenMeshFormat::stl_binary, stl, soup)) refuse(file, "", "cannot be read as STL");
    RawOrgan organ = organ_of(soup);
    organ.without_area = facets - std::min(facets, soup.faces());  // facets that it has hidden from us
    return organ;
}

std::string_view next_word(std::string_view& line) {
    constexpr std::string_view spaces = " \t\v\f";
    line.remove_prefix(std::min(line.find_first_not_of(spaces), line.size()));
    const std::string_view word = line.substr(0, line.find_first_of(spaces));
    line.remove_prefix(word.size());
    return word;
}

bool is_word(std::string_view word, std::string_view lower) {
    return std::equal(word.begin(), word.end(), lower.begin(), lower.end(),
                      [](char a, char b) { return std::tolower(static_cast<unsigned char>(a)) == b; });
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

/// Converts a text STL to a binary one. OpenMesh's reader of the text is not used: it takes the three lines after any
/// "outer" for corners, even in the name of the solid, and reads words as 0. Here a corner that is missing or not a
/// number is NaN.
class BinaryOf {
  public:
    explicit BinaryOf(std::string_view text) {
        while (!text.empty()) {
            line(text.substr(0, text.find_first_of("\r\n")));
            text.remove_prefix(std::min(text.find_first_of("\r\n"), text.size() - 1) + 1);
        }
        end_facet();
        set_count(stl_, facets_);
    }
    std::size_t facets() const { return facets_; }
    std::string take() { return std::move(stl_); }

  private:
    void line(std::string_view rest) {
        std::string_view word = next_word(rest);
        for (const char* key : {"solid", "endsolid", "end"})
            if (is_word(word, key)) return;  // the rest is a name
        for (; !word.empty(); word = next_word(rest)) {
            if (is_word(word, "outer")) {
                end_facet();
                within_ = true;
            } else if (is_word(word, "vertex")) {
                glm::vec3 corner;
                for (int axis = 0; axis < 3; ++axis) corner[axis] = number_of(next_word(rest));
                if (within_ && known_ < 3) corners_[known_++] = corner;
            }
        }
    }

    void end_facet() {
        if (!within_) return;
        for (; known_ < 3; ++known_) corners_[known_] = glm::vec3(std::numeric_limits<float>::quiet_NaN());
        if (facets_ < maximum_triangles) {  // more are refused
            stl_.resize(stl_.size() + stl_triangle, '\0');
            set_corners(stl_, facets_, corners_);
        }
        ++facets_;
        within_ = false;
        known_ = 0;
    }

    std::string stl_ = std::string(stl_header, '\0');
    std::size_t facets_ = 0;
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
    std::string stl(reinterpret_cast<const char*>(bytes.data()), need);
    set_count(stl, triangles);
    RawOrgan organ = read_facets(file, std::move(stl), triangles);
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
    BinaryOf binary(text);
    return read_facets(file, binary.take(), binary.facets());
}

/// A text begins with the word solid, in any case; the header of a binary file may do so too.
bool is_text_stl(std::string_view text) {
    constexpr std::string_view first_word = "solid";
    const std::string_view begin = text.substr(0, 64);
    const auto found = std::search(begin.begin(), begin.end(), first_word.begin(), first_word.end(),
                                   [](char a, char b) { return std::tolower(static_cast<unsigned char>(a)) == b; });
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

RawOrgan read_off(const std::string& file, const Bytes& bytes) {
    std::string storage, text(text_of(bytes, storage));
    if (text.find('\0') != std::string::npos) refuse(file, "", "is not a text OFF");
    replace_words_for_not_finite(text);
    text += '\n';
    Soup soup;
    if (!read_with_openmesh(OpenMeshFormat::off, text, soup)) refuse(file, "", "truncated or malformed OFF");
    return organ_of(soup);
}

}  // namespace lapfx::organ
