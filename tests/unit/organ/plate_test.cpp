#include "organ/plate.h"

#include <gmock/gmock.h>

#include "foundation.h"
#include "lapfx/authoring/prepared_scene.h"
#include "organ/refine.h"
#include "support/endoscope.h"
#include "unit/preset/support.h"

namespace lapfx {
namespace {

organ::Plate a_plate(PlateDepth depth) {
    return {.camera = {.eye = {10.0, 40.0, 120.0}, .target = {2.0, 2.0, 0.0}, .up = {0.1, 1.0, 0.0}},
            .aspect = 1.5,
            .distance = 80.0,
            .depth = depth,
            .center = {0.55, 0.5},
            .radius = {0.4 / 1.5, 0.4}};
}

TEST(Plate, AFlatOneIsEquallyDeepAllOver) {
    const organ::Plate plate = a_plate(PlateDepth::flat);
    const glm::dvec3 ahead = glm::normalize(plate.camera.target - plate.camera.eye);
    const organ::Plate& p = plate;
    for (const glm::dvec2 place : {glm::dvec2(0.0), {1.0, 0.0}, {0.3, 0.8}, {0.5, 0.5}})
        EXPECT_NEAR(glm::dot(p.point_at(place) - p.camera.eye, ahead), 80.0, 1e-9);
}

TEST(Plate, ABowlFallsAwayWithTheSquareOfTheRadius) {
    const organ::Plate plate = a_plate(PlateDepth::bowl);
    EXPECT_DOUBLE_EQ(plate.depth_at({0.55, 0.5}), 80.0) << "its middle is that of the round view";
    EXPECT_NEAR(plate.depth_at({0.55, 0.9}), 80.0 * 1.3, 1e-9) << "its rim";
    EXPECT_NEAR(plate.depth_at({0.55 + 0.4 / 1.5, 0.5}), 80.0 * 1.3, 1e-9) << "the view is round, not the picture";
    EXPECT_NEAR(plate.depth_at({0.55, 0.7}), 80.0 * 1.075, 1e-9) << "half way";
    EXPECT_NEAR(plate.depth_at({-0.4, 0.5}), 80.0 * (1.0 + 0.3 * 2.25), 1e-9) << "level far outside";
}

TEST(Plate, ItsCornersFillTheView) {
    const organ::Plate plate = a_plate(PlateDepth::flat);
    const double half = 80.0 * std::tan(glm::radians(30.0));
    EXPECT_NEAR(glm::distance(plate.point_at({0, 0}), plate.point_at({0, 1})), 2.0 * half, 1e-9);
    EXPECT_NEAR(glm::distance(plate.point_at({0, 0}), plate.point_at({1, 0})), 2.0 * half * 1.5, 1e-9);
}

TEST(Plate, TheProjectorThrowsEachPlaceWhereItLies) {
    for (const PlateDepth depth : {PlateDepth::bowl, PlateDepth::flat}) {
        const organ::Plate plate = a_plate(depth);
        const glm::dmat4 projector = plate.projector();
        for (const glm::dvec2 place : {glm::dvec2(0.0), {1.0, 0.25}, {0.3, 0.8}, {0.55, 0.5}}) {
            const glm::dvec4 thrown = projector * glm::dvec4(plate.point_at(place), 1.0);
            EXPECT_NEAR(thrown.x / thrown.w, place.x, 1e-12);
            EXPECT_NEAR(thrown.y / thrown.w, place.y, 1e-12);
        }
    }
}

TEST(Plate, APointLiesBelowWhereTheCameraSeesIt) {
    const organ::Plate plate = a_plate(PlateDepth::bowl);
    const glm::dvec3 on = plate.point_at({0.3, 0.8});
    for (const double share : {0.5, 1.0, 1.7})
        EXPECT_LT(glm::distance(plate.below(plate.camera.eye + share * (on - plate.camera.eye)), on), 1e-9) << share;
    for (const glm::dvec3 unseen : {glm::dvec3(10.0, 40.0, 300.0), {1000.0, 0.0, 0.0}, plate.camera.eye})
        EXPECT_EQ(plate.below(unseen), unseen);
}

TEST(Plate, ItsSurfaceIsFineEnoughForBloodAndFacesTheCamera) {
    for (const PlateDepth depth : {PlateDepth::bowl, PlateDepth::flat}) {
        const organ::Plate plate = a_plate(depth);
        const Organ organ = organ::plate_organ(plate, test::tissue_picture({90, 60}));
        EXPECT_EQ(organ.images.size(), 1U);
        EXPECT_EQ(organ.materials.at(0).base_color_image, 0);
        EXPECT_EQ(organ::plan_refine(organ).splits, depth == PlateDepth::bowl) << "its far rim is wider";
        for (std::size_t i = 0; i < organ.indices.size(); i += 3) {
            const glm::dvec3 a(organ.positions[organ.indices[i]]), b(organ.positions[organ.indices[i + 1]]),
                c(organ.positions[organ.indices[i + 2]]);
            ASSERT_GT(glm::dot(glm::cross(b - a, c - a), plate.camera.eye - a), 0.0);
        }
        for (std::size_t v = 0; v < organ.positions.size(); ++v) {
            ASSERT_NEAR(glm::length(organ.normals[v]), 1.0f, 1e-5f);
            ASSERT_GT(glm::dot(glm::dvec3(organ.normals[v]), plate.camera.eye - glm::dvec3(organ.positions[v])), 0.0);
        }
    }
}

TEST(Plate, ItsDistanceIsThatOfTheTargetUnlessTheSceneSaysOne) {
    Scene scene;
    scene.camera.eye = {0, 0, 120};
    EXPECT_EQ(organ::plate_of(scene, {90, 60}, {0.5, 0.5}, {0.5, 0.5}).distance, 120.0);
    scene.plate.distance = 70.0;
    EXPECT_EQ(organ::plate_of(scene, {90, 60}, {0.5, 0.5}, {0.5, 0.5}).distance, 70.0);
    EXPECT_EQ(organ::plate_of(scene, {90, 60}, {0.5, 0.5}, {0.5, 0.5}).aspect, 1.5);
}

class PreparedPlate : public testing::Test {
  protected:
    PreparedPlate() {
        test::write_picture(folder / "video.png", test::tissue_picture({90, 60}));
        scene.folder = folder.path();
        scene.organ.file = "missing.glb";  // a plate stands in for it: nobody looks
        scene.reference.file = "video.png";
        scene.plate.use = true;
    }

