// Opacity from clips: our keying with suggested thresholds compared with the keyers of OBS and FFmpeg, on smoke of
// known opacity.
//
//     lapfx_keying_accuracy [--json FILE]
//     lapfx_keying_accuracy --suggested [FOLDER]
//
// The second form shows only the suggestions, on more takes and on those of FOLDER: clips with their own opacity
// (WebM), whose smoke is put over the same backgrounds.
//
// Solved smoke over black, green, blue and grey, with sensor noise, through x264 and back. Each keyer gets the
// background's colour. The others run with their defaults, and with the best thresholds of a search that knows the
// truth, which is their least possible error. Ours gets neither and sees only the clip. (Ours with the best thresholds
// is shown as well; and keying of RGB frames, as in the paper's schemes, beside that of planes, as in `resident`.)
// Error: mean absolute difference of opacity over all pixels, and over those with smoke.
//
// The `ffmpeg` program runs FFmpeg's lumakey and chromakey. OBS Studio's two follow its effect files: luma of BT.709
// through smoothstep; distance in the chroma plane of BT.709, over 3 x 3 pixels, to the power of 1.5; code values.
#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <opencv2/imgproc.hpp>

#include "smoke/keying_pixel.h"
#include "smoke/keying_survey.h"
#include "support/known_smoke.h"

namespace lapfx::smoke {
namespace {

bool short_form = false;  // everything once, and little of it

using Frames = std::vector<cv::Mat>;
using Smoke = std::vector<clips::Picture>;

/// One clip: what keyers get, and the truth.
struct Clip {
    std::string name;
    glm::vec3 background;
    const Smoke* smoke;
    std::filesystem::path file;
    Frames rgb;     ///< as decoded to RGB: each pair of rows and columns has one chroma
    Frames planar;  ///< a GPU filters the planes so, with smooth chroma; CV_32FC3

