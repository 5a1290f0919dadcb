#include "organ/check.h"

#include <cmath>

#include "organ/raw.h"

namespace lapfx {

namespace {

class Check {
  public:
    explicit Check(const Organ& organ) : organ_(organ) {}

    void vertices() const {
        const Organ& o = organ_;
        const std::size_t count = o.positions.size();
        const std::pair<const char*, std::size_t> arrays[] = {{"normals", o.normals.size()},
                                                              {"tangents", o.tangents.size()},
                                                              {"uvs", o.uvs.size()},
                                                              {"colors", o.colors.size()}};
        for (const auto& [place, size] : arrays)
            if (size != count)
                refuse(place, std::to_string(size) + "; there are " + std::to_string(count) + " positions");
        for (std::size_t i = 0; i < count; ++i)
            for (int k = 0; k < 3; ++k)
                if (!(std::abs(o.positions[i][k]) <= organ::farthest))
                    refuse("positions/" + std::to_string(i),
                           std::to_string(o.positions[i][k]) + " is not a number from -1e9 to 1e9");
    }
    void triangles() const { organ::require_corners(organ_.name, organ_.indices, organ_.positions.size()); }
    void parts() const {
        for (std::size_t i = 0; i < organ_.parts.size(); ++i) {
            const Part& part = organ_.parts[i];
            const std::string place = "parts/" + std::to_string(i);
            const std::uint64_t end = std::uint64_t{part.first_index} + part.index_count;
            if (part.first_index % 3 != 0 || part.index_count % 3 != 0 || end > organ_.indices.size())
                refuse(place, std::to_string(part.index_count) + " from " + std::to_string(part.first_index) +
                                  " on; there are " + std::to_string(organ_.indices.size()) +
                                  " indices, three for each triangle");
            if (part.material < 0 || static_cast<std::size_t>(part.material) >= organ_.materials.size())
                refuse(place + "/material", std::to_string(part.material) + "; there are " +
                                                std::to_string(organ_.materials.size()) + " materials");
        }
    }
    void images() const {
        for (std::size_t i = 0; i < organ_.materials.size(); ++i) {
            const std::string place = "materials/" + std::to_string(i);
            for (const int image : {organ_.materials[i].base_color_image, organ_.materials[i].normal_image})
                organ::require_image(organ_.name, place, image, organ_.images.size());
        }
        for (std::size_t i = 0; i < organ_.images.size(); ++i) {
            const Image& image = organ_.images[i];
            const std::size_t wanted =
                static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) * 4;
            if (image.width < 0 || image.height < 0 || (!image.pixels.empty() && image.pixels.size() != wanted))
                refuse("images/" + std::to_string(i), std::to_string(image.width) + "x" + std::to_string(image.height) +
                                                          " with " + std::to_string(image.pixels.size()) +
                                                          " bytes; four for each pixel are needed");
        }
    }

  private:
    [[noreturn]] void refuse(const std::string& place, const std::string& reason) const {
        organ::refuse(organ_.name, place, reason);
    }

    const Organ& organ_;
};

}  // namespace

void organ::require_corners(std::string_view name, std::span<const std::uint32_t> indices, std::size_t positions) {
    const std::string file(name);
    if (indices.size() % 3 != 0) refuse(file, "indices", std::to_string(indices.size()) + "; each triangle has three");
    for (std::size_t i = 0; i < indices.size(); ++i)
        if (indices[i] >= positions)
            refuse(file, "indices/" + std::to_string(i),
                   std::to_string(indices[i]) + "; there are " + std::to_string(positions) + " positions");
}

void organ::require_image(std::string_view name, const std::string& place, int image, std::size_t images) {
    if (image < -1 || image >= static_cast<int>(images))
        refuse(std::string(name), place,
               std::to_string(image) + "; there are " + std::to_string(images) + " images, and -1 is none");
}

void organ::require_complete(const Organ& organ) {
    const Check check(organ);
    check.vertices();
    check.triangles();
    check.parts();
    check.images();
}

}  // namespace lapfx
