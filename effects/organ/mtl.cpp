#include "organ/mtl.h"

#include <map>
#include <set>
#include <sstream>

#include "lapfx/authoring/letters.h"
#include "organ/file.h"
#include "organ/obj_text.h"
#include "organ/pack.h"
#include "organ/soup.h"
#include "organ/texture_files.h"

namespace lapfx::organ {

namespace fs = std::filesystem;

namespace {

std::string trimmed(const std::string& text) {
    const std::size_t first = text.find_first_not_of(" \t\r\n");
    if (first == std::string::npos) return {};
    return text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
}

/// What the options of a map statement say.
struct MapOptions {
    float bump = 1.0F;
    Wrap wrap = Wrap::repeat;
};

/// Reads them, up to the file name: "-s 1 1 1 -bm 0.5 my texture.png".
MapOptions read_options(std::istringstream& line) {
    MapOptions options;
    std::string word;
    std::streampos before = line.tellg();
    while (line >> word && word.size() > 1 && word[0] == '-' && std::isalpha(static_cast<unsigned char>(word[1]))) {
        const int values = word == "-mm" ? 2 : word == "-o" || word == "-s" || word == "-t" ? 3 : 1;
        for (int i = 0; i < values; ++i) {
            before = line.tellg();
            std::string value;
            if (!(line >> value)) return options;  // it names no file
            // -o, -s and -t may have fewer numbers than three.
            const bool number = !value.empty() && value.find_first_not_of("+-.0123456789eE") == std::string::npos;
            if (i > 0 && values == 3 && !number) {
                line.seekg(before);
                break;
            }
            if (word == "-bm" && number) options.bump = std::strtof(value.c_str(), nullptr);
            if (word == "-clamp") options.wrap = lower(value) == "on" ? Wrap::clamp : Wrap::repeat;
        }
        before = line.tellg();
    }
    line.clear();
    line.seekg(before);
    return options;
}

/// The file name that follows them.
std::string map_name(std::istringstream& line) {
    std::string rest;
    std::getline(line, rest);
    return trimmed(rest.substr(0, rest.find(" #")));  // a comment, not a "#" within the name
}

class Library {
  public:
    Library(fs::path folder, RawOrgan& organ) : organ_(organ), textures_(std::move(folder), organ) {}

    void read(const std::string& text) {
        const char end_of_line = line_end(text);
        std::istringstream lines(text);
        for (std::string line; std::getline(lines, line, end_of_line);) {
            std::istringstream words(line);
            std::string key;
            if (words >> key && key[0] != '#') statement(lower(key), words);
        }
        current_ = -1;
    }

  private:
    void statement(const std::string& key, std::istringstream& words) {
        if (key == "newmtl") {
            Material material;
            std::getline(words, material.name);
            material.name = trimmed(material.name);
            organ_.materials.push_back(material);
            current_ = static_cast<int>(organ_.materials.size()) - 1;
            return;
        }
        if (current_ < 0) return;
        Material& material = organ_.materials[static_cast<std::size_t>(current_)];
        float value = 0.0f;
        if (key == "kd") {
            glm::vec4 color(0.0f, 0.0f, 0.0f, 1.0f);
            // Many exporters write black where a texture gives the colour.
            if (words >> color.x >> color.y >> color.z && color != glm::vec4(0, 0, 0, 1))
                material.base_color =
                    glm::vec4(glm::vec3(linear_color(glm::clamp(color, 0.0f, 1.0f))), material.base_color.a);
        } else if (key == "pr") {
            if (words >> value) material.roughness = std::clamp(value, 0.0f, 1.0f);
        } else if (key == "ns") {
            // Phong's exponent as a roughness, converted as most readers do.
            if (words >> value && value >= 0.0f) material.roughness = std::sqrt(2.0f / (value + 2.0f));
        } else if (key == "map_kd") {
            const MapOptions options = read_options(words);
            material.base_color_image = textures_.read(map_name(words), options.wrap);
        } else if (key == "norm" || key == "map_kn") {
            const MapOptions options = read_options(words);
            material.normal_image = textures_.read(map_name(words), options.wrap);
            material.normal_scale = options.bump;
        } else if (key == "map_bump" || key == "bump" || key == "map_normal") {
            const MapOptions options = read_options(words);
            bump(material, map_name(words), options);
        }
    }

