#include "lapfx/prepared_organ.h"

#include <atomic>
#include <chrono>
#include <cmath>
#include <future>
#include <mutex>

#include "foundation.h"
#include "lapfx/authoring/compare.h"
#include "lapfx/authoring/file.h"
#include "lapfx/authoring/placed_picture.h"
#include "lapfx/authoring/tissue_report.h"
#include "media/plate_picture.h"
#include "organ/load.h"
#include "organ/refine.h"

namespace lapfx {

namespace {

// Shares of the whole time, for a textured organ.
constexpr double loaded = 0.3, refined = 0.35, tool_loaded = 0.4;
constexpr std::size_t most_kept_bytes = std::size_t{64} << 20;  // a larger picture of a plate is not kept
constexpr double split = 0.1;                                   // share of that for an organ that is already loaded

template <typename T>
std::size_t bytes_of(const std::vector<T>& data) {
    return data.size() * sizeof(T);
}

/// Its images are without pixels.
std::size_t bytes_of(const Organ& organ) {
    return bytes_of(organ.positions) + bytes_of(organ.normals) + bytes_of(organ.tangents) + bytes_of(organ.uvs) +
           bytes_of(organ.colors) + bytes_of(organ.indices);
}

std::filesystem::path path_of(const Scene& scene, const std::string& file, const std::string& place) {
    return named_path(scene.folder, file, Reach::anywhere, "", place);
}

/// Whether both names lead to the same file.
bool same_file(const Scene& a, const std::string& in_a, const Scene& b, const std::string& in_b) {
    if (in_a.empty() || in_b.empty()) return in_a == in_b;
    if (in_a == in_b && a.folder == b.folder) return true;
    return std::filesystem::absolute(a.folder / in_a).lexically_normal() ==
           std::filesystem::absolute(b.folder / in_b).lexically_normal();
}

bool same_plate(const Scene& a, const Scene& b) {
    const SceneCamera &from = a.camera, &to = b.camera;
    static const Table& placement = *scene_table().find("reference")->find("placement");
    return same_file(a, a.reference.file, b, b.reference.file) && a.reference.aspect == b.reference.aspect &&
           equal(placement, &a.reference.placement, &b.reference.placement) &&
           equal(*scene_table().find("plate"), &a.plate, &b.plate) && from.eye == to.eye && from.target == to.target &&
           from.up == to.up && from.field_of_view == to.field_of_view;
}

organ::SplitOrgan split_of(Organ organ, const work::Stages& stages) {
    const organ::RefinePlan plan = organ::plan_refine(organ, stages.part(0.0, 0.0));
    return organ::refine(std::move(organ), plan, stages);
}

std::string seconds(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.4g s", value);
    return text;
}

/// Decodes it on a thread of its own, so that `stages` are asked while a long video is opened or searched.
media::PlatePicture decoded(const std::filesystem::path& video, const ScenePlate& plate, const work::Stages& stages) {
    using namespace std::chrono_literals;
    stages.reach(0.0);
    std::atomic<bool> stop = false;
    std::atomic<double> share = 0.0;
    const Progress told = [&](double reached) {
        share = reached;
        return !stop;
    };
    std::future<media::PlatePicture> picture = std::async(std::launch::async, [&] {
        // A reader of its own: it searches the film for its frame, and no host has one that it could lend.
        VideoReader reader(video, &stop);
        return media::plate_picture(reader, plate, work::Stages(told).part(0.1, 1.0), &stop);
    });  // waited for before what it refers to goes
    try {
        while (picture.wait_for(20ms) != std::future_status::ready) stages.reach(share);
    } catch (const work::Stopped&) {
        stop = true;
        throw;
    }
    return picture.get();
}

/// What the picture of a plate is decoded from.
struct PlateSource {
    std::filesystem::path video;
    std::filesystem::file_time_type written;
    std::uintmax_t bytes = 0;
    PlateFrame frame{};
    double time = 0.0;
    int frames = 0;
    double span = 0.0;
    friend bool operator==(const PlateSource&, const PlateSource&) = default;
};

/// None for what is no single file: numbered images.
std::optional<PlateSource> plate_source(const std::filesystem::path& video, const ScenePlate& plate) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(video, error)) return std::nullopt;
    PlateSource source{.video = std::filesystem::absolute(video, error).lexically_normal(),
                       .written = std::filesystem::last_write_time(video, error),
                       .bytes = std::filesystem::file_size(video, error),
                       .frame = plate.frame,
                       .time = plate.frame == PlateFrame::chosen ? plate.time : 0.0,
                       .frames = plate.frames,
                       .span = plate.span};
    return error ? std::nullopt : std::optional(std::move(source));
}

