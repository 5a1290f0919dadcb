#include "organ/obj_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>

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

bool is_number(std::string_view word) {
    if (word.starts_with('+')) word.remove_prefix(1);
    float value = 0;
    const auto [end, code] = std::from_chars(word.data(), word.data() + word.size(), value);
    // A number too small for a float is as good as 0; OpenMesh's stream takes it.
    const bool read = code == std::errc() || (code == std::errc::result_out_of_range && value == 0.0f);
    return read && end == word.data() + word.size() && std::isfinite(value);
}

/// The number of finite numbers that a line starts with.
std::size_t numbers(std::string_view line) {
    std::size_t count = 0;
    while (true) {
        const std::string_view word = next_word(line);
        if (word.empty() || !is_number(word)) return count;
        ++count;
    }
}

/// "7", "7/3", "7//2", "7/3/2"; the numbers may be negative. The first one goes to `vertex`.
bool is_corner(std::string_view word, int& vertex) {
    for (int part = 0; part < 3; ++part) {
        const std::size_t slash = word.find('/');
        const std::string_view number = word.substr(0, slash);
        int value = 0;
        const auto [end, code] = std::from_chars(number.data(), number.data() + number.size(), value);
        const bool read = code == std::errc() && end == number.data() + number.size() && value != 0;
        const bool left_out = number.empty() && part > 0;
        if (!read && !left_out) return false;
        if (part == 0) vertex = value;
        if (slash == std::string_view::npos) return true;
        word.remove_prefix(slash + 1);
    }
    return false;
}

class Cleaner {
  public:
    explicit Cleaner(std::string_view source) { out_.text.reserve(source.size() + 64); }

    void line(std::string_view line) {
        if (const std::size_t comment = line.find('#'); comment != std::string_view::npos)
            line = line.substr(0, comment);
        line = trimmed(line);
        std::string_view rest = line;
        const std::string_view key = next_word(rest);
        if (key == "v") {
            vertex(rest);
        } else if (key == "vt") {
            pad(key, rest, 2);
        } else if (key == "vn") {
            pad(key, rest, 3);
        } else if (key == "vc") {
            if (numbers(rest) >= 3) keep(line);
        } else if (key == "f" || key == "fo") {
            face(rest);
        } else if (key == "usemtl") {
            material_ = trimmed(rest);
        } else if (key == "o" || key == "g") {
            if (!trimmed(rest).empty()) name_ = trimmed(rest);
        } else if (key == "mtllib") {
            out_.libraries.emplace_back(trimmed(rest));
        }
    }

    ObjText take() { return std::move(out_); }

  private:
    void keep(std::string_view text) { (out_.text += text) += '\n'; }

    /// A vertex is always kept, or the indices of all faces would shift; mend() takes the impossible ones
    /// out.
    void vertex(std::string_view rest) {
        if (numbers(rest) >= 3)
            ((out_.text += "v ") += rest) += '\n';
        else
            keep("v 1e30 1e30 1e30");
    }

    void pad(std::string_view key, std::string_view rest, std::size_t wanted) {
        const std::size_t have = numbers(rest);
        out_.text += key;
        std::string_view words = rest;
        for (std::size_t i = 0; i < wanted; ++i) (out_.text += ' ') += i < have ? next_word(words) : "0";
        out_.text += '\n';
    }

    void face(std::string_view rest) {
        corners_.clear();
        for (std::string_view words = rest, word; !(word = next_word(words)).empty();) {
            int vertex = 0;
            if (!is_corner(word, vertex)) {
                ++out_.bad_faces;
                return;
            }
            corners_.push_back(vertex);
        }
        if (corners_.size() < 3) {
            ++out_.bad_faces;
            return;
        }
        std::sort(corners_.begin(), corners_.end());
        // OpenMesh does not report such a face, and the count of faces would go wrong.
        if (std::unique(corners_.begin(), corners_.end()) - corners_.begin() < 3) {
            ++out_.flat_faces;
            return;
        }
        const bool new_run =
            out_.runs.empty() || out_.runs.back().material != material_ || out_.runs.back().name != name_;
        if (new_run) out_.runs.push_back({out_.faces, material_, name_});
        ((out_.text += "f ") += rest) += '\n';
        ++out_.faces;
    }

    ObjText out_;
    std::string material_, name_;
    std::vector<int> corners_;
};

}  // namespace

ObjText clean_obj(std::string_view source) {
    Cleaner cleaner(source);
    std::string joined;  // a line that goes on after a backslash
    while (!source.empty()) {
        const std::size_t end = std::min(source.find('\n'), source.size());
        std::string_view line = source.substr(0, end);
        source.remove_prefix(std::min(end + 1, source.size()));
        while (!line.empty() && line.back() == '\r') line.remove_suffix(1);
        if (line.ends_with('\\')) {
            (joined += line.substr(0, line.size() - 1)) += ' ';
            continue;
        }
        if (joined.empty()) {
            cleaner.line(line);
        } else {
            cleaner.line(joined += line);
            joined.clear();
        }
    }
    if (!joined.empty()) cleaner.line(joined);
    return cleaner.take();
}

}  // namespace lapfx::organ
