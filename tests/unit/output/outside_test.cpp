// Every place that takes a path from outside: a file from somebody else reaches nothing beyond its folder, and its
// bundle is written only into the bundle.
#include <gmock/gmock.h>

#include <opencv2/imgcodecs.hpp>

#include "app/base/settings.h"
#include "app/browser/thumbnail_maker.h"
#include "document/keep.h"
#include "lapfx/authoring/clip.h"
#include "lapfx/authoring/file.h"
#include "lapfx/authoring/pack.h"
#include "lapfx/organ.h"
#include "output/bundle.h"
#include "support/clips.h"
#include "unit/organ/gltf_fixtures.h"
#include "unit/preset/support.h"

namespace lapfx::output {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

constexpr const char* triangle_obj = "v 0 0 0\nv 9 0 0\nv 0 9 0\nvt 0 0\nvt 1 0\nvt 0 1\nusemtl m\nf 1/1 2/2 3/3\n";
constexpr const char* private_key = "-----BEGIN OPENSSH PRIVATE KEY-----\nb3BlbnNzaC1rZXktdjEAAAAA\n";

/// A user's folders, with a case that was downloaded: home/Downloads/case.
class Outside : public testing::Test {
  protected:
    void SetUp() override {
        for (const char* name : {"home/.ssh", "home/.config/autostart", "home/Downloads/case/maps", "home/Desktop/out"})
            fs::create_directories(all_ / name);
        all_.write("home/.ssh/id_rsa", private_key);
        all_.write("home/.config/autostart/x.desktop", "[Desktop Entry]\nExec=true\n");
        cv::imwrite((all_ / "home/skin.png").string(), cv::Mat(8, 8, CV_8UC3, cv::Scalar(40, 80, 160)));
        fs::copy_file(all_ / "home/skin.png", case_ / "maps/own.png");
        fs::create_symlink(all_ / "home/skin.png", case_ / "link.png");
        fs::create_directory_symlink(all_ / "home", case_ / "maps/home");
        test::write_clip(all_ / "home/smoke.avi", 3);
        test::write_clip(case_ / "own.avi", 3);
        fs::create_symlink(all_ / "home/smoke.avi", case_ / "link.avi");
    }
    fs::path write(const std::string& name, const std::string& text) const {
        return all_.write("home/Downloads/case/" + name, text);
    }
    /// Names of the same outside file, from the case.
    std::vector<std::string> ways_to(const std::string& file) const {
        return {"../../" + file, "maps/../../../" + file, (all_ / ("home/" + file)).string(), "maps/home/" + file,
                "file://" + (all_ / ("home/" + file)).string()};
    }
    /// Every file and folder with its contents, except those of the bundle.
    std::vector<std::string> everything() const {
        std::vector<std::string> found;
        for (const auto& entry : fs::recursive_directory_iterator(all_.path())) {
            const std::string name = entry.path().lexically_relative(all_.path()).generic_string();
            if (name.starts_with("home/Desktop/out/")) continue;
            found.push_back(name + (entry.is_regular_file() ? "\n" + test::read_text(entry.path()) : ""));
        }
        std::sort(found.begin(), found.end());
        return found;
    }
    std::vector<std::string> bundled() const {
        std::vector<std::string> names;
        for (const auto& entry : fs::recursive_directory_iterator(out_))
            if (!entry.is_directory()) names.push_back(entry.path().lexically_relative(out_).generic_string());
        return names;
    }
    Bundle bundle(const std::string& organ) const {
        Bundle made{.preset = {}, .scene = Scene{}, .folder = out_, .clip_folders = {}, .thumbnail = {}};
        made.scene->folder = case_;
        made.scene->organ.file = organ;
        made.thumbnail = {.width = 4, .height = 4, .pixels = std::vector<std::uint8_t>(64, 90), .name = ""};
        made.preset.folder = case_;
        return made;
    }

