#include "output/layer_files.h"

#include <cmath>
#include <cstdio>
#include <system_error>

#include "lapfx/authoring/file.h"
#include "lapfx/error.h"
#include "output/files.h"

namespace lapfx::output {

namespace {

constexpr const char* picture_names[] = {"view_%04d.png", "blood_%04d.png", "veil_%04d.png"};
constexpr const char* amounts_name = "amounts.csv";

template <typename Value>
Image grey(glm::ivec2 size, const Value& value) {
    Image image{.width = size.x, .height = size.y, .pixels = {}, .name = ""};
    const std::size_t pixels = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
    image.pixels.resize(4 * pixels, 255);
    for (std::size_t i = 0; i < pixels; ++i)
        for (std::size_t k = 0; k < 3; ++k) image.pixels[4 * i + k] = value(i);
    return image;
}

}  // namespace

LayerFiles::LayerFiles(std::filesystem::path folder, double fps, glm::ivec2 size, int count)
    : folder_(std::move(folder)), size_(size) {
    std::error_code error;
    made_ = std::filesystem::create_directory(folder_, error);
    if (error || !std::filesystem::is_directory(folder_))
        throw Error(Failure::runtime,
                    Fault{.file = folder_.string(),
                          .place = "",
                          .reason = "cannot make this folder: " + (error ? error.message() : "it is a file")});
    require_replaceable(folder_ / amounts_name);
    for (std::size_t i = 0; i < pictures_.size(); ++i)
        pictures_[i] = make_png_files(folder_ / picture_names[i], {.fps = fps, .size = size, .count = count});
    amounts_ = "time,blood,blood_low,blood_high,veil,veil_low,veil_high,flags\n";
}

std::vector<std::filesystem::path> LayerFiles::names(const std::filesystem::path& folder) {
    if (folder.empty()) return {};
    std::vector<std::filesystem::path> all{folder / amounts_name};
    for (const char* const name : picture_names) all.push_back(folder / name);
    return all;
}

LayerFiles::~LayerFiles() {
    for (auto& files : pictures_) files.reset();  // files that are given up leave nothing
    std::error_code error;
    if (made_) std::filesystem::remove(folder_, error);
}

void LayerFiles::add(double time, const Layers& layers) {
    pictures_[0]->add(grey(size_, [&](std::size_t i) { return layers.view[i]; }));
    pictures_[1]->add(
        grey(size_, [&](std::size_t i) { return static_cast<std::uint8_t>(layers.blood[i] & layers.view[i]); }));
    pictures_[2]->add(grey(size_, [&](std::size_t i) {
        return static_cast<std::uint8_t>(layers.view[i] == 0 ? 0 : std::lround(255.0F * layers.veil[i]));
    }));
    const ShownAmounts a = amounts_of(layers);
    char line[160];
    if (a.view == 0.0)  // nothing of the organ is seen
        std::snprintf(line, sizeof line, "%.4f,,,,,,,not_measurable\n", time);
    else
        std::snprintf(line, sizeof line, "%.4f,%.6f,%.6f,%.6f,%.6f,%.6f,%.6f,\n", time, a.blood, a.blood, a.blood,
                      a.veil, a.veil, a.veil);
    amounts_ += line;
}

bool LayerFiles::check() {
    bool more = false;
    for (auto& files : pictures_) more = files->check() || more;
    return more;
}

void LayerFiles::publish() {
    write_file(folder_ / amounts_name, amounts_);
    for (auto& files : pictures_) files->publish();
    made_ = false;
}

}  // namespace lapfx::output
