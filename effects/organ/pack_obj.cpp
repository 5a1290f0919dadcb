// An OBJ that names the libraries packed with it; all other lines stay the same.
#include <map>
#include <string>
#include <string_view>

#include "lapfx/error.h"
#include "organ/obj_text.h"
#include "organ/pack.h"
#include "organ/texture_files.h"

namespace lapfx::organ {

namespace {

/// Its name in the pack; empty: the library cannot be read.
std::string pack_library(const std::string& name, Packing& packing) {
    try {
        const std::filesystem::path path = file_beside(packing.folder(), name);
        if (const auto known = packing.known(PackedKind::library, path)) return *known;
        packing.leave_out(PackedKind::library, path);  // unless it can be read
        const Bytes bytes = read_file(path, name);
        std::string storage;
        const std::string text = pack_mtl(std::string(text_of(bytes, storage)), packing);
        if (!text.empty()) return packing.add(PackedKind::library, path, ".mtl", Bytes(text.begin(), text.end()));
    } catch (const Error&) {  // loading tells why
    }
    return {};
}

/// Reads to the end of a line, including lines continued after a backslash; `joined` is their whole text.
std::string_view next_statement(std::string_view& rest, char end_of_line, std::string& joined) {
    joined.clear();
    const std::string_view from = rest;
    while (!rest.empty()) {
        const std::size_t end = std::min(rest.find(end_of_line), rest.size());
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
    std::string storage;
    std::string_view rest = text_of(bytes, storage);
    const char end_of_line = line_end(rest);
    Bytes out;
    out.reserve(bytes.size());
    const auto put = [&](std::string_view text) { out.insert(out.end(), text.begin(), text.end()); };
    std::map<std::string, std::string> names;  ///< names of libraries in the pack, by their old names
    for (std::string joined; !rest.empty();) {
        const std::string_view statement = next_statement(rest, end_of_line, joined);
        const std::vector<std::string> libraries = libraries_of(joined);
        if (libraries.empty()) put(statement);
        for (const std::string& library : libraries) {
            const auto [known, is_new] = names.try_emplace(library);
            if (is_new) known->second = pack_library(library, packing);
            if (!known->second.empty()) put("mtllib " + known->second + end_of_line);
        }
    }
    return out;
}

}  // namespace lapfx::organ