    test::Folder all_;
    const fs::path case_ = all_ / "home/Downloads/case", out_ = all_ / "home/Desktop/out/bundle";
};

TEST_F(Outside, ATextureThatIsAKeyOrAStarterIsNeitherReadNorCopied) {
    write("organ.obj", std::string("mtllib organ.mtl\n") + triangle_obj);
    write(
        "organ.mtl",
        "newmtl m\nmap_Kd ../../.ssh/id_rsa\nmap_bump ../../../.ssh/id_rsa\nmap_Ks ../../.config/autostart/x.desktop\n"
        "norm ../../.config/autostart/x.desktop\n# a comment that stays at home\nKd 1 0 0\n");
    const Organ organ = load_organ(case_ / "organ.obj");
    EXPECT_THAT(organ.files, ElementsAre(case_ / "organ.obj", case_ / "organ.mtl"));
    EXPECT_THAT(organ.unread_files, IsEmpty());
    EXPECT_THAT(organ.warnings, Contains(AllOf(HasSubstr("id_rsa"), HasSubstr("leads out of the folder"))));

    const std::vector<std::string> before = everything();
    write_bundle(bundle("organ.obj"));
    EXPECT_EQ(everything(), before);
    EXPECT_THAT(bundled(), UnorderedElementsAre("bundle.json", "bundle.scene.json", "thumbnail.png", "organ/organ.obj",
                                                "organ/organ.mtl"));
    EXPECT_EQ(test::read_text(out_ / "organ/organ.mtl"), "newmtl m\nKd 1 0 0\n");
    EXPECT_EQ(load_organ(out_ / "organ/organ.obj").materials[0].base_color, glm::vec4(1, 0, 0, 1));
}

TEST_F(Outside, AFileInTheFolderIsKeptOnlyAsWhatItShouldBe) {
    write("id_rsa", private_key);
    write("organ.obj", std::string("mtllib organ.mtl\nmtllib id_rsa\n") + triangle_obj);
    write("organ.mtl", "newmtl m\nmap_Kd id_rsa\nmap_Ks maps/own.png\n");
    const Organ organ = load_organ(case_ / "organ.obj");
    EXPECT_THAT(organ.files, ElementsAre(case_ / "organ.obj", case_ / "organ.mtl"));
    EXPECT_THAT(organ.unread_files, ElementsAre(case_ / "id_rsa", case_ / "id_rsa"));
    EXPECT_THAT(organ.warnings, Contains("texture id_rsa: not a PNG, JPEG, WebP or BMP image; it is left out"));
    EXPECT_THAT(organ.warnings, Contains("material library id_rsa: contains no material"));
    write_bundle(bundle("organ.obj"));
    EXPECT_THAT(bundled(), UnorderedElementsAre("bundle.json", "bundle.scene.json", "thumbnail.png", "organ/organ.obj",
                                                "organ/organ.mtl", "organ/own.png"));
}

TEST_F(Outside, NoStatementOfAnObjReadsBeyondItsFolder) {
    write("own.mtl", "newmtl m\nKd 0 1 0\n");
    all_.write("home/own.mtl", "newmtl m\nKd 1 0 0\n");
    fs::remove(case_ / "own.mtl");
    for (const std::string& way : ways_to("own.mtl")) {
        const Organ organ = load_organ(write("organ.obj", "mtllib " + way + "\n" + triangle_obj));
        EXPECT_THAT(organ.files, ElementsAre(case_ / "organ.obj")) << way;
        EXPECT_THAT(organ.warnings, Contains(testing::StartsWith("material library " + way + ": \"" + way))) << way;
    }
    write("organ.obj", std::string("mtllib organ.mtl\n") + triangle_obj);
    std::vector<std::string> ways = ways_to("skin.png");
    ways.emplace_back("link.png");
    ways.emplace_back("..\\..\\skin.png");
    for (const char* key : {"map_Kd", "map_bump", "norm"})
        for (const std::string& way : ways) {
            write("organ.mtl", "newmtl m\n" + std::string(key) + " -o 0 0 0 " + way + "\n");
            const Organ organ = load_organ(case_ / "organ.obj");
            EXPECT_THAT(organ.images, IsEmpty()) << key << ' ' << way;
            EXPECT_THAT(organ.files, ElementsAre(case_ / "organ.obj", case_ / "organ.mtl")) << way;
            EXPECT_THAT(organ.warnings, Contains(testing::StartsWith("texture " + way + ": \"")));
            for (const PackedFile& file : pack_organ(case_ / "organ.obj"))
                EXPECT_THAT(file.name, HasSubstr("organ.")) << way;
        }
    write("organ.mtl", "newmtl m\nmap_Kd -o 0 0 0 C:\\\\maps\\own.png\n");
    fs::copy_file(case_ / "maps/own.png", case_ / "own.png");
    EXPECT_THAT(load_organ(case_ / "organ.obj").files, Contains(case_ / "maps/own.png"))
        << "its last names lie beside it";
    write("organ.mtl", "newmtl m\nmap_Kd C:\\\\old\\own.png\n");
    EXPECT_THAT(load_organ(case_ / "organ.obj").files, Contains(case_ / "own.png")) << "the last name lies beside it";
}

TEST_F(Outside, NoUriOfAGltfReadsBeyondItsFolder) {
    test::Triangle triangle;
    triangle.json["materials"] =
        nlohmann::json::parse(R"([{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}])");
    triangle.json["textures"] = nlohmann::json::parse(R"([{"source": 0}])");
    triangle.primitive()["material"] = 0;
    const auto fault_with = [&](const std::string& buffer, const std::string& image) {
        triangle.json["buffers"][0]["uri"] = buffer;
        triangle.json["images"] = {{{"uri", image}}};
        const fs::path file = write("organ.gltf", triangle.json.dump());
        const std::string fault = test::fault_of(file);
        EXPECT_EQ(test::faults_of([&] { pack_organ(file); }).empty(), fault.empty() || fault.starts_with("/images"))
            << fault;
        return fault;
    };
    write("own.bin", triangle.binary);
    all_.write("home/own.bin", triangle.binary);
    EXPECT_EQ(fault_with("own.bin", "maps/own.png"), "");
    for (std::string way : ways_to("own.bin"))
        EXPECT_THAT(fault_with(way, "maps/own.png"), testing::StartsWith("/buffers/0/uri: "));
    for (std::string way : ways_to("skin.png"))
        EXPECT_THAT(fault_with("own.bin", way), testing::StartsWith("/images/0/uri: "));
    EXPECT_THAT(fault_with("%2e%2e/%2e%2e/own.bin", "maps/own.png"), HasSubstr("leads out of the folder;"));
    EXPECT_THAT(fault_with("own.bin", "..%2f..%2fskin.png"), HasSubstr("leads out of the folder;"));
    EXPECT_THAT(fault_with("own.bin", "link.png"), HasSubstr("by a symbolic link;"));
}

TEST_F(Outside, ABundledGltfNamesWhatLiesBesideIt) {
    test::Triangle triangle;
    triangle.json["materials"] =
        nlohmann::json::parse(R"([{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}])");
    triangle.json["textures"] = nlohmann::json::parse(R"([{"source": 0}])");
    triangle.json["images"] = nlohmann::json::parse(R"([{"uri": "maps/own.png"}, {"uri": "../../skin.png"}])");
    triangle.json["extras"] = {{"by", "somebody"}};
    triangle.primitive()["material"] = 0;
    triangle.json["buffers"][0]["uri"] = "maps/shape%201.desktop";
    write("maps/shape 1.desktop", triangle.binary + "and what does not belong to it");
    write("organ.gltf", triangle.json.dump());
    write("organ.glb", test::glb(triangle.json, ""));
    for (const char* organ : {"organ.gltf", "organ.glb"}) {
        const std::vector<std::string> before = everything();
        write_bundle(bundle(organ));
        EXPECT_EQ(everything(), before);
        EXPECT_THAT(bundled(),
                    UnorderedElementsAre("bundle.json", "bundle.scene.json", "thumbnail.png",
                                         std::string("organ/") + organ, "organ/own.png", "organ/shape_1.bin"));
        EXPECT_EQ(test::read_text(out_ / "organ/shape_1.bin"), triangle.binary);
        const std::string text = test::read_text(out_ / "organ" / organ);
        EXPECT_THAT(text, AllOf(HasSubstr("shape_1.bin"), HasSubstr("somebody"), testing::Not(HasSubstr("maps"))));
        EXPECT_EQ(load_organ(out_ / "organ" / organ).images.size(), 1U);
    }
}

TEST_F(Outside, NamesInABundleAreItsOwn) {
    OwnNames names;
    EXPECT_EQ(names.give("../../etc/passwd", ".png"), "passwd.png");
    EXPECT_EQ(names.give("PASSWD.desktop", ".png"), "PASSWD-2.png") << "the same name on many disks";
    EXPECT_EQ(names.give("passwd-3", ".png"), "passwd-3.png");
    EXPECT_EQ(names.give("passwd", ".png"), "passwd-4.png");
    EXPECT_EQ(names.give("passwd", ".bin"), "passwd.bin");
    EXPECT_EQ(names.give(".bashrc", ".png"), "bashrc.png");
    EXPECT_EQ(names.give("..", ".png"), "file.png");
    EXPECT_EQ(names.give("", ".png"), "file-2.png");
    EXPECT_EQ(names.give("a b;$(c)%d\n.x", ".png"), "a_b___c__d_.png");
    EXPECT_EQ(names.give(std::string(300, 'n'), ".png").size(), 84U);
}

TEST_F(Outside, AClipLiesInThePresetsFolder) {
    const auto preset_with = [&](const std::string& clip) {
        return test::preset_text(R"(, "smoke": {"clips": [{"file": ")" + clip + "\"}]}");
    };
    for (const std::string& way : ways_to("smoke.avi")) {
        if (way == "maps/home/smoke.avi") continue;  // reads well
        EXPECT_THAT(test::faults_of([&] { load_preset(write("p.json", preset_with(way))); }),
                    ElementsAre(HasSubstr("/smoke/clips/0/file: ")))
            << way;
    }
    for (const char* way : {"maps/home/smoke.avi", "link.avi"}) {
        const Preset preset = load_preset(write("p.json", preset_with(way)));
        EXPECT_THAT(test::faults_of([&] { check_clips(preset, "p.json", {}); }),
                    ElementsAre(AllOf(HasSubstr("p.json: /smoke/clips/0/file: "), HasSubstr("by a symbolic link;"))));
        Bundle made = bundle("");
        made.scene.reset();
        made.preset = preset;
        EXPECT_THAT(test::faults_of([&] { write_bundle(made); }),
                    ElementsAre(AllOf(HasSubstr("/smoke/clips/0/file: "), HasSubstr("by a symbolic link;"))));
        std::vector<Fault> faults;
        preset_in(case_, preset, {}, faults);
        ASSERT_EQ(faults.size(), 1U);
        EXPECT_THAT(faults[0].reason, HasSubstr("by a symbolic link;"));
    }
    cv::imwrite((case_ / "s1.png").string(), cv::Mat(8, 8, CV_8UC3, cv::Scalar(9, 9, 9)));
    fs::create_symlink(all_ / "home/.ssh/id_rsa", case_ / "s2.png");
    EXPECT_THAT(test::faults_of([&] { find_clip("s%d.png", case_, {}); }),
                ElementsAre(HasSubstr("by a symbolic link;")));
    const auto bundle_of = [&](const std::string& clip) {
        Bundle made = bundle("");
        made.scene.reset();
        made.preset = load_preset(write("p.json", preset_with(clip)));
        return test::faults_of([&] { write_bundle(made); });
    };
    EXPECT_THAT(bundle_of("s%d.png"), ElementsAre(HasSubstr("by a symbolic link;")));
    // A folder of the same name does not help either.
    fs::create_directory(case_ / "s%d.png");
    for (const char* number : {"0", "1", "2"}) fs::remove(case_ / ("s" + std::string(number) + ".png"));
    fs::create_symlink(all_ / "home/skin.png", case_ / "s0.png");
    EXPECT_THAT(test::faults_of([&] { find_clip("s%d.png", case_, {}); }),
                ElementsAre("s%d.png: is a folder; a video file is needed"));
    EXPECT_THAT(bundle_of("s%d.png"),
                ElementsAre(AllOf(HasSubstr("/smoke/clips/0/file: "), HasSubstr("\"s%d.png\": is a folder;"))));
    EXPECT_FALSE(fs::exists(out_));
    fs::remove(case_ / "s0.png");
    fs::remove(case_ / "s%d.png");
    fs::copy_file(all_ / "home/skin.png", case_ / "s1.png");
    EXPECT_EQ(find_clip("s%d.png", case_, {}), case_ / "s%d.png");
    EXPECT_THAT(bundle_of("s%d.png"), IsEmpty());
}

