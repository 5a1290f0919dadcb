// Makes a folder of shipped files that are light: the editor's tests open the sample scene some three hundred times,
// and without a GPU most of that goes to textures and videos of full size, at which few tests look, and to
// the parts of the organ that no picture shows. Names, times and contents are those of the shipped files; textures and
// videos have a quarter of their width and height, and of the organ there is what the scene's camera sees.
//
//     lapfx_light_samples SOURCE_FOLDER OUTPUT_FOLDER
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "support/seen_part.h"

namespace {

namespace fs = std::filesystem;
using Bytes = std::vector<std::uint8_t>;

constexpr int factor = 4;

cv::Mat smaller(const cv::Mat& image) {
    cv::Mat result;
    cv::resize(image, result, image.size() / factor, 0, 0, cv::INTER_AREA);
    return result;
}

std::uint32_t word_at(const Bytes& bytes, std::size_t at) {
    std::uint32_t value = 0;
    std::memcpy(&value, bytes.data() + at, sizeof value);
    return value;
}

void append_word(Bytes& bytes, std::uint32_t value) {
    for (int shift = 0; shift < 32; shift += 8) bytes.push_back(static_cast<std::uint8_t>(value >> shift));
}

void pad(Bytes& bytes, std::uint8_t with) {
    while (bytes.size() % 4 != 0) bytes.push_back(with);
}

/// A .glb with smaller images, and of an organ what the camera of its scene sees. Each image is a buffer view of its
/// own, as the generator of the samples writes them.
void lighten_organ(const fs::path& from, const fs::path& to) {
    std::ifstream in(from, std::ios::binary);
    const Bytes file(std::istreambuf_iterator<char>(in), {});
    constexpr std::size_t header = 12, chunk_header = 8;
    const std::size_t json_size = word_at(file, header), binary_at = header + 2 * chunk_header + json_size;
    const auto text = file.begin() + header + chunk_header;
    nlohmann::json json = nlohmann::json::parse(text, text + static_cast<std::ptrdiff_t>(json_size));

    std::vector<Bytes> views;
    for (const nlohmann::json& view : json["bufferViews"]) {
        const auto begin = file.begin() + static_cast<std::ptrdiff_t>(binary_at + view.value("byteOffset", 0U));
        views.emplace_back(begin, begin + view["byteLength"].get<std::ptrdiff_t>());
    }
    for (const nlohmann::json& image : json.value("images", nlohmann::json::array())) {
        Bytes& view = views.at(image["bufferView"].get<std::size_t>());
        const cv::Mat picture = cv::imdecode(view, cv::IMREAD_COLOR);
        if (picture.empty()) throw std::runtime_error(from.string() + ": an image cannot be decoded");
        cv::imencode(".jpg", smaller(picture), view, {cv::IMWRITE_JPEG_QUALITY, 95});
    }
    const fs::path scene = fs::path(from).replace_extension(".scene.json");
    if (fs::exists(scene)) lapfx::test::keep_seen_part(json, views, nlohmann::json::parse(std::ifstream(scene)));
    Bytes binary;
    for (std::size_t i = 0; i < views.size(); ++i) {
        json["bufferViews"][i]["byteOffset"] = binary.size();
        json["bufferViews"][i]["byteLength"] = views[i].size();
        binary.insert(binary.end(), views[i].begin(), views[i].end());
        pad(binary, 0);
    }
    json["buffers"][0]["byteLength"] = binary.size();

    const std::string new_text = json.dump();
    Bytes body(new_text.begin(), new_text.end());
    pad(body, ' ');
    Bytes result{'g', 'l', 'T', 'F'};
    append_word(result, 2);
    append_word(result, static_cast<std::uint32_t>(header + 2 * chunk_header + body.size() + binary.size()));
    append_word(result, static_cast<std::uint32_t>(body.size()));
    for (const char c : {'J', 'S', 'O', 'N'}) result.push_back(static_cast<std::uint8_t>(c));
    result.insert(result.end(), body.begin(), body.end());
    append_word(result, static_cast<std::uint32_t>(binary.size()));
    for (const char c : {'B', 'I', 'N', '\0'}) result.push_back(static_cast<std::uint8_t>(c));
    result.insert(result.end(), binary.begin(), binary.end());
    std::ofstream(to, std::ios::binary)
        .write(reinterpret_cast<const char*>(result.data()), static_cast<std::streamsize>(result.size()));
}

void lighten_video(const fs::path& from, const fs::path& to) {
    cv::VideoCapture in(from.string(), cv::CAP_FFMPEG);
    const cv::Size size(static_cast<int>(in.get(cv::CAP_PROP_FRAME_WIDTH)) / factor,
                        static_cast<int>(in.get(cv::CAP_PROP_FRAME_HEIGHT)) / factor);
    cv::VideoWriter out;
    for (const int codec : {cv::VideoWriter::fourcc('a', 'v', 'c', '1'), cv::VideoWriter::fourcc('m', 'p', '4', 'v')})
        if (out.open(to.string(), cv::CAP_FFMPEG, codec, in.get(cv::CAP_PROP_FPS), size)) break;
    if (!out.isOpened()) throw std::runtime_error(to.string() + " cannot be written");
    for (cv::Mat frame; in.read(frame);) out.write(smaller(frame));
}

void lighten(const fs::path& from, const fs::path& to) {
    fs::remove_all(to);
    fs::create_directories(to / "samples/clips");
    fs::create_directories(to / "samples/reference");
    fs::create_directory_symlink(from / "shaders", to / "shaders");
    fs::copy(from / "presets", to / "presets");  // clips are looked for beside where a preset really lies
    for (const fs::directory_entry& file : fs::directory_iterator(from / "samples")) {
        if (file.path().extension() == ".json") fs::copy(file, to / "samples" / file.path().filename());
        if (file.path().extension() == ".glb") lighten_organ(file, to / "samples" / file.path().filename());
    }
    for (const char* folder : {"samples/clips", "samples/reference"})
        for (const fs::directory_entry& file : fs::directory_iterator(from / folder))
            if (file.path().extension() == ".mp4") lighten_video(file, to / folder / file.path().filename());
}

}  // namespace

int main(int count, char** words) try {
    if (count != 3) throw std::runtime_error("usage: lapfx_light_samples SOURCE_FOLDER OUTPUT_FOLDER");
    lighten(words[1], words[2]);
} catch (const std::exception& error) {
    std::cerr << "lapfx_light_samples: " << error.what() << '\n';
    return 1;
}
