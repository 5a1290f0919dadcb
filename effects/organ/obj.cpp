#include "organ/obj.h"

#include <map>

#include "organ/mtl.h"
#include "organ/obj_text.h"
#include "organ/openmesh_reader.h"

namespace lapfx::organ {

namespace {

/// One part for each material of each object, in the order of the file.
std::vector<RawPart> named_parts(const ObjText& text, const RawOrgan& organ, Soup& soup) {
    std::map<std::string, int> materials;
    for (std::size_t i = 0; i < organ.materials.size(); ++i)
        materials.emplace(organ.materials[i].name, static_cast<int>(i));
    std::map<std::pair<std::string, std::string>, std::uint32_t> known;
    std::vector<RawPart> parts;
    for (std::size_t r = 0; r < text.runs.size(); ++r) {
        const ObjText::Run& run = text.runs[r];
        const std::size_t end = r + 1 < text.runs.size() ? text.runs[r + 1].first_face : text.faces;
        const auto [place, is_new] =
            known.try_emplace({run.material, run.name}, static_cast<std::uint32_t>(parts.size()));
        if (is_new) {
            RawPart& part = parts.emplace_back();
            part.name = !run.name.empty() ? run.name : run.material;
            if (const auto found = materials.find(run.material); found != materials.end())
                part.material = found->second;
        }
        soup.face_part.insert(soup.face_part.end(), end - run.first_face, place->second);
    }
    return parts;
}

/// Names that usemtl uses and no library has, once each.
void warn_of_missing_materials(const ObjText& text, RawOrgan& organ) {
    std::map<std::string, bool> missing;
    for (const ObjText::Run& run : text.runs)
        if (!run.material.empty()) missing[run.material] = true;
    for (const Material& material : organ.materials) missing.erase(material.name);
    for (const auto& [name, unused] : missing)
        organ.warnings.push_back("material " + name + " is not in a material library; drawn plain");
}

/// Colours from 0 to 255 where 0 to 1 is usual.
void scale_colors(Soup& soup) {
    const bool bytes = std::any_of(soup.colors.begin(), soup.colors.end(),
                                   [](const glm::vec4& c) { return c.x > 1.5f || c.y > 1.5f || c.z > 1.5f; });
    if (bytes)
        for (glm::vec4& c : soup.colors) c = glm::vec4(glm::vec3(c) / 255.0f, c.a);
}

}  // namespace

RawOrgan read_obj(const std::filesystem::path& path, const std::string& file, const Bytes& bytes) {
    const std::string_view source(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    if (source.find('\0') != std::string_view::npos) refuse(file, "", "is no OBJ: it is not a text file");
    const ObjText text = clean_obj(source);
    RawOrgan organ;
    Soup soup;
    if (!read_with_openmesh(OpenMeshFormat::obj, text.text, soup)) refuse(file, "", "cannot be read as OBJ");
    read_mtl(text.libraries, path.parent_path(), organ);
    warn_of_missing_materials(text, organ);
    if (text.bad_faces > 0)
        organ.warnings.push_back(counted(text.bad_faces, "face", "faces") + " without 3 readable corners left out");
    if (text.flat_faces > 0)
        organ.warnings.push_back(counted(text.flat_faces, "face names", "faces name") +
                                 " less than 3 different vertices; left out");
    scale_colors(soup);
    std::vector<RawPart> parts = named_parts(text, organ, soup);
    if (soup.face_part.size() != soup.faces()) {
        soup.face_part.clear();
        parts.resize(std::min<std::size_t>(parts.size(), 1));
    }
    organ.parts = parts_of(soup, std::move(parts));
    return organ;
}

}  // namespace lapfx::organ