TEST_F(Outside, WhatASceneNamesIsAMeshAPresetAndAVideo) {
    const auto scene_with = [&](const std::string& members) {
        return test::faults_of([&] { load_scene(write("s.json", test::scene_text(members))); });
    };
    const std::string url = "file://" + (all_ / "home/skin.png").string();
    EXPECT_THAT(scene_with(R"(, "organ": {"file": ")" + url + "\"}"), ElementsAre(HasSubstr("/organ/file: ")));
    EXPECT_THAT(scene_with(R"(, "organ": {"file": "o.obj"}, "preset": ")" + url + "\""),
                ElementsAre(HasSubstr("/preset: ")));
    EXPECT_THAT(scene_with(R"(, "organ": {"file": "o.obj"}, "reference": {"file": "concat:a|b"})"),
                ElementsAre(HasSubstr("/reference/file: ")));
    // A person chooses an organ from anywhere. A file that is not one is neither shown nor copied.
    const std::vector<std::string> before = everything();
    EXPECT_THAT(test::faults_of([&] { write_bundle(bundle("../../.ssh/id_rsa")); }),
                ElementsAre(HasSubstr("is not a mesh")));
    EXPECT_EQ(everything(), before);
    EXPECT_FALSE(fs::exists(out_));
    all_.write("home/liver.obj", triangle_obj);
    write_bundle(bundle("../../liver.obj"));
    EXPECT_EQ(load_scene(out_ / "bundle.scene.json").organ.file, "organ/liver.obj");
    EXPECT_THAT(test::faults_of([&] { report_clip(all_ / "home/.ssh/id_rsa"); }),
                ElementsAre(HasSubstr("id_rsa: is not a video")));
}