/// The last one that was decoded: a plate is made again for every other camera and depth, its picture is not.
class LastPlatePicture {
  public:
    std::shared_ptr<const media::PlatePicture> of(const PlateSource& source) {
        const std::lock_guard lock(mutex_);
        return source_ == source ? picture_ : nullptr;
    }
    void keep(const PlateSource& source, std::shared_ptr<const media::PlatePicture> picture) {
        const std::lock_guard lock(mutex_);
        source_ = source;
        picture_ = std::move(picture);
    }

  private:
    std::mutex mutex_;
    std::optional<PlateSource> source_;
    std::shared_ptr<const media::PlatePicture> picture_;
};

media::PlatePicture plate_picture(const std::filesystem::path& video, const ScenePlate& plate,
                                  const work::Stages& stages) {
    static LastPlatePicture last;
    const std::optional<PlateSource> source = plate_source(video, plate);
    if (source) {
        if (const auto known = last.of(*source)) {
            stages.reach(0.0);
            return *known;
        }
    }
    const auto made = std::make_shared<const media::PlatePicture>(decoded(video, plate, stages));
    if (source && made->image.pixels.size() <= most_kept_bytes) last.keep(*source, made);
    return *made;
}

/// How a plate came about, for people.
std::string plate_name(const media::PlatePicture& picture, const std::filesystem::path& video) {
    std::string text = "frame at " + seconds(picture.time) + " of " + video.filename().string();
    if (picture.blended > 1) text += ", " + std::to_string(picture.blended) + " frames blended";
    return text;
}

/// Of the round view: shares of the picture's width and height.
struct Rim {
    glm::dvec2 center{0.5}, radius{0.5};
};
Rim placed(const Rim& rim, const ReferencePlacement& placement, double aspect) {
    const glm::dvec2 heights(aspect, 1.0), radius = rim.radius * heights;
    const double c = std::cos(glm::radians(placement.rotation)), s = std::sin(glm::radians(placement.rotation));
    const glm::dvec2 turned(std::hypot(c * radius.x, s * radius.y), std::hypot(s * radius.x, c * radius.y));
    return {.center = lapfx::placed(placement, aspect, rim.center * heights) / heights,
            .radius = placement.scale * turned / heights};
}

/// The plate of the scene, in place of its organ. It lies where the reference is placed, so that both pictures show the
/// same tissue at the same place.
Organ plate_organ(const Scene& scene, std::optional<organ::Plate>& plate, const work::Stages& stages) {
    if (scene.reference.file.empty())
        throw Error(Failure::bad_input, Fault{.file = "",
                                              .place = "/plate/use",
                                              .reason = "the scene has no reference video to take the plate from"});
    const std::filesystem::path video = path_of(scene, scene.reference.file, "/reference/file");
    media::PlatePicture picture = plate_picture(video, scene.plate, stages);
    glm::dvec2 size(picture.image.width, picture.image.height);
    Rim rim{.center = glm::dvec2(0.5), .radius = glm::length(size) / 2.0 / size};  // without one it is in the corners
    if (picture.view.disc) rim = {picture.view.disc->center / size, picture.view.disc->radius / size};
    if (scene.reference.aspect > 0.0) size.x = size.y * scene.reference.aspect;
    if (const ReferencePlacement& placement = scene.reference.placement; placement.moved()) {
        picture.image = placed(picture.image, placement, size.x / size.y);
        rim = placed(rim, placement, size.x / size.y);
    }
    plate = organ::plate_of(scene, size, rim.center, rim.radius);
    picture.image.name = video.filename().string();
    Organ organ = organ::plate_organ(*plate, std::move(picture.image));
    organ.name = plate_name(picture, video);
    if (std::error_code error; std::filesystem::is_regular_file(video, error)) organ.files = {video};
    if (picture.left_out > 0)
        organ.warnings.push_back("plate: " + std::to_string(picture.left_out) + " of " +
                                 std::to_string(picture.blended + picture.left_out) + " frames do not fit the one at " +
                                 seconds(picture.time) + " and are left out");
    return organ;
}

/// Runs a task that Stopped may end.
template <typename F>
std::shared_ptr<const PreparedOrgan> unless_stopped(const F& work) {
    try {
        return PreparedOrganAccess::make(work());
    } catch (const work::Stopped&) {
        return nullptr;
    }
}

}  // namespace

Foundation::Foundation(const Organ& organ, const VesselParameters& vessels, const work::Stages& stages,
                       organ::Unsplit from, organ::PixelList given)
    : unsplit(std::move(from)),
      surface(organ, stages.part(0.0, 0.3)),
      pixels(given.empty() ? organ::copied_pixels(organ) : std::move(given)),
      tissue(organ, surface, vessels, stages.part(0.3, 1.0), pixels) {
    tissue.rest();  // the densities made here serve the first preset with these parameters
    stages.reach(1.0);
}