    bool coloured() const { return glm::length(chroma(background)) > 20.0f; }
};

/// A keyer with two thresholds.
struct Keyer {
    std::string name;
    std::array<double, 2> defaults;
    std::array<double, 2> most;  ///< both are searched from 0
    std::function<Frames(const Clip&, std::array<double, 2>)> key;
};

/// The nearest pixel inside, code values.
glm::vec3 pixel(const cv::Mat& frame, int x, int y) {
    x = std::clamp(x, 0, frame.cols - 1), y = std::clamp(y, 0, frame.rows - 1);
    if (frame.type() == CV_32FC3) {
        const auto& c = frame.at<cv::Vec3f>(y, x);
        return {c[0], c[1], c[2]};
    }
    const auto& c = frame.at<cv::Vec3b>(y, x);
    return {c[0], c[1], c[2]};
}

Frames for_pixels(const Frames& frames, const std::function<float(const cv::Mat&, int, int)>& alpha_at) {
    Frames alphas;
    for (const cv::Mat& frame : frames) {
        cv::Mat& alpha = alphas.emplace_back(frame.size(), CV_32F);
        for (int y = 0; y < frame.rows; ++y)
            for (int x = 0; x < frame.cols; ++x) alpha.at<float>(y, x) = alpha_at(frame, x, y);
    }
    return alphas;
}

/// Schemes that keep planes sample chroma (4:2:0, between its pixels) linearly, with GL_LINEAR.
cv::Mat with_smooth_chroma(const cv::Mat& rgb) {
    cv::Mat full(rgb.size(), CV_32FC2), half, smooth, result(rgb.size(), CV_32FC3);
    for (int y = 0; y < rgb.rows; ++y)
        for (int x = 0; x < rgb.cols; ++x) {
            const glm::vec2 c = chroma(pixel(rgb, x, y));
            full.at<cv::Vec2f>(y, x) = {c.x, c.y};
        }
    cv::resize(full, half, rgb.size() / 2, 0, 0, cv::INTER_AREA);
    cv::resize(half, smooth, rgb.size(), 0, 0, cv::INTER_LINEAR);
    for (int y = 0; y < rgb.rows; ++y)
        for (int x = 0; x < rgb.cols; ++x) {
            const float at = luma(pixel(rgb, x, y));
            const auto& c = smooth.at<cv::Vec2f>(y, x);
            result.at<cv::Vec3f>(y, x) = {at + 1.402f * c[1], at - 0.344136f * c[0] - 0.714136f * c[1],
                                          at + 1.772f * c[0]};
        }
    return result;
}

Frames by_ours(const Frames& frames, const Keying& key) {
    return for_pixels(frames, [&](const cv::Mat& frame, int x, int y) { return key_alpha(pixel(frame, x, y), key); });
}

Keying suggested(const Clip& clip) {
    const KeyingSuggestion s = suggest_keying(clip.file);
    return keying_of(s.keying, s.polarity);
}

/// Lower threshold, counted from the background, and width of the ramp, code values.
Frames ours_with(const Clip& clip, std::array<double, 2> at) {
    const auto low = static_cast<float>(at[0]), high = static_cast<float>(at[0] + at[1]);
    const float base = luma(clip.background);
    return by_ours(clip.planar, clip.coloured() ? Keying{0.0f, 1.0f, chroma(clip.background), low, high, 0.0f, 0.0f}
                                                : Keying{base + low, base + high, {}, 0.0f, 0.0f, 0.0f, 0.0f});
}

/// OBS Studio, "Luma Key": Luma Min and its smoothness.
Frames obs_luma(const Clip& clip, std::array<double, 2> at) {
    const auto low = static_cast<float>(at[0]), smooth = static_cast<float>(at[1]);
    return for_pixels(clip.rgb, [&](const cv::Mat& frame, int x, int y) {
        const float luma709 = glm::dot(pixel(frame, x, y) / 255.0f, glm::vec3(0.2126f, 0.7152f, 0.0722f));
        if (smooth <= 0.0f) return luma709 >= low ? 1.0f : 0.0f;
        return glm::smoothstep(low, low + smooth, luma709);
    });
}

glm::vec2 obs_chroma(glm::vec3 code) {
    const glm::vec3 rgb = code / 255.0f;
    return {glm::dot(rgb, glm::vec3(-0.100644f, -0.338572f, 0.439216f)),
            glm::dot(rgb, glm::vec3(0.439216f, -0.398942f, -0.040274f))};
}

/// OBS Studio, "Chroma Key": similarity and smoothness, of 1. Four samples between pairs of neighbours and the pixel
/// itself.
Frames obs_chroma_key(const Clip& clip, std::array<double, 2> at) {
    const glm::vec2 key = obs_chroma(clip.background);
    return for_pixels(clip.rgb, [&](const cv::Mat& frame, int x, int y) {
        const auto between = [&](int ax, int ay, int bx, int by) {
            return glm::distance(obs_chroma(0.5f * (pixel(frame, x + ax, y + ay) + pixel(frame, x + bx, y + by))), key);
        };
        const float apart =
            (2.0f * (between(-1, -1, -1, 0) + between(1, 0, 1, 1) + between(-1, 1, 0, 1) + between(0, -1, 1, -1)) +
             glm::distance(obs_chroma(pixel(frame, x, y)), key)) /
            9.0f;
        const float mask = (apart - static_cast<float>(at[0])) / std::max(static_cast<float>(at[1]), 1e-4f);
        return std::pow(glm::clamp(mask, 0.0f, 1.0f), 1.5f);
    });
}

/// Opacity as FFmpeg's `filter` leaves it.
Frames by_ffmpeg(const Clip& clip, const std::string& filter) {
    const std::string command = "ffmpeg -v error -i '" + clip.file.string() + "' -vf 'format=yuva420p," + filter +
                                ",extractplanes=a' -f rawvideo -pix_fmt gray -";
    std::FILE* pipe = popen(command.c_str(), "r");
    if (pipe == nullptr) throw std::runtime_error("cannot start ffmpeg");
    Frames alphas;
    cv::Mat grey(clip.rgb[0].size(), CV_8U);
    while (std::fread(grey.data, 1, grey.total(), pipe) == grey.total())
        grey.convertTo(alphas.emplace_back(), CV_32F, 1.0 / 255.0);
    if (pclose(pipe) != 0 || alphas.size() != clip.rgb.size()) throw std::runtime_error("ffmpeg failed: " + filter);
    return alphas;
}

std::string number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.5f", value);
    return text;
}

/// Threshold at the background's luma in the video's own range, 16..235.
Frames ffmpeg_lumakey(const Clip& clip, std::array<double, 2> at) {
    const double threshold = (16.0 + 219.0 / 255.0 * static_cast<double>(luma(clip.background))) / 255.0;
    return by_ffmpeg(clip, "lumakey=" + number(threshold) + ":" + number(at[0]) + ":" + number(at[1]));
}

Frames ffmpeg_chromakey(const Clip& clip, std::array<double, 2> at) {
    char color[16];
    std::snprintf(color, sizeof color, "0x%02x%02x%02x", static_cast<unsigned>(clip.background.r),
                  static_cast<unsigned>(clip.background.g), static_cast<unsigned>(clip.background.b));
    return by_ffmpeg(clip,
                     "chromakey=" + std::string(color) + ":" + number(std::max(at[0], 0.01)) + ":" + number(at[1]));
}

const Keyer ours{"ours", {}, {16.0, 255.0}, ours_with};
const Keyer luma_keyers[] = {{"OBS luma key", {0.0, 0.0}, {0.6, 1.0}, obs_luma},
                             {"FFmpeg lumakey", {0.01, 0.0}, {0.5, 1.0}, ffmpeg_lumakey}};
const Keyer chroma_keyers[] = {{"OBS chroma key", {0.4, 0.08}, {0.4, 0.8}, obs_chroma_key},
                               {"FFmpeg chromakey", {0.01, 0.0}, {0.4, 0.6}, ffmpeg_chromakey}};

/// The least error over both thresholds: a coarse grid, then finer ones around the best.
test::AlphaError best_of(const Keyer& keyer, const Clip& clip) {
    test::AlphaError best{1e9, 1e9};
    std::array<double, 2> at{0.5 * keyer.most[0], 0.5 * keyer.most[1]};
    double reach = 0.5;
    const std::vector<int> grids = short_form ? std::vector{2} : std::vector{12, 4, 4, 4, 4};
    for (const int steps : grids) {
        const std::array<double, 2> middle = at;
        for (int i = 0; i <= steps; ++i)
            for (int j = 0; j <= steps; ++j) {
                std::array<double, 2> here{};
                for (std::size_t n = 0; n < 2; ++n) {
                    const double share = 2.0 * static_cast<double>(n == 0 ? i : j) / steps - 1.0;
                    here[n] = std::clamp(middle[n] + share * reach * keyer.most[n], 0.0, keyer.most[n]);
                }
                const test::AlphaError error = test::alpha_error(keyer.key(clip, here), *clip.smoke);
                if (error.frame < best.frame) best = error, at = here;
            }
        reach *= 2.0 / steps;  // as far as the neighbours of the best
    }
    return best;
}

class Bench {
  public:
    void run(const Clip& clip) {
        const Keying key = suggested(clip);
        add(clip, "ours, suggested, RGB", test::alpha_error(by_ours(clip.rgb, key), *clip.smoke));
        const double mine =
            add(clip, "ours, suggested, planes", test::alpha_error(by_ours(clip.planar, key), *clip.smoke));
        add(clip, "ours, best, planes", best_of(ours, clip));
        for (const Keyer& keyer : clip.coloured() ? chroma_keyers : luma_keyers) {
            const double plain =
                add(clip, keyer.name + ", defaults", test::alpha_error(keyer.key(clip, keyer.defaults), *clip.smoke));
            const double best = add(clip, keyer.name + ", best", best_of(keyer, clip));
            ratio(clip, keyer.name + "_defaults", mine / plain);
            ratio(clip, keyer.name + "_best", mine / best);
        }
    }