TEST_F(Outside, AThumbnailIsNotMadeOfAClipThatLeadsOut) {
    write("o.ply", "x");
    const fs::path ran = all_ / "ran", program = all_.write("program.sh", "#!/bin/sh\ntouch '" + ran.string() + "'\n");
    fs::permissions(program, fs::perms::owner_all);
    app::ThumbnailMaker maker({.cache = all_ / "cache",
                               .clip_folders = {},
                               .program = program,
                               .render = true,
                               .size = {192, 154},
                               .longest = std::chrono::hours(1),
                               .niceness = 19,
                               .wake = {}});
    maker.want({{.file = write("p.json", test::preset_text(R"(, "smoke": {"clips": [{"file": "link.avi"}]})")),
                 .scene = write("s.json", test::scene_text()),
                 .time = 1}});
    maker.finish();
    const auto made = maker.take();
    ASSERT_EQ(made.size(), 1U);
    EXPECT_THAT(made[0].fault, HasSubstr("by a symbolic link;"));
    EXPECT_FALSE(fs::exists(ran));
}

TEST_F(Outside, RecentFilesAreWholePaths) {
    fs::create_directories(all_ / "config");
    all_.write("config/settings.json",
               R"({"recent": ["../../.ssh/id_rsa", "file:///etc/passwd", "/data/liver.glb", ""]})");
    const app::Settings settings({.config = all_ / "config", .state = {}, .cache = {}});
    EXPECT_THAT(settings.recent, ElementsAre("/data/liver.glb"));
}

TEST_F(Outside, RecoveredWorkNamesWholePathsOfDocuments) {
    const auto kept = [&](const std::string& file, const std::string& folder) {
        const fs::path path = all_.write(
            "kept.json", R"({"format": "lapfx.autosave", "version": 1, "scene": {"file": ")" + file +
                             R"(", "folder": ")" + folder + R"(", "content": {}}, "preset": {"content": {}}})");
        std::vector<std::string> told;
        document::Kept back = document::read_kept(path, told);
        return std::pair(back.scene_file.string() + "|" + back.content.scene.folder.string(), told.size());
    };
    const std::size_t nothing_told = kept("", "").second;
    EXPECT_EQ(kept("/cases/a.scene.json", "/cases"),
              std::pair(std::string("/cases/a.scene.json|/cases"), nothing_told));
    for (const char* file : {"../a.json", "/home/me/.bashrc", "/home/me/.config/autostart/x.desktop", "file:///a.json"})
        EXPECT_EQ(kept(file, ""), std::pair(std::string("|"), nothing_told + 1)) << file;
    EXPECT_EQ(kept("", "../.."), std::pair(std::string("|"), nothing_told + 1));
}

}  // namespace
}  // namespace lapfx::output
