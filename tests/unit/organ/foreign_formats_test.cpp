// Files of other programs: what each is, and what to export instead.
#include <gmock/gmock.h>

#include "lapfx/authoring/formats.h"
#include "unit/organ/fixtures.h"

namespace lapfx::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

TEST(ForeignFormats, EachIsKnownByNameOrBeginning) {
    const std::pair<const char*, const char*> by_name[] = {
        {"a.FBX", "is a scene of Autodesk's (FBX), which is not read: open it in Blender"},
        {"a.blend", "is a scene of Blender's, which is not read: export it as glTF (.glb) from Blender"},
        {"a.3mf", "is a model for printing (3MF), which is not read: export it as .glb, .obj or .stl"},
        {"a.usdz", "is a Universal Scene Description (USD), which is not read: open it in Blender"},
        {"a.vtk", "is a file of the Visualization Toolkit (VTK), which is not read: export its surface"},
        {"a.nrrd", "is a volume of images (NRRD), not a surface, which is not read: segment the organ"},
        {"a.nii.gz", "is a volume of images (NIfTI), not a surface, which is not read: segment the organ"},
        {"a.dcm", "is a medical image (DICOM), not a surface, which is not read: segment the organ"}};
    for (const auto& [name, text] : by_name) EXPECT_THAT(why_not_read(name, "?"), StartsWith(text)) << name;
    const std::pair<std::string, const char*> by_beginning[] = {{"Kaydara FBX Binary  ", "(FBX)"},
                                                                {"BLENDER-v300", "Blender's"},
                                                                {"PXR-USDC", "(USD)"},
                                                                {"# vtk DataFile Ver", "(VTK)"},
                                                                {"NRRD0004", "(NRRD)"},
                                                                {std::string(344, '\0') + "n+1", "(NIfTI)"},
                                                                {std::string(128, '\0') + "DICM", "(DICOM)"}};
    for (const auto& [bytes, text] : by_beginning) EXPECT_THAT(why_not_read("scan", bytes), HasSubstr(text));
    EXPECT_EQ(why_not_read("a.glb", "glTF"), "");
    EXPECT_EQ(why_not_read("a.mp4", std::string(400, '\0')), "");
}

TEST(ForeignFormats, LoadingOneSaysIt) {
    const TemporaryFolder folder;
    EXPECT_THAT(fault_of(folder.write("a.fbx", "Kaydara FBX Binary  ")),
                AllOf(StartsWith("is a scene of Autodesk's"), HasSubstr(".glb")));
    EXPECT_THAT(fault_of(folder.write("scan", std::string(128, '\0') + "DICM")), StartsWith("is a medical image"));
    EXPECT_THAT(fault_of(folder.write("a.stl", std::string(128, '\0') + "DICM")), testing::Not(HasSubstr("DICOM")));
    EXPECT_EQ(why_not_read(folder.path()), "") << "a folder";
}

}  // namespace
}  // namespace lapfx::test
