#include "organ/openmesh_formats.h"

#include <cstring>

#include "organ/openmesh_reader.h"

namespace lapfx::organ {

namespace {

constexpr std::size_t stl_header = 84, stl_triangle = 50;

std::string_view text_of(const Bytes& bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// "nan" and "inf" stop a number reader, and what follows would be read as something else. mend() leaves out
/// what is so large.
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

/// The last line of a text STL is endsolid, "end solid", or by careless programs endfacet.
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

/// OpenMesh keeps those facets of an STL from us two of whose corners are one, and none else.
RawOrgan organ_of(const Soup& soup, std::size_t facets) {
    RawOrgan organ = organ_of(soup);
    organ.without_area = facets - std::min(facets, soup.faces());
    return organ;
}

/// "outer loop" opens the corners of a facet in a text STL.
std::size_t count_loops(std::string_view text) {
    const std::string_view word = "outer";
    std::size_t count = 0;
    const auto same = [](char a, char b) { return std::tolower(static_cast<unsigned char>(a)) == b; };
    for (auto at = text.begin();; at += static_cast<std::ptrdiff_t>(word.size()), ++count) {
        at = std::search(at, text.end(), word.begin(), word.end(), same);
        if (at == text.end()) return count;
    }
}

/// OpenMesh joins vertices with an ordered map, which a NaN would spoil.
std::string without_nan(const Bytes& bytes, std::size_t triangles) {
    std::string text(text_of(bytes).substr(0, stl_header + triangles * stl_triangle));
    for (std::size_t t = 0; t < triangles; ++t)
        for (std::size_t value = 3; value < 12; ++value) {
            char* at = text.data() + stl_header + t * stl_triangle + value * sizeof(float);
            float number = 0;
            std::memcpy(&number, at, sizeof number);
            if (std::isfinite(number)) continue;
            number = 1e30f;
            std::memcpy(at, &number, sizeof number);
        }
    return text;
}

RawOrgan read_binary_stl(const std::string& file, const Bytes& bytes, std::size_t triangles) {
    const std::size_t need = stl_header + triangles * stl_triangle;
    if (bytes.size() < need)
        refuse(file, "",
               "truncated: " + std::to_string(triangles) + " triangles need " + std::to_string(need) +
                   " bytes, the file has " + std::to_string(bytes.size()));
    if (triangles > maximum_triangles) refuse(file, "", "has more than 20 million triangles");
    Soup soup;
    if (!read_with_openmesh(OpenMeshFormat::stl_binary, without_nan(bytes, triangles), soup))
        refuse(file, "", "cannot be read as STL");
    return organ_of(soup, triangles);
}

RawOrgan read_text_stl(const std::string& file, const Bytes& bytes) {
    std::string text(text_of(bytes));
    if (text.find('\0') != std::string::npos) refuse(file, "", "is neither a binary nor a text STL");
    if (!ends_whole(text)) refuse(file, "", "truncated: the file ends within a facet");
    replace_words_for_not_finite(text);
    Soup soup;
    if (!read_with_openmesh(OpenMeshFormat::stl_ascii, text, soup)) refuse(file, "", "cannot be read as STL");
    return organ_of(soup, count_loops(text));
}

}  // namespace

RawOrgan read_stl(const std::string& file, const Bytes& bytes) {
    std::uint32_t triangles = 0;
    if (bytes.size() >= stl_header) std::memcpy(&triangles, bytes.data() + 80, 4);
    // The header of a binary file may start with "solid" too; its length is what tells.
    const bool exact = bytes.size() >= stl_header && bytes.size() == stl_header + std::size_t{triangles} * stl_triangle;
    if (!exact && text_of(bytes).substr(0, 64).find("solid") != std::string_view::npos)
        return read_text_stl(file, bytes);
    if (bytes.size() < stl_header) refuse(file, "", "truncated: the file ends within the header of an STL");
    return read_binary_stl(file, bytes, triangles);
}

RawOrgan read_off(const std::string& file, const Bytes& bytes) {
    std::string text(text_of(bytes));
    if (text.find('\0') != std::string::npos) refuse(file, "", "is no text OFF");
    replace_words_for_not_finite(text);
    text += '\n';
    Soup soup;
    if (!read_with_openmesh(OpenMeshFormat::off, text, soup)) refuse(file, "", "truncated or malformed OFF");
    return organ_of(soup);
}

}  // namespace lapfx::organ
