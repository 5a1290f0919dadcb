#include "organ/ply_header.h"

#include <charconv>

#include "organ/raw.h"

namespace lapfx::organ {

namespace {

struct TypeName {
    const char* name;
    PlyType type;
};
constexpr TypeName type_names[] = {
    {"char", PlyType::int8},      {"int8", PlyType::int8},       {"uchar", PlyType::uint8},
    {"uint8", PlyType::uint8},    {"short", PlyType::int16},     {"int16", PlyType::int16},
    {"ushort", PlyType::uint16},  {"uint16", PlyType::uint16},   {"int", PlyType::int32},
    {"int32", PlyType::int32},    {"uint", PlyType::uint32},     {"uint32", PlyType::uint32},
    {"float", PlyType::float32},  {"float32", PlyType::float32}, {"double", PlyType::float64},
    {"float64", PlyType::float64}};

std::vector<std::string> words_of(std::string_view line) {
    std::vector<std::string> words;
    std::size_t at = 0;
    while ((at = line.find_first_not_of(" \t\r", at)) != std::string_view::npos) {
        const std::size_t end = std::min(line.find_first_of(" \t\r", at), line.size());
        words.emplace_back(line.substr(at, end - at));
        at = end;
    }
    return words;
}

class HeaderReader {
  public:
    HeaderReader(const std::string& file, std::string_view text) : file_(file), text_(text) {}

    PlyHeader read() {
        // Lines end in LF, CR LF or, from some programs, CR alone. The first line shows which.
        if (text_.starts_with("ply\r") && !text_.starts_with("ply\r\n")) line_end_ = '\r';
        if (next() != std::vector<std::string>{"ply"}) wrong("a PLY starts with the line ply");
        bool format_read = false;
        while (true) {
            const std::vector<std::string> words = next();
            if (words.empty() || words[0] == "obj_info") continue;
            if (words[0] == "comment") {
                if (words.size() > 2 && words[1] == "TextureFile") texture();
                continue;
            }
            if (words[0] == "end_header") break;
            if (words[0] == "format") {
                format(words);
                format_read = true;
                continue;
            }
            if (!format_read) wrong("the format has to come first");
            if (words[0] == "element")
                element(words);
            else if (words[0] == "property")
                property(words);
            else
                wrong("\"" + words[0] + "\" is not known in a PLY header");
        }
        if (!format_read) wrong("the format is missing");
        header_.size = at_;
        return std::move(header_);
    }

  private:
    [[noreturn]] void wrong(const std::string& reason) const { refuse(file_, "line " + std::to_string(line_), reason); }

    std::vector<std::string> next() {
        const std::size_t end = text_.find(line_end_, at_);
        ++line_;
        if (end == std::string_view::npos || end - at_ > 4096) wrong("truncated: the header has no end_header");
        line_text_ = text_.substr(at_, end - at_);
        at_ = end + 1;
        return words_of(line_text_);
    }

    /// The rest of the line, which may hold spaces.
    void texture() {
        constexpr std::string_view key = "TextureFile", spaces = " \t\r";
        const std::size_t first = line_text_.find_first_not_of(spaces, line_text_.find(key) + key.size());
        const std::size_t last = line_text_.find_last_not_of(spaces);
        header_.textures.push_back({.name = std::string(line_text_.substr(first, last + 1 - first)),
                                    .at = static_cast<std::size_t>(line_text_.data() - text_.data()) + first});
    }

    PlyType type(const std::string& name) const {
        for (const TypeName& known : type_names)
            if (name == known.name) return known.type;
        wrong("type \"" + name + "\" is not known");
    }

    void format(const std::vector<std::string>& words) {
        if (words.size() != 3) wrong("the format has to be a coding and a version");
        if (words[1] == "ascii")
            header_.coding = PlyCoding::text;
        else if (words[1] == "binary_little_endian")
            header_.coding = PlyCoding::little_endian;
        else if (words[1] == "binary_big_endian")
            header_.coding = PlyCoding::big_endian;
        else
            wrong("format \"" + words[1] + "\" is not known");
        if (words[2] != "1.0") wrong("version " + words[2] + " is not read, only 1.0");
    }

    void element(const std::vector<std::string>& words) {
        if (words.size() != 3) wrong("an element has to have a name and a count");
        PlyElement element;
        element.name = words[1];
        const char* end = words[2].data() + words[2].size();
        const auto [stop, code] = std::from_chars(words[2].data(), end, element.count);
        if (code != std::errc() || stop != end) wrong("\"" + words[2] + "\" is not a count");
        header_.elements.push_back(element);
    }

    void property(const std::vector<std::string>& words) {
        if (header_.elements.empty()) wrong("a property has to follow an element");
        PlyProperty property;
        const bool list = words.size() > 1 && words[1] == "list";
        if (words.size() != (list ? 5u : 3u)) wrong("a property has to have a type and a name");
        property.is_list = list;
        if (list) {
            property.count_type = type(words[2]);
            if (property.count_type == PlyType::float32 || property.count_type == PlyType::float64)
                wrong("a list cannot have a " + words[2] + " count");
        }
        property.type = type(words[list ? 3 : 1]);
        property.name = words.back();
        header_.elements.back().properties.push_back(property);
    }

    const std::string& file_;
    std::string_view text_, line_text_;
    char line_end_ = '\n';
    std::size_t at_ = 0, line_ = 0;
    PlyHeader header_;
};

}  // namespace

int PlyElement::find(std::string_view property) const {
    for (std::size_t i = 0; i < properties.size(); ++i)
        if (properties[i].name == property) return static_cast<int>(i);
    return -1;
}

std::size_t size_of(PlyType type) {
    switch (type) {
        case PlyType::int8:
        case PlyType::uint8:
            return 1;
        case PlyType::int16:
        case PlyType::uint16:
            return 2;
        case PlyType::float64:
            return 8;
        default:
            return 4;
    }
}

PlyHeader read_ply_header(const std::string& file, std::string_view text) {
    return HeaderReader(file, text).read();
}

}  // namespace lapfx::organ
