// Formats that people bring along with organs, and that are not read: what each is, and what to export instead.
#include <algorithm>
#include <fstream>

#include "lapfx/authoring/formats.h"
#include "lapfx/authoring/letters.h"

namespace lapfx {

namespace {

struct ForeignFormat {
    std::string_view is;                        ///< "a scene of Blender's"
    std::string_view instead;                   ///< what to do instead
    std::span<const std::string_view> endings;  ///< endings of names, in lower case
    std::span<const Signature> signatures = {};
};

constexpr std::string_view as_gltf = "export it as glTF (.glb) from the program that made it";
constexpr std::string_view from_blender = "open it in Blender and export it as glTF (.glb)";
constexpr std::string_view from_3d = "export it as .glb, .obj or .stl from the program that made it";
constexpr std::string_view from_paraview =
    "export its surface as .ply, .obj or .stl, for instance from ParaView or 3D Slicer";
constexpr std::string_view segment =
    "segment the organ, for instance in 3D Slicer, and export the segment as .obj or .stl";
constexpr std::string_view from_slicer = "export its surface as .obj or .stl from 3D Slicer";
constexpr std::string_view from_cad = "export it as .stl or .obj from the CAD program";

constexpr std::string_view fbx[] = {".fbx"}, blend[] = {".blend"}, usd[] = {".usdz", ".usd", ".usdc", ".usda"},
                           threemf[] = {".3mf"}, collada[] = {".dae"}, vtk[] = {".vtk", ".vtp", ".vtu", ".vti"},
                           nrrd[] = {".nrrd", ".nhdr"}, nifti[] = {".nii", ".nii.gz"}, dicom[] = {".dcm", ".dicom"},
                           meta[] = {".mha", ".mhd"}, slicer[] = {".mrb", ".mrml"}, max[] = {".max", ".3ds"},
                           maya[] = {".ma", ".mb"}, cinema[] = {".c4d"}, alembic[] = {".abc"},
                           vrml[] = {".wrl", ".x3d"}, cad[] = {".step", ".stp", ".iges", ".igs"};
constexpr Signature fbx_begins[] = {{"Kaydara FBX Binary"}, {"; FBX "}}, blend_begins[] = {{"BLENDER"}},
                    usd_begins[] = {{"PXR-USDC"}, {"#usda"}}, vtk_begins[] = {{"# vtk DataFile"}},
                    nrrd_begins[] = {{"NRRD0"}}, nifti_begins[] = {{"n+1", 344}, {"n+2", 4}, {"ni1", 344}},
                    dicom_begins[] = {{"DICM", 128}}, vrml_begins[] = {{"#VRML"}}, cad_begins[] = {{"ISO-10303-21"}};

constexpr ForeignFormat rows[] = {
    {"a scene of Autodesk's (FBX)", from_blender, fbx, fbx_begins},
    {"a scene of Blender's", "export it as glTF (.glb) from Blender", blend, blend_begins},
    {"a model for printing (3MF)", from_3d, threemf},
    {"a Universal Scene Description (USD)", from_blender, usd, usd_begins},
    {"a COLLADA scene", from_blender, collada},
    {"a file of the Visualization Toolkit (VTK)", from_paraview, vtk, vtk_begins},
    {"a volume of images (NRRD), not a surface", segment, nrrd, nrrd_begins},
    {"a volume of images (NIfTI), not a surface", segment, nifti, nifti_begins},
    {"a medical image (DICOM), not a surface", segment, dicom, dicom_begins},
    {"a volume of images (MetaImage), not a surface", segment, meta},
    {"a scene of 3D Slicer's", from_slicer, slicer},
    {"a scene of 3ds Max's", as_gltf, max},
    {"a scene of Maya's", as_gltf, maya},
    {"a scene of Cinema 4D's", as_gltf, cinema},
    {"a scene of Alembic's", from_blender, alembic},
    {"a VRML or X3D scene", from_blender, vrml, vrml_begins},
    {"a CAD model (STEP or IGES)", from_cad, cad, cad_begins},
};

bool begins(const ForeignFormat& format, std::string_view bytes) {
    return std::ranges::any_of(format.signatures, [&](const Signature& signature) {
        return bytes.size() > signature.at && bytes.substr(signature.at).starts_with(signature.text);
    });
}

bool is_named(const ForeignFormat& format, std::string_view name) {
    return std::ranges::any_of(format.endings, [&](std::string_view ending) { return name.ends_with(ending); });
}

}  // namespace

std::string why_not_read(const std::filesystem::path& file, std::string_view begin) {
    const std::string name = lower(file.filename().string());
    const ForeignFormat* found = std::ranges::find_if(rows, [&](const auto& row) { return begins(row, begin); });
    if (found == std::end(rows))
        found = std::ranges::find_if(rows, [&](const auto& row) { return is_named(row, name); });
    return found == std::end(rows)
               ? std::string()
               : "is " + std::string(found->is) + ", which is not read: " + std::string(found->instead);
}

std::string why_not_read(const std::filesystem::path& file) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(file, error)) return {};  // opening a pipe would wait for its writer
    std::ifstream in(file, std::ios::binary);
    std::string begin(512, '\0');
    in.read(begin.data(), static_cast<std::streamsize>(begin.size()));
    begin.resize(static_cast<std::size_t>(in.gcount()));
    return why_not_read(file, begin);
}

}  // namespace lapfx
