#include "organ/obj.h"

#include <map>
#include <set>

#include "organ/mtl.h"
#include "organ/obj_text.h"

namespace lapfx::organ {

namespace {

/// A name may hold a "#" ("Material #25"), or a comment may follow it.
std::string without_comment(const std::string& name) {
    const std::size_t end = name.find(" #");
    return end == std::string::npos ? name : name.substr(0, name.find_last_not_of(" \t", end) + 1);
}

/// Materials by name; the whole name is tried first.
class MaterialNames {
  public:
    explicit MaterialNames(const std::vector<Material>& materials) {
        for (std::size_t i = 0; i < materials.size(); ++i) known_.emplace(materials[i].name, static_cast<int>(i));
        for (std::size_t i = 0; i < materials.size(); ++i)
            known_.emplace(without_comment(materials[i].name), static_cast<int>(i));
    }
    /// -1: there is none.
    int find(const std::string& name) const {
        for (const std::string& form : {name, without_comment(name)})
            if (const auto found = known_.find(form); found != known_.end()) return found->second;
        return -1;
    }

  private:
    std::map<std::string, int> known_;
};

/// One part for each material of each object, in the order of the file.
std::vector<RawPart> named_parts(const ObjText& text, const MaterialNames& materials, Soup& soup) {
    std::map<std::pair<std::string, std::string>, std::uint32_t> known;
    std::vector<RawPart> parts;
    for (std::size_t r = 0; r < text.runs.size(); ++r) {
        const ObjText::Run& run = text.runs[r];
        const std::size_t end = r + 1 < text.runs.size() ? text.runs[r + 1].first_face : soup.faces();
        const auto [place, is_new] =
            known.try_emplace({run.material, run.name}, static_cast<std::uint32_t>(parts.size()));
        if (is_new) {
            RawPart& part = parts.emplace_back();
            part.name = !run.name.empty() ? run.name : run.material;
            part.material = materials.find(run.material);
        }
        soup.face_part.insert(soup.face_part.end(), end - run.first_face, place->second);
    }
    return parts;
}

/// Names in usemtl that no library has, each once.
void warn_of_missing_materials(const ObjText& text, const MaterialNames& materials, RawOrgan& organ) {
    std::set<std::string> missing;
    for (const ObjText::Run& run : text.runs)
        if (!run.material.empty() && materials.find(run.material) < 0) missing.insert(run.material);
    for (const std::string& name : missing)
        organ.warnings.push_back("material " + name +
                                 " is not in a material library; drawn without colour and texture");
}

/// Colours from 0 to 255 where 0 to 1 is usual; then linear.
void settle_colors(Soup& soup) {
    const bool bytes = std::any_of(soup.colors.begin(), soup.colors.end(),
                                   [](const glm::vec4& c) { return c.x > 1.5f || c.y > 1.5f || c.z > 1.5f; });
    if (bytes)
        for (glm::vec4& c : soup.colors) c = glm::vec4(glm::vec3(c) / 255.0f, c.a);
    for (glm::vec4& c : soup.colors) c = linear_color(c);
}

}  // namespace

RawOrgan read_obj(const std::filesystem::path& path, const std::string& file, const Bytes& bytes) {
    std::string storage;
    const std::string_view source = text_of(bytes, storage);
    if (source.find('\0') != std::string_view::npos) refuse(file, "", "is not an OBJ: it is not a text file");
    ObjText text = read_obj_text(source);
    RawOrgan organ;
    read_mtl(text.libraries, path.parent_path(), organ);
    const MaterialNames materials(organ.materials);
    warn_of_missing_materials(text, materials, organ);
    settle_colors(text.soup);
    add_parts(text.soup, named_parts(text, materials, text.soup), organ);
    return organ;
}

}  // namespace lapfx::organ
