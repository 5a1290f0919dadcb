// One table of formats: loading, dialogs, drops, exports and help agree about every file.
#include <gtest/gtest.h>

#include <set>

#include "app/base/file_filters.h"
#include "app/browser/file_previews.h"
#include "app/files/open.h"
#include "lapfx/authoring/pack.h"
#include "output/files.h"
#include "unit/organ/fixtures.h"

namespace lapfx::test {
namespace {

constexpr Content contents[] = {Content::mesh, Content::video, Content::picture, Content::document};

TEST(Formats, EveryExtensionAndNameIsOfOneFormat) {
    std::set<std::string_view> names, extensions;
    for (const Content content : contents)
        for (const FileFormat& format : formats(content)) {
            EXPECT_EQ(format.content, content);
            EXPECT_TRUE(names.insert(format.name).second) << format.name;
            EXPECT_FALSE(format.holds.empty()) << format.name;
            ASSERT_FALSE(format.extensions.empty()) << format.name;
            for (const std::string_view extension : format.extensions) {
                EXPECT_TRUE(extensions.insert(extension).second) << extension;
                EXPECT_EQ(extension.front(), '.');
                std::string upper(extension);
                for (char& c : upper) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
                EXPECT_EQ(format_named("a/b.c" + upper), &format);
            }
        }
    EXPECT_EQ(format_named("liver"), nullptr);
    EXPECT_EQ(format_named("liver.step"), nullptr);
}

TEST(Formats, AFileIsKnownByWhatItBeginsWith) {
    EXPECT_EQ(format_beginning("glTF\2\0\0\0")->extensions.front(), ".glb");
    EXPECT_EQ(format_beginning("ply\r\n")->name, "PLY");
    EXPECT_EQ(format_beginning("\x89PNG\r\n")->name, "PNG");
    EXPECT_EQ(format_beginning("RIFF1234WEBP")->name, "WebP");
    EXPECT_EQ(format_beginning("RIFF1234WAVE"), nullptr);
    EXPECT_EQ(format_beginning("RIFF"), nullptr);
}

TEST(Formats, WhatLoadsIsDroppedShownAndAskedForAsAMesh) {
    const TemporaryFolder folder;
    const std::vector<std::string> in_dialog = app::mesh_filter().extensions;
    for (const char* name : {"cube.stl", "cube.stla", "cube.stlb", "cube.STLA"}) {
        const auto file = folder.write(name, std::string("solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n"
                                                         "vertex 9 0 0\nvertex 0 9 0\nendloop\nendfacet\nendsolid\n"));
        EXPECT_EQ(load_organ(file).triangle_count(), 1U) << name;
        EXPECT_EQ(app::kind_of(file), app::FileKind::organ) << name;
        EXPECT_TRUE(app::has_picture(file.string())) << name;
        EXPECT_EQ(pack_organ(file).front().name, "cube.stl") << name;
    }
    EXPECT_TRUE(std::ranges::count(in_dialog, ".stla"));
    EXPECT_EQ(listed(Content::mesh), ".glb, .gltf, .obj, .ply, .stl or .off");
}

TEST(Formats, WhatIsWrittenIsRead) {
    EXPECT_EQ(listed(Content::video, " or ", true), ".mp4, .mov, .mkv or .avi");
    for (const std::string& extension : extensions(Content::video, true))
        EXPECT_TRUE(output::is_video_name("out" + extension)) << extension;
    EXPECT_FALSE(output::is_video_name("out.webm")) << "read, not written";
    EXPECT_EQ(app::open_filters().front().extensions.size(),
              extensions(Content::mesh).size() + extensions(Content::video).size() +
                  extensions(Content::picture).size() + extensions(Content::document).size());
}

}  // namespace
}  // namespace lapfx::test
