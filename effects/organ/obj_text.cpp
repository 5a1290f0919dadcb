#include "organ/obj_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>

#include "lapfx/authoring/letters.h"

namespace lapfx::organ {

namespace {

bool is_space(char c) {
    return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
    while (!text.empty() && is_space(text.back())) text.remove_suffix(1);
    return text;
}

/// Cuts the first word off a line.
std::string_view next_word(std::string_view& line) {
    line = trimmed(line);
    std::size_t end = 0;
    while (end < line.size() && !is_space(line[end])) ++end;
    const std::string_view word = line.substr(0, end);
    line.remove_prefix(end);
    return word;
}

/// False unless the whole word is a finite number.
bool read_number(std::string_view word, float& value) {
    if (word.starts_with('+')) word.remove_prefix(1);
    const auto [end, code] = std::from_chars(word.data(), word.data() + word.size(), value);
    // A number too small for a float counts as 0.
    const auto has = [&](const char* part) { return word.find(part) != std::string_view::npos; };
    if (code == std::errc::result_out_of_range && (has("e-") || has("E-")))
        value = 0.0f;
    else if (code != std::errc())
        return false;
    return end == word.data() + word.size() && std::isfinite(value);
}

/// One corner of a face: numbers of vertex, texture coordinate and normal, from 0. They may refer to later lines.
struct Corner {
    std::uint32_t vertex = none, uv = none, normal = none;
    static constexpr std::uint32_t none = 0xffffffff;
};

class Reader {
  public:
    void line(std::string_view line) {
        std::string_view rest = trimmed(line);
        const std::string_view key = next_word(rest);
        // A name may hold a "#", but numbers end there.
        const std::string_view values = rest.substr(0, rest.find('#'));
        if (key == "v") {
            vertex(values);
        } else if (key == "vt") {
            const auto [count, v] = numbers(values);
            uvs_.emplace_back(count > 0 ? v[0] : 0.0f, count > 1 ? v[1] : 0.0f);
        } else if (key == "vn") {
            const auto [count, v] = numbers(values);
            normals_.push_back(count >= 3 ? glm::vec3(v[0], v[1], v[2]) : glm::vec3(0.0f));
        } else if (key == "vc") {
            if (const auto [count, v] = numbers(values); count >= 3) color(vertex_colors_++, {v[0], v[1], v[2], 1.0f});
        } else if (key == "f" || key == "fo") {
            face(values);
        } else if (key == "usemtl") {
            material_ = trimmed(rest);
        } else if (key == "o" || key == "g") {
            if (!trimmed(rest).empty()) name_ = trimmed(rest);
        } else if (key == "mtllib") {
            for (std::string& name : libraries_of(line)) out_.libraries.push_back(std::move(name));
        }
    }

    ObjText take() {
        Soup& soup = out_.soup;
        const std::size_t count = soup.positions.size();
        if (!soup.colors.empty()) soup.colors.resize(count, glm::vec4(1.0f));
        const bool any_uv = std::any_of(corners_.begin(), corners_.end(), [&](const Corner& c) { return has_uv(c); });
        for (const Corner& corner : corners_) {
            soup.corners.push_back(corner.vertex);
            if (any_uv) soup.corner_uvs.push_back(has_uv(corner) ? uvs_[corner.uv] : glm::vec2(no_uv, 0.0f));
            if (corner.normal < normals_.size() && corner.vertex < count)
                normal(corner.vertex, normals_[corner.normal]);
        }
        for (std::size_t v = 0; v < hard_.size(); ++v)
            if (hard_[v]) soup.normals[v] = glm::vec3(0.0f);
        return std::move(out_);
    }

  private:
    /// The finite numbers at the start of a line, at most seven, and their count.
    static std::pair<std::size_t, std::array<float, 7>> numbers(std::string_view line) {
        std::array<float, 7> values{};
        std::size_t count = 0;
        while (count < values.size()) {
            const std::string_view word = next_word(line);
            float value = 0.0f;
            if (word.empty() || !read_number(word, value)) break;
            values[count++] = value;
        }
        return {count, values};
    }

    void vertex(std::string_view rest) {
        const auto [count, v] = numbers(rest);
        out_.soup.positions.push_back(count >= 3 ? glm::vec3(v[0], v[1], v[2]) : glm::vec3(1e30f));
        if (count >= 6) color(out_.soup.positions.size() - 1, {v[3], v[4], v[5], 1.0f});
    }