    void print_ratios() const {
        for (const auto& [name, value] : ratios_) std::printf("%s %.3g\n", name.c_str(), value);
    }
    void write(const char* path) const {
        std::ofstream(path) << nlohmann::json{{"bench", "keying"}, {"results", results_}, {"ratios", ratios_}}.dump(2)
                            << '\n';
    }

  private:
    double add(const Clip& clip, const std::string& way, test::AlphaError error) {
        std::printf("%-16s %-28s error %.4f over the frame, %.4f where there is smoke\n", clip.name.c_str(),
                    way.c_str(), error.frame, error.smoke);
        std::fflush(stdout);
        results_.push_back(
            {{"clip", clip.name}, {"way", way}, {"error_frame", error.frame}, {"error_smoke", error.smoke}});
        return error.frame;
    }
    void ratio(const Clip& clip, const std::string& other, double value) {
        std::string name = "keying_ours_over_" + other + "_" + clip.name;
        for (char& c : name) c = c == ' ' ? '_' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        ratios_[name] = value;
    }

    nlohmann::json results_ = nlohmann::json::array();
    std::map<std::string, double> ratios_;
};

void run_all(Bench& bench, const std::filesystem::path& folder) {
    const Smoke shaded =
        short_form ? test::solve_smoke({.cells = 16, .frames = 1}) : test::solve_smoke({.cells = 80, .frames = 8});
    // Both are darker than keying_survey.h assumes: that is visible in thick smoke, but not in thin smoke.
    const Smoke even = test::evenly_lit(shaded, 0.8f, 6.0f), thin = test::evenly_lit(shaded, 0.8f);
    const std::pair<const char*, glm::vec3> backgrounds[] = {{"black", glm::vec3(0.0f)},
                                                             {"green", {0.0f, 177.0f, 64.0f}},
                                                             {"blue", {20.0f, 60.0f, 200.0f}},
                                                             {"grey", glm::vec3(96.0f)}};
    for (const auto& [light, smoke] : {std::pair{" even", &even}, {" even thin", &thin}, {" shaded", &shaded}})
        for (const auto& [name, background] : backgrounds) {
            if (short_form && (smoke != &even || background != glm::vec3(0.0f))) continue;
            Clip clip{name + std::string(light), background, smoke, folder / "clip.mp4", {}, {}};
            test::record_smoke(clip.file, *smoke, {.background = background, .sensor_noise = 2.0f});
            clip.rgb = test::read_frames(clip.file);
            for (const cv::Mat& frame : clip.rgb) clip.planar.push_back(with_smooth_chroma(frame));
            bench.run(clip);
        }
}

/// The smoke with `share` times its opacity and light.
Smoke thinned(Smoke smoke, float share) {
    for (clips::Picture& picture : smoke)
        for (std::size_t n = 0; n < picture.alpha.size(); ++n) picture.alpha[n] *= share, picture.value[n] *= share;
    return smoke;
}

/// Frames of a clip with its own opacity: its luma and opacity, over black.
Smoke smoke_of(const std::filesystem::path& file) {
    KeyingReader reader(file);
    if (!reader.report().alpha) throw std::runtime_error(file.string() + ": brings no opacity");
    KeyingFrame frame;
    Smoke smoke;
    constexpr int wanted = 12;
    for (int i = 0; i < wanted; ++i) {
        if (!reader.read(i * (reader.report().frames - 1) / (wanted - 1), frame)) continue;
        const glm::ivec2 size = frame.size - frame.size % 2;  // x264 does not accept odd sizes
        clips::Picture& picture = smoke.emplace_back(size.x, size.y);
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x) {
                const auto from = static_cast<std::size_t>(y * frame.size.x + x),
                           to = static_cast<std::size_t>(y * size.x + x);
                picture.alpha[to] = frame.opacity[from];
                picture.value[to] = std::clamp(frame.luma[from] / 255.0f, 0.0f, frame.opacity[from]);
            }
    }
    return smoke;
}

