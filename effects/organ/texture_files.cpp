#include "organ/texture_files.h"

#include <exception>

#include "lapfx/authoring/file.h"
#include "organ/file.h"

namespace lapfx::organ {

namespace fs = std::filesystem;

namespace {

/// A name with more folders is not looked for without each of them: it could keep us busy.
constexpr int most_tails = 16;

}  // namespace

fs::path file_beside(const fs::path& folder, std::string name) {
    std::replace(name.begin(), name.end(), '\\', '/');
    fs::path named;
    std::exception_ptr fault;
    std::string_view tail = name;
    for (int i = 0; i < most_tails; ++i) {
        try {
            const fs::path path = named_path(folder, tail);
            std::error_code error;
            if (fs::exists(path, error)) return path;
            if (i == 0) named = path;
        } catch (const Error&) {
            if (i == 0) fault = std::current_exception();
        }
        const std::size_t slash = tail.find('/');
        if (slash == std::string_view::npos) break;
        tail.remove_prefix(slash + 1);
    }
    if (fault) std::rethrow_exception(fault);
    return named;
}

std::string TextureFiles::decode(const fs::path& path, Image& image, Encoded& encoded) {
    try {
        encoded = std::make_shared<const Bytes>(read_file(path, image.name));
        return decode_texture(*encoded, image, organ_.warnings);
    } catch (const Error& error) {
        return error.faults().front().reason;
    }
}

int TextureFiles::read_new(const fs::path& path, const std::string& name) {
    Image image;
    image.name = name;
    Encoded encoded;
    const std::string fault = decode(path, image, encoded);
    (fault.empty() ? organ_.files : organ_.unread_files).push_back(path);
    if (!fault.empty()) {
        organ_.warnings.push_back("texture " + name + ": " + fault + "; it is left out");
        return -1;
    }
    organ_.images.push_back(std::move(image));
    organ_.encoded.push_back(std::move(encoded));
    return static_cast<int>(organ_.images.size()) - 1;
}

int TextureFiles::read(const std::string& name, Wrap wrap) {
    if (name.empty()) return -1;
    const auto [known, is_new_name] = by_name_.try_emplace({name, wrap}, -1);
    if (!is_new_name) return known->second;
    try {
        const fs::path path = file_beside(folder_, name);
        std::map<Wrap, int>& same = by_path_[path];
        if (const auto found = same.find(wrap); found != same.end()) return known->second = found->second;
        const int index = same.empty() ? read_new(path, name) : copy_image(organ_, same.begin()->second);
        if (index >= 0) organ_.images[static_cast<std::size_t>(index)].wrap_u = wrap;
        if (index >= 0) organ_.images[static_cast<std::size_t>(index)].wrap_v = wrap;
        return known->second = same[wrap] = index;
    } catch (const Error& error) {
        organ_.warnings.push_back("texture " + name + ": " + error.faults().front().reason + "; it is left out");
        return -1;
    }
}

}  // namespace lapfx::organ