    void color(std::size_t vertex, const glm::vec4& value) {
        std::vector<glm::vec4>& colors = out_.soup.colors;
        if (colors.size() <= vertex) colors.resize(vertex + 1, glm::vec4(1.0f));
        colors[vertex] = value;
    }

    /// "7", "7/3", "7//2", "7/3/2"; numbers below 0 count back from the last one so far. A texture coordinate or a
    /// normal that cannot be read is missing; only the vertex decides whether there is a corner.
    bool read_corner(std::string_view word, Corner& corner) const {
        std::uint32_t* const targets[] = {&corner.vertex, &corner.uv, &corner.normal};
        const std::size_t counts[] = {out_.soup.positions.size(), uvs_.size(), normals_.size()};
        for (int part = 0; part < 3; ++part) {
            const std::size_t slash = word.find('/');
            const std::string_view number = word.substr(0, slash);
            int value = 0;
            const auto [end, code] = std::from_chars(number.data(), number.data() + number.size(), value);
            const bool read = code == std::errc() && end == number.data() + number.size() && value != 0;
            if (!read && part == 0) return false;
            const std::int64_t index = value > 0 ? value - 1 : static_cast<std::int64_t>(counts[part]) + value;
            if (read && index >= 0) *targets[part] = static_cast<std::uint32_t>(index);
            if (slash == std::string_view::npos) return true;
            word.remove_prefix(slash + 1);
        }
        return true;
    }

    void face(std::string_view rest) {
        const std::size_t begin = corners_.size();
        std::size_t words = 0;
        for (std::string_view word; !(word = next_word(rest)).empty(); ++words) {
            Corner corner;
            if (read_corner(word, corner)) corners_.push_back(corner);
        }
        if (corners_.size() - begin < words || words < 3) {
            corners_.resize(begin);
            out_.soup.add_unreadable(words);
            return;
        }
        const bool new_run =
            out_.runs.empty() || out_.runs.back().material != material_ || out_.runs.back().name != name_;
        if (new_run) out_.runs.push_back({out_.soup.faces(), material_, name_});
        out_.soup.first.push_back(static_cast<std::uint32_t>(corners_.size()));
    }

    bool has_uv(const Corner& corner) const { return corner.uv < uvs_.size(); }

    /// Two normals at one vertex mean a hard edge or a bad exporter. An organ gets a smooth normal instead.
    void normal(std::uint32_t vertex, const glm::vec3& value) {
        Soup& soup = out_.soup;
        soup.normals.resize(soup.positions.size(), glm::vec3(0.0f));
        hard_.resize(soup.positions.size(), 0);
        glm::vec3& there = soup.normals[vertex];
        if (there != glm::vec3(0.0f) && glm::dot(there, value) < 0.9f * glm::dot(there, there)) hard_[vertex] = 1;
        there = value;
    }

    ObjText out_;
    std::string material_, name_;
    std::vector<glm::vec2> uvs_;
    std::vector<glm::vec3> normals_;
    std::vector<char> hard_;       ///< vertices with normals that contradict each other
    std::vector<Corner> corners_;  ///< all faces have theirs here
    std::size_t vertex_colors_ = 0;
};

}  // namespace

char line_end(std::string_view text) {
    return text.find('\n') == std::string_view::npos ? '\r' : '\n';
}

std::vector<std::string> libraries_of(std::string_view line) {
    std::vector<std::string> names;
    if (next_word(line) != "mtllib") return names;
    while (!(line = trimmed(line)).empty()) {
        std::string_view rest = line;
        for (bool ends = false; !ends && !rest.empty();) {
            const std::string_view word = next_word(rest);
            ends = same_letters(word.substr(word.size() - std::min<std::size_t>(word.size(), 4)), ".mtl");
        }
        names.emplace_back(trimmed(line.substr(0, line.size() - rest.size())));
        line = rest;
    }
    return names;
}

ObjText read_obj_text(std::string_view source) {
    Reader reader;
    const char end_of_line = line_end(source);
    std::string joined;  // a line that continues after a backslash
    while (!source.empty()) {
        const std::size_t end = std::min(source.find(end_of_line), source.size());
        std::string_view line = source.substr(0, end);
        source.remove_prefix(std::min(end + 1, source.size()));
        while (!line.empty() && line.back() == '\r') line.remove_suffix(1);
        if (line.ends_with('\\')) {
            (joined += line.substr(0, line.size() - 1)) += ' ';
            continue;
        }
        if (joined.empty()) {
            reader.line(line);
        } else {
            reader.line(joined += line);
            joined.clear();
        }
    }
    if (!joined.empty()) reader.line(joined);
    return reader.take();
}

}  // namespace lapfx::organ
