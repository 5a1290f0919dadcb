// What the pages of the gallery show and change.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "ui/canvas/compare_view.h"
#include "ui/canvas/curve.h"
#include "ui/canvas/histogram.h"
#include "ui/canvas/image_view.h"
#include "ui/canvas/plot_data.h"
#include "ui/canvas/scope.h"
#include "ui/canvas/timeline.h"
#include "ui/shell/commands.h"
#include "ui/shell/file_dialog.h"
#include "ui/shell/toast.h"
#include "ui/widgets/dock_layout.h"
#include "ui/widgets/param.h"
#include "ui/widgets/table.h"

namespace lapfx::gallery {

struct BasicState {
    bool on = true, off = false, quiet_on = true;
    int clicks = 0, one = 1, none = 0;
};

struct FieldsState {
    FieldsState();
    std::string name = "Gallbladder dissection", empty, wrong = "12 apples", unicode = "Größe Łódź 保存 🙂",
                code = "mix(a, b, 0.5)";
    std::string long_line = "/data/clips/2024-03-12/theatre 4/lap chole/plume_left_margin_take_07_graded_v3.mov";
    std::string search = "plume";
    int view = 0, clip = 2, nothing = -1, frame = 417;
    std::vector<std::string> frame_names;  ///< ten thousand
    std::vector<std::string_view> frames;
    ui::Color tissue{194, 72, 63, 255}, glass{86, 180, 233, 120};
};

struct ParamsState {
    double speed = 12, time = 0.25, ratio = 0.35, tilt = 0.4, big = 4200, wild = 80, locked = 3.5;
    float single = 0.1F;
    int count = 24;
    double low = 32, high = 190;
    glm::dvec3 place{1.5, -20, 340};
    glm::dvec2 flow{0.5, -0.25};
    ui::ParamActions actions;
};

struct Clip {
    std::string name, length, codec;
    double seconds = 0;
    bool keyed = false, star = false;
    ui::ImageHandle image = 0;
};

struct ListsState {
    explicit ListsState(ui::ImageStore& images);
    std::vector<Clip> clips;
    std::vector<std::size_t> order;  ///< of clips, as the table shows them
    ui::TableState table;
    ui::Selection presets;
};

struct PanelsState {
    PanelsState();
    int tab = 0, many = 0;
    float fraction = 0.35F;
    double speed = 12, haze = 0.4;
    ui::DockLayout layout;
};

/// A few folders that are nowhere.
struct TestFiles : ui::FileSystem {
    std::string list(const std::string& folder, std::vector<ui::FileEntry>& entries) override;
    Kind kind(const std::string& path) override;
    std::string home() override { return "/clips"; }
    std::vector<ui::FilePlace> places() override { return {{"Clips", "/clips"}, {"Root", "/"}}; }
    std::string make_folder(const std::string&) override { return "these folders are nowhere"; }
};

/// The previews of those files: pictures have one, videos wait for theirs, and files whose name is not UTF-8 are
/// broken.
struct TestFilePictures : ui::FilePictures {
    ui::FilePicture picture(ui::Ui& ui, const std::string& path, const ui::FileEntry& file) override;
    ui::ImageHandle image = 0;
    glm::ivec2 size{0};
};

struct ShellState {
    double done = 0.42;
    bool cancelled = false;
    std::string name = "brisk bleed";
    std::string_view answer = "nothing yet";
    bool grid = true, wants_palette = false, wants_keys = false;
    ui::Toasts toasts;
    TestFiles disk;
    TestFilePictures file_pictures;
    ui::FileDialog files{disk};
};

/// A made-up picture, 8 bits RGBA.
struct TestPicture : ui::PickSource {
    glm::ivec2 size{0};
    std::vector<std::uint8_t> pixels;
    ui::ImageHandle image = 0;
    glm::vec4 pixel(glm::ivec2 at) const override;
    ui::Picture picture() const { return {.image = image, .size = size, .pixels = this, .transparent = false}; }
};

struct PicturesState {
    explicit PicturesState(ui::ImageStore& images);
    TestPicture clean, smoky;
    ui::ViewState view;
    ui::CompareState compare;
    std::vector<std::uint32_t> luma;  ///< counts of 256 values
    ui::Levels levels{40, 190};
    bool log_counts = false, magnifier = true;
    int kind = 0;
    ui::KeyCircles key{{40, 170, 70}, 20, 60, 20, 60};
    ui::ScopeImage vectors, waves;
};

struct GraphsState {
    GraphsState();
    std::vector<float> measured_values, simulated_values, least_values, most_values;
    ui::PlotData measured, simulated, least, most;
    ui::Curve curve{{{0, 0}, {0.3, 0.15}, {0.7, 0.85}, {1, 1}}}, standard;
    ui::TimelineState time;
    std::vector<ui::TimelineTrack> tracks;
};

struct State {
    /// `images` must outlive it and be the Ui's; so must the state's commands be its shortcuts.
    explicit State(ui::ImageStore& images);
    State(const State&) = delete;
    State& operator=(const State&) = delete;

    int page = 0;       ///< into pages()
    bool bare = false;  ///< the page alone, without list and switches
    bool light = false;
    bool reduced_motion = false;
    float scale = 1;     ///< that of the window, to be set before each frame; another one afterwards is wanted
    bool close = false;  ///< the window is to be closed

    ui::CommandTable commands;
    BasicState basic;
    FieldsState fields;
    ParamsState params;
    ListsState lists;
    PanelsState panels;
    ShellState shell;
    PicturesState pictures;
    GraphsState graphs;
    int answers = 0;
};

}  // namespace lapfx::gallery
