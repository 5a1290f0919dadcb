// An OBJ that names the libraries that are packed with it; all other lines are as they were.
#include <string>
#include <string_view>

#include "lapfx/error.h"
#include "lapfx/file.h"
#include "organ/pack.h"

namespace lapfx::organ {

namespace {

std::string trimmed(std::string_view text) {
    constexpr std::string_view spaces = " \t\r\v\f";
    const std::size_t first = text.find_first_not_of(spaces);
    if (first == std::string_view::npos) return {};
    return std::string(text.substr(first, text.find_last_not_of(spaces) - first + 1));
}

/// What a line of the statement mtllib names; empty: it is another one.
std::string library_of(std::string_view line) {
    constexpr std::string_view key = "mtllib";
    const std::string text = trimmed(line.substr(0, line.find('#')));
    return text.size() > key.size() && text.starts_with(key) &&
                   std::string_view(" \t").find(text[key.size()]) != std::string_view::npos
               ? trimmed(std::string_view(text).substr(key.size()))
               : "";
}

/// Its name in the pack; empty: it is none that can be read.
std::string pack_library(const std::string& name, Packing& packing) {
    try {
        const std::filesystem::path path = named_path(packing.folder(), name);
        const Bytes bytes = read_file(path, name);
        const std::string text = pack_mtl(std::string(bytes.begin(), bytes.end()), packing);
        return text.empty() ? "" : packing.add(path, ".mtl", Bytes(text.begin(), text.end()));
    } catch (const Error&) {
        return {};  // loading tells why
    }
}

/// Up to the end of a line, of all that go on after a backslash; `joined` is what they say together.
std::string_view next_statement(std::string_view& rest, std::string& joined) {
    joined.clear();
    const std::string_view from = rest;
    while (!rest.empty()) {
        const std::size_t end = std::min(rest.find('\n'), rest.size());
        std::string_view line = rest.substr(0, end);
        rest.remove_prefix(std::min(end + 1, rest.size()));
        while (!line.empty() && line.back() == '\r') line.remove_suffix(1);
        const bool goes_on = line.ends_with('\\');
        joined += goes_on ? line.substr(0, line.size() - 1) : line;
        if (!goes_on) break;
        joined += ' ';
    }
    return from.substr(0, from.size() - rest.size());
}

}  // namespace

Bytes pack_obj(const Bytes& bytes, Packing& packing) {
    std::string_view rest(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    Bytes out;
    out.reserve(bytes.size());
    const auto put = [&](std::string_view text) { out.insert(out.end(), text.begin(), text.end()); };
    for (std::string joined; !rest.empty();) {
        const std::string_view statement = next_statement(rest, joined);
        const std::string library = library_of(joined);
        if (library.empty())
            put(statement);
        else if (const std::string name = pack_library(library, packing); !name.empty())
            put("mtllib " + name + '\n');
    }
    return out;
}

}  // namespace lapfx::organ
