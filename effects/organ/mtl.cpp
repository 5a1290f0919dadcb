#include "organ/mtl.h"

#include <map>
#include <sstream>

#include "organ/file.h"
#include "organ/image.h"
#include "organ/soup.h"

namespace lapfx::organ {

namespace fs = std::filesystem;

namespace {

std::string trimmed(const std::string& text) {
    const std::size_t first = text.find_first_not_of(" \t\r\n");
    if (first == std::string::npos) return {};
    return text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
}

std::string lower(std::string text) {
    for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return text;
}

/// The file name behind the options of a map statement: "-s 1 1 1 -bm 0.5 my texture.png".
std::string map_file(std::istringstream& line, float& bump) {
    std::string word, rest;
    std::streampos before = line.tellg();
    while (line >> word && word.size() > 1 && word[0] == '-' && std::isalpha(static_cast<unsigned char>(word[1]))) {
        const int values = word == "-mm" ? 2 : word == "-o" || word == "-s" || word == "-t" ? 3 : 1;
        for (int i = 0; i < values; ++i) {
            before = line.tellg();
            std::string value;
            if (!(line >> value)) return {};
            // -o, -s and -t may have fewer numbers than three.
            const bool number = !value.empty() && value.find_first_not_of("+-.0123456789eE") == std::string::npos;
            if (i > 0 && values == 3 && !number) {
                line.seekg(before);
                break;
            }
            if (word == "-bm" && number) bump = std::strtof(value.c_str(), nullptr);
        }
        before = line.tellg();
    }
    line.clear();
    line.seekg(before);
    std::getline(line, rest);
    return trimmed(rest.substr(0, rest.find(" #")));  // a comment, not a "#" within the name
}

class Library {
  public:
    Library(fs::path folder, RawOrgan& organ) : folder_(std::move(folder)), organ_(organ) {}

    void read(const std::string& text) {
        std::istringstream lines(text);
        for (std::string line; std::getline(lines, line);) {
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
            // Phong's exponent as a roughness, the way most readers turn it.
            if (words >> value && value >= 0.0f) material.roughness = std::sqrt(2.0f / (value + 2.0f));
        } else if (key == "map_kd") {
            float unused = 1.0f;
            material.base_color_image = image(map_file(words, unused));
        } else if (key == "norm" || key == "map_kn") {
            material.normal_image = image(map_file(words, material.normal_scale));
        } else if (key == "map_bump" || key == "bump" || key == "map_normal") {
            float strength = 1.0f;
            bump(material, map_file(words, strength), strength);
        }
    }

    /// "bump" is a height map by the book, but most files mean a normal map: the pixels tell.
    void bump(Material& material, const std::string& name, float strength) {
        if (material.normal_image >= 0) return;
        const int index = image(name);
        if (index < 0) return;
        const Image& pixels = organ_.images[static_cast<std::size_t>(index)];
        std::size_t bluish = 0, count = 0;
        for (std::size_t i = 0; i + 3 < pixels.pixels.size(); i += 4 * 61, ++count)
            bluish += pixels.pixels[i + 2] > pixels.pixels[i] + 20;
        if (bluish * 2 > count) {
            material.normal_image = index;
            material.normal_scale = strength;
        } else {
            organ_.warnings.push_back("texture " + name + " is a height map; only normal maps are read");
        }
    }

    int image(const std::string& name) {
        if (name.empty()) return -1;
        if (const auto known = images_.find(name); known != images_.end()) return known->second;
        int& index = images_[name] = -1;
        Image image;
        image.name = name;
        std::string fault;
        try {
            organ_.files.push_back(path_of(name));
            fault = decode_image(read_file(path_of(name), name), image);
        } catch (const Error& error) {
            fault = error.faults().front().reason;
        }
        if (!fault.empty()) {
            organ_.warnings.push_back("texture " + name + ": " + fault + "; it is left out");
            return -1;
        }
        organ_.images.push_back(std::move(image));
        return index = static_cast<int>(organ_.images.size()) - 1;
    }

    /// Relative to the OBJ. Of an absolute path, which was right on the machine that wrote it, the last name
    /// is looked for beside the OBJ.
    fs::path path_of(std::string name) const {
        std::replace(name.begin(), name.end(), '\\', '/');
        const fs::path path = fs::path(name).lexically_normal();
        return folder_ / (path.has_root_path() || has_scheme(name) ? path.filename() : path);
    }

    fs::path folder_;
    RawOrgan& organ_;
    std::map<std::string, int> images_;
    int current_ = -1;
};

}  // namespace

void read_mtl(const std::vector<std::string>& libraries, const fs::path& folder, RawOrgan& organ) {
    Library library(folder, organ);
    for (const std::string& name : libraries) {
        try {
            organ.files.push_back(file_beside(folder, name, name, ""));
            const Bytes bytes = read_file(organ.files.back(), name);
            library.read(std::string(bytes.begin(), bytes.end()));
        } catch (const Error& error) {
            organ.warnings.push_back("material library " + name + ": " + error.faults().front().reason);
        }
    }
}

}  // namespace lapfx::organ