PreparedOrgan::PreparedOrgan(std::unique_ptr<const State> state) : state_(std::move(state)) {}
PreparedOrgan::~PreparedOrgan() = default;

const Organ& PreparedOrgan::organ() const {
    return state_->organ;
}

std::vector<std::filesystem::path> files_of(const PreparedOrgan& organ) {
    const PreparedOrganAccess::State& known = PreparedOrganAccess::state(organ);
    std::vector<std::filesystem::path> files;
    for (const Organ* made : {&known.organ, known.tool ? &*known.tool : nullptr}) {
        if (made == nullptr) continue;
        files.insert(files.end(), made->files.begin(), made->files.end());
        files.insert(files.end(), made->unread_files.begin(), made->unread_files.end());
    }
    return files;
}

std::vector<std::filesystem::path> tool_files_of(const PreparedOrgan& organ) {
    const std::optional<Organ>& tool = PreparedOrganAccess::state(organ).tool;
    return tool ? tool->files : std::vector<std::filesystem::path>();
}

OrganOptions organ_options(const Scene& scene) {
    OrganOptions options{.scale = scene.organ.scale, .rotation = scene.organ.rotation};
    if (!scene.organ.texture.empty()) options.texture = path_of(scene, scene.organ.texture, "/organ/texture");
    return options;
}

bool same_organ(const Scene& a, const Scene& b) {
    if (!same_file(a, a.tool.file, b, b.tool.file) || a.tool.scale != b.tool.scale) return false;
    if (a.plate.use || b.plate.use) return a.plate.use == b.plate.use && same_plate(a, b);
    return same_file(a, a.organ.file, b, b.organ.file) && a.organ.scale == b.organ.scale &&
           a.organ.rotation == b.organ.rotation && same_file(a, a.organ.texture, b, b.organ.texture);
}

bool made_for(const PreparedOrgan& prepared, const Scene& scene) {
    return same_organ(PreparedOrganAccess::state(prepared).source, scene);
}

std::size_t PreparedOrgan::State::own_memory() const {
    return bytes_of(organ) + (tool ? bytes_of(*tool) : 0);
}

std::size_t PreparedOrgan::memory() const {
    const Foundation& known = *state_->foundation;
    return state_->own_memory() + state_->tool_pixel_memory() + known.surface_memory() + known.pixel_memory() +
           known.tissue.shared_memory() + known.tissue.own_memory();
}

std::shared_ptr<const PreparedOrgan> prepare_organ(const Scene& scene, const VesselParameters& vessels,
                                                   const Progress& progress) {
    return unless_stopped([&] {
        const work::Stages stages(progress);
        auto made = std::make_unique<PreparedOrganAccess::State>();
        made->source = scene;
        made->source.events.clear();
        made->source.curves = {};
        std::vector<organ::Encoded> encoded;
        std::optional<organ::Plate> plate;
        organ::SplitOrgan fine =
            split_of(scene.plate.use ? plate_organ(scene, plate, stages.part(0.0, loaded))
                                     : organ::load(path_of(scene, scene.organ.file, "/organ/file"),
                                                   organ_options(scene), stages.part(0.0, loaded), &encoded),
                     stages.part(loaded, refined));
        made->organ = std::move(fine.organ);
        organ::PixelList pixels = organ::take_pixels(made->organ, encoded);
        if (!scene.tool.file.empty()) {
            std::vector<organ::Encoded> tool_encoded;
            made->tool =
                organ::load(path_of(scene, scene.tool.file, "/tool/file"), {.scale = scene.tool.scale, .rotation = {}},
                            stages.part(refined, tool_loaded), &tool_encoded);
            made->tool_pixels = organ::take_pixels(*made->tool, tool_encoded);
        }
        auto foundation = std::make_shared<Foundation>(made->organ, vessels, stages.part(tool_loaded, 1.0),
                                                       std::move(fine.from), std::move(pixels));
        foundation->plate = plate;
        made->foundation = std::move(foundation);
        return made;
    });
}

std::shared_ptr<const PreparedOrgan> prepare_organ(Organ organ, const VesselParameters& vessels,
                                                   const Progress& progress) {
    return unless_stopped([&] {
        const work::Stages stages(progress);
        auto made = std::make_unique<PreparedOrganAccess::State>();
        organ::SplitOrgan fine = split_of(std::move(organ), stages.part(0.0, split));
        made->organ = std::move(fine.organ);
        organ::PixelList pixels = organ::take_pixels(made->organ, {});
        made->foundation = std::make_shared<const Foundation>(made->organ, vessels, stages.part(split, 1.0),
                                                              std::move(fine.from), std::move(pixels));
        return made;
    });
}

TissueHistogram tissue_histogram(const PreparedOrgan& organ, const VesselParameters& parameters) {
    return PreparedOrganAccess::state(organ).foundation->tissue.histogram(parameters);
}

}  // namespace lapfx