    /// According to the specification "bump" is a height map, but most files mean a normal map. The pixels show which.
    void bump(Material& material, const std::string& name, const MapOptions& options) {
        if (material.normal_image >= 0) return;
        const int index = textures_.read(name, options.wrap);
        if (index < 0) return;
        const auto [known, is_new] = is_normal_map_.try_emplace(index, false);
        if (is_new) {
            known->second = is_normal_map(organ_.images[static_cast<std::size_t>(index)]);
            if (!known->second)
                organ_.warnings.push_back("texture " + name + " is a height map; only normal maps are read");
        }
        if (!known->second) return;
        material.normal_image = index;
        material.normal_scale = options.bump;
    }

    static bool is_normal_map(const Image& pixels) {
        std::size_t bluish = 0, count = 0;
        for (std::size_t i = 0; i + 3 < pixels.pixels.size(); i += 4 * 61, ++count)
            bluish += pixels.pixels[i + 2] > pixels.pixels[i] + 20;
        return bluish * 2 > count;
    }

    RawOrgan& organ_;
    TextureFiles textures_;
    std::map<int, bool> is_normal_map_;  ///< of images that "bump" names
    int current_ = -1;
};

}  // namespace

void read_mtl(const std::vector<std::string>& libraries, const fs::path& folder, RawOrgan& organ) {
    Library library(folder, organ);
    std::set<std::string> names;
    std::set<fs::path> paths;
    for (const std::string& name : libraries) {
        if (!names.insert(name).second) continue;
        const auto leave_out = [&](const std::string& reason) {
            organ.warnings.push_back("material library " + name + ": " + reason);
        };
        try {
            const fs::path path = file_beside(folder, name);
            if (!paths.insert(path).second) continue;
            try {
                const Bytes bytes = read_file(path, name);
                const std::size_t before = organ.materials.size();
                std::string storage;
                library.read(std::string(text_of(bytes, storage)));
                const bool any = organ.materials.size() > before;
                (any ? organ.files : organ.unread_files).push_back(path);
                if (!any) leave_out("contains no material");
            } catch (const Error& error) {
                organ.unread_files.push_back(path);
                leave_out(error.faults().front().reason);
            }
        } catch (const Error& error) {
            leave_out(error.faults().front().reason);
        }
    }
}

std::string pack_mtl(const std::string& text, Packing& packing) {
    static const std::set<std::string> plain{"ka", "kd", "ks", "ke", "tf",  "ns",    "ni",     "d",         "tr",
                                             "pr", "pm", "ps", "pc", "pcr", "aniso", "anisor", "sharpness", "illum"};
    static const std::set<std::string> maps{"bump", "norm", "disp", "decal", "refl"};
    std::string out;
    bool any = false;
    const char end_of_line = line_end(text);
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line, end_of_line);) {
        line = trimmed(line);
        std::istringstream words(line);
        std::string key;
        if (!(words >> key) || key[0] == '#') continue;
        key = lower(key);
        any |= key == "newmtl";
        // A name may hold a "#", but numbers end there.
        if (key == "newmtl") out += line + '\n';
        if (plain.contains(key)) out += trimmed(line.substr(0, line.find('#'))) + '\n';
        if (!key.starts_with("map_") && !maps.contains(key)) continue;
        read_options(words);
        const std::streamoff options_end = words.tellg();
        const std::string name = map_name(words);
        if (name.empty()) continue;
        const std::string options = line.substr(0, static_cast<std::size_t>(options_end)) + ' ';
        try {
            const std::string packed = packing.add_picture(file_beside(packing.folder(), name));
            if (!packed.empty()) out += options + packed + '\n';
        } catch (const Error&) {
            continue;  // it leads out of the folder, so the line is removed
        }
    }
    return any ? out : "";
}

}  // namespace lapfx::organ