    test::Folder folder;
    Scene scene;
};

TEST_F(PreparedPlate, StandsInForTheOrgan) {
    const auto made = prepare_organ(scene);
    EXPECT_EQ(made->organ().name, "frame at 0 s of video.png");
    EXPECT_THAT(files_of(*made), testing::ElementsAre(folder / "video.png"));
    scene.plate.use = false;
    EXPECT_EQ(test::faults_of([&] { prepare_organ(scene); }).size(), 1U) << "now the organ is looked for";
}

TEST_F(PreparedPlate, HasTheAspectThatTheReferenceIsShownWith) {
    scene.reference.aspect = 2.0;
    scene.plate.depth = PlateDepth::flat;
    glm::vec3 low(1e9f), high(-1e9f);
    const auto made = prepare_organ(scene);
    for (const glm::vec3& p : made->organ().positions) low = glm::min(low, p), high = glm::max(high, p);
    EXPECT_NEAR((high.x - low.x) / (high.y - low.y), 2.0f, 1e-3f);
}

TEST_F(PreparedPlate, LiesWhereTheReferenceIsPlaced) {
    scene.reference.placement = {.right = 0.25, .up = 0.1, .scale = 0.5};
    const auto made = prepare_organ(scene);
    const SceneCamera& camera = scene.camera;
    const glm::dvec3 ahead = glm::normalize(camera.target - camera.eye),
                     right = glm::normalize(glm::cross(ahead, camera.up)), up = glm::cross(right, ahead);
    glm::dvec3 nearest(0.0);  // the middle of the bowl
    double least = 1e9;
    for (const glm::vec3& p : made->organ().positions)
        if (const double away = glm::dot(glm::dvec3(p) - camera.eye, ahead); away < least)
            least = away, nearest = glm::dvec3(p) - camera.eye;
    const double height = 2.0 * std::tan(glm::radians(camera.field_of_view) / 2.0) * least;
    EXPECT_NEAR(glm::dot(nearest, right) / height, 0.25, 0.03);
    EXPECT_NEAR(glm::dot(nearest, up) / height, 0.1, 0.03);
}

TEST_F(PreparedPlate, WhatIsWrongIsOneLine) {
    scene.reference.file = "gone.png";
    EXPECT_THAT(test::faults_of([&] { prepare_organ(scene); }), testing::ElementsAre(testing::HasSubstr("gone.png")));
    scene.reference.file.clear();
    EXPECT_THAT(test::faults_of([&] { prepare_organ(scene); }),
                testing::ElementsAre("/plate/use: the scene has no reference video to take the plate from"));
    scene.reference.file = "http://example.org/a.mp4";
    EXPECT_THAT(test::faults_of([&] { prepare_organ(scene); }),
                testing::ElementsAre(testing::StartsWith("/reference/file: ")));
    scene.reference.file = "video.png";
    scene.plate.frame = PlateFrame::chosen;
    scene.plate.time = 7.5;
    EXPECT_THAT(test::faults_of([&] { prepare_organ(scene); }),
                testing::ElementsAre(testing::StartsWith("/plate/time: 7.5 s is outside the reference")));
    folder.write("video.png", "no picture any more");
    scene.plate.frame = PlateFrame::clearest;
    EXPECT_THAT(test::faults_of([&] { prepare_organ(scene); }), testing::ElementsAre(testing::HasSubstr("video.png")));
}

TEST_F(PreparedPlate, IsMadeForOneCameraAndOnePlate) {
    const auto made = prepare_organ(scene);
    Scene other = scene;
    other.camera.exposure = 2.0;
    other.camera.vignette = 0.0;
    other.organ.scale = 3.0;
    EXPECT_TRUE(made_for(*made, other)) << "what it does not depend on";
    const auto differs = [&](auto change) {
        other = scene;
        change(other);
        return !made_for(*made, other);
    };
    EXPECT_TRUE(differs([](Scene& s) { s.camera.eye.x += 1.0; }));
    EXPECT_TRUE(differs([](Scene& s) { s.camera.field_of_view = 50.0; }));
    EXPECT_TRUE(differs([](Scene& s) { s.plate.use = false; }));
    EXPECT_TRUE(differs([](Scene& s) { s.plate.depth = PlateDepth::flat; }));
    EXPECT_TRUE(differs([](Scene& s) { s.reference.file = "other.png"; }));
    EXPECT_TRUE(differs([](Scene& s) { s.reference.aspect = 1.3; }));
    EXPECT_TRUE(differs([](Scene& s) { s.reference.placement.scale = 0.7; }));
    EXPECT_FALSE(differs([](Scene& s) { s.reference.offset = 3.0; }));
}

TEST_F(PreparedPlate, ItsPictureIsDecodedOnceForAllCameras) {
    scene.reference.file = "video.bmp";  // all of one size have as many bytes
    const auto write = [&](unsigned seed) {
        test::write_picture(folder / "video.bmp", test::tissue_picture({90, 60}, seed));
    };
    const auto picture = [&] {
        const auto made = prepare_organ(scene);
        return PreparedOrganAccess::state(*made).foundation->pixels.front()->get()->pixels;
    };
    write(1);
    const auto first = picture();
    const auto written = std::filesystem::last_write_time(folder / "video.bmp");
    write(2);
    std::filesystem::last_write_time(folder / "video.bmp", written);
    scene.camera.eye += glm::dvec3(5, 0, 3);
    scene.plate.depth = PlateDepth::flat;
    EXPECT_EQ(picture(), first) << "nothing that the picture depends on";
    scene.plate.frames = 2;
    const auto second = picture();
    EXPECT_NE(second, first) << "other frames";
    write(3);
    std::filesystem::last_write_time(folder / "video.bmp", written + std::chrono::seconds(1));
    EXPECT_NE(picture(), second) << "the file has changed";
}

TEST_F(PreparedPlate, CanBeStoppedWhereverItAsks) {
    prepare_organ(scene);  // while the video is read it asks as often as that takes
    int asked = 0;
    prepare_organ(scene, {}, [&](double) { return ++asked > 0; });
    for (int stop = 1; stop <= asked; ++stop) {
        int count = 0;
        EXPECT_EQ(prepare_organ(scene, {}, [&](double) { return ++count < stop; }), nullptr);
    }
}

}  // namespace
}  // namespace lapfx