/// Found and true opacity where the smoke is thickest: means over the thickest hundredth.
std::pair<double, double> peaks(const Frames& found, const Smoke& smoke) {
    std::vector<float> all;
    for (const clips::Picture& picture : smoke) all.insert(all.end(), picture.alpha.begin(), picture.alpha.end());
    const auto rank = all.begin() + static_cast<std::ptrdiff_t>(0.99 * static_cast<double>(all.size()));
    std::nth_element(all.begin(), rank, all.end());
    double is = 0.0, should = 0.0, n = 0.0;
    for (std::size_t i = 0; i < std::min(found.size(), smoke.size()); ++i)
        for (std::size_t at = 0; at < smoke[i].alpha.size(); ++at)
            if (smoke[i].alpha[at] >= *rank)
                is += static_cast<double>(found[i].ptr<float>()[at]), should += static_cast<double>(smoke[i].alpha[at]),
                    n += 1.0;
    return {is / n, should / n};
}

void show_suggested(const std::string& folder, const std::filesystem::path& scratch) {
    const Smoke shaded = test::solve_smoke({.cells = 80, .frames = 8});
    std::vector<std::pair<std::string, Smoke>> takes = {{"solved, even", test::evenly_lit(shaded, 0.8f)},
                                                        {"solved, thick", test::evenly_lit(shaded, 0.8f, 6.0f)},
                                                        {"solved, thick, bright", test::evenly_lit(shaded, 1.0f, 6.0f)},
                                                        {"solved, shaded", shaded}};
    if (!folder.empty())
        for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
            if (entry.path().extension() == ".webm" && entry.path().filename().string().starts_with("smoke"))
                takes.emplace_back(entry.path().parent_path().filename() / entry.path().filename(),
                                   smoke_of(entry.path()));
    for (std::size_t i = 0, own = takes.size(); i < own; ++i)
        takes.emplace_back(takes[i].first + " at .85", thinned(takes[i].second, 0.85f));
    for (const auto& [name, smoke] : takes)
        for (const auto& [on, background] : {std::pair{"black", glm::vec3(0.0f)},
                                             {"grey", glm::vec3(96.0f)},
                                             {"green", glm::vec3(0.0f, 177.0f, 64.0f)},
                                             {"blue", glm::vec3(20.0f, 60.0f, 200.0f)}}) {
            Clip clip{name, background, &smoke, scratch / "clip.mp4", {}, {}};
            test::record_smoke(clip.file, smoke, {.background = background, .sensor_noise = 2.0f});
            for (const cv::Mat& frame : test::read_frames(clip.file)) clip.planar.push_back(with_smooth_chroma(frame));
            const KeyingSuggestion s = suggest_keying(clip.file);
            const Frames found = by_ours(clip.planar, keying_of(s.keying, s.polarity));
            const test::AlphaError error = test::alpha_error(found, smoke);
            const auto [is, should] = peaks(found, smoke);
            std::printf("%-44s %-6s error %.3f, in smoke %.3f; peak %.2f for %.2f; %3.0f %% sure; %s\n", name.c_str(),
                        on, error.frame, error.smoke, is, should, 100.0 * s.confidence, s.reason.c_str());
            std::fflush(stdout);
        }
}

}  // namespace
}  // namespace lapfx::smoke

int main(int argc, char** argv) {
    const bool to_file = argc == 3 && std::strcmp(argv[1], "--json") == 0;
    const bool short_form = lapfx::smoke::short_form = argc == 2 && std::strcmp(argv[1], "--short") == 0;
    const bool suggested = (argc == 2 || argc == 3) && std::strcmp(argv[1], "--suggested") == 0;
    if (argc != 1 && !to_file && !suggested && !short_form) {
        std::fprintf(stderr, "usage: lapfx_keying_accuracy [--json FILE | --suggested [FOLDER] | --short]\n");
        return 2;
    }
    std::string name = (std::filesystem::temp_directory_path() / "lapfx-keying-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) return 1;
    int code = 0;
    try {
        if (suggested) {
            lapfx::smoke::show_suggested(argc == 3 ? argv[2] : "", name);
        } else {
            lapfx::smoke::Bench bench;
            lapfx::smoke::run_all(bench, name);
            bench.print_ratios();
            if (to_file) bench.write(argv[2]);
        }
    } catch (const std::exception& error) {
        std::fprintf(stderr, "lapfx_keying_accuracy: %s\n", error.what());
        code = 1;
    }
    std::filesystem::remove_all(name);
    return code;
}
