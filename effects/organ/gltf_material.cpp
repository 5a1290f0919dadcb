#include "organ/gltf_material.h"

#include <compare>

namespace lapfx::organ {

namespace {

using tinygltf::ExtensionMap;
using tinygltf::Value;

double number(const Value& value, double fallback) {
    return value.IsNumber() ? value.GetNumberAsDouble() : fallback;
}

double number(const Value& object, const char* key, std::size_t index, double fallback) {
    if (!object.IsObject() || !object.Has(key)) return fallback;
    const Value& array = object.Get(key);
    if (!array.IsArray() || index >= array.ArrayLen()) return fallback;
    return number(array.Get(static_cast<int>(index)), fallback);
}

/// A texture as a material refers to it.
struct TextureUse {
    int texture = -1;
    UvUse uv;
};

UvUse uv_use(int set, const ExtensionMap& extensions) {
    UvUse use;
    use.set = set;
    const auto found = extensions.find("KHR_texture_transform");
    if (found == extensions.end() || !found->second.IsObject()) return use;
    const Value& transform = found->second;
    for (int i = 0; i < 2; ++i) {
        const auto index = static_cast<std::size_t>(i);
        use.offset[i] = static_cast<float>(number(transform, "offset", index, 0.0));
        use.scale[i] = static_cast<float>(number(transform, "scale", index, 1.0));
    }
    if (transform.Has("rotation")) use.rotation = static_cast<float>(number(transform.Get("rotation"), 0.0));
    if (transform.Has("texCoord") && transform.Get("texCoord").IsInt())
        use.set = transform.Get("texCoord").GetNumberAsInt();
    return use;
}

struct Wraps {
    Wrap u = Wrap::repeat, v = Wrap::repeat;
    auto operator<=>(const Wraps&) const = default;
};

/// Reads each image once, however many materials use it. One that textures continue in different ways is there for
/// each, up to a number of them.
class Images {
  public:
    Images(GltfDocument& document, RawOrgan& organ) : document_(document), organ_(organ) {}

    /// Index into RawOrgan::images of a texture's image, or -1.
    int of_texture(int texture, const std::string& place) {
        if (texture < 0) return -1;
        if (static_cast<std::size_t>(texture) >= document_.model.textures.size())
            refuse(document_.file, place, "texture " + std::to_string(texture) + " is not in the file");
        const tinygltf::Texture& from = document_.model.textures[static_cast<std::size_t>(texture)];
        const std::string at = "/textures/" + std::to_string(texture);
        const int source = source_of(from);
        if (source < 0) return -1;
        if (static_cast<std::size_t>(source) >= document_.model.images.size())
            refuse(document_.file, at, "image " + std::to_string(source) + " is not in the file");
        const Wraps wraps = wraps_of(from.sampler, at);
        std::map<Wraps, int>& uses = known_[source];
        if (const auto known = uses.find(wraps); known != uses.end()) return known->second;
        if (uses.size() >= most_uses) return share(uses, wraps);
        const int made = uses.empty() ? read(source) : copy_image(organ_, uses.begin()->second);
        if (made >= 0) {
            Image& image = organ_.images[static_cast<std::size_t>(made)];
            image.wrap_u = wraps.u;
            image.wrap_v = wraps.v;
        }
        return uses[wraps] = made;
    }

  private:
    /// Each is a copy of the pixels, and a picture of 250 KB may have 256 MB of them.
    static constexpr std::size_t most_uses = 4;

    /// The image for one more way to continue it: one that is there already.
    int share(std::map<Wraps, int>& uses, const Wraps& wraps) {
        const int shared = uses.begin()->second;
        if (shared >= 0 && uses.size() == most_uses)
            organ_.warnings.push_back("texture " + organ_.images[static_cast<std::size_t>(shared)].name +
                                      ": is continued beyond its edges in more than " + std::to_string(most_uses) +
                                      " ways; the further ones are drawn like one of these");
        return uses[wraps] = shared;
    }

    Wraps wraps_of(int sampler, const std::string& place) {
        if (sampler < 0) return {};
        if (static_cast<std::size_t>(sampler) >= document_.model.samplers.size())
            refuse(document_.file, place + "/sampler", "sampler " + std::to_string(sampler) + " is not in the file");
        const tinygltf::Sampler& from = document_.model.samplers[static_cast<std::size_t>(sampler)];
        const auto wrap = [&](int mode, const char* key) {
            if (mode == TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE) return Wrap::clamp;
            if (mode == TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT) return Wrap::mirror;
            if (mode != TINYGLTF_TEXTURE_WRAP_REPEAT)
                organ_.warnings.push_back("/samplers/" + std::to_string(sampler) + "/" + key + " is " +
                                          std::to_string(mode) + ", expected 33071, 33648 or 10497; repeated");
            return Wrap::repeat;
        };
        return {.u = wrap(from.wrapS, "wrapS"), .v = wrap(from.wrapT, "wrapT")};
    }

    static int source_of(const tinygltf::Texture& texture) {
        const auto webp = texture.extensions.find("EXT_texture_webp");
        if (webp != texture.extensions.end() && webp->second.IsObject() && webp->second.Has("source") &&
            webp->second.Get("source").IsInt())
            return webp->second.Get("source").GetNumberAsInt();
        return texture.source;
    }

    int read(int source) {
        const tinygltf::Image& from = document_.model.images[static_cast<std::size_t>(source)];
        Image image;
        const bool named_by_file = !from.uri.empty() && !from.uri.starts_with("data:");
        image.name = !from.name.empty() ? from.name
                     : named_by_file    ? percent_decoded(from.uri)
                                        : "image " + std::to_string(source);
        Bytes storage;
        std::string fault;
        const std::span<const std::uint8_t> bytes = document_.image_bytes(source, storage, fault);
        if (fault.empty()) fault = decode_texture(bytes, image, organ_.warnings);
        if (const std::filesystem::path file = document_.image_file(source); !file.empty())
            (fault.empty() ? organ_.files : organ_.unread_files).push_back(file);
        if (!fault.empty()) {
            organ_.warnings.push_back("texture " + image.name + ": " + fault + "; it is left out");
            return -1;
        }
        organ_.images.push_back(std::move(image));
        organ_.encoded.push_back(std::make_shared<const Bytes>(bytes.begin(), bytes.end()));
        return static_cast<int>(organ_.images.size()) - 1;
    }

    GltfDocument& document_;
    RawOrgan& organ_;
    std::map<int, std::map<Wraps, int>> known_;  ///< glTF image to RawOrgan images; -1 = unreadable
};

glm::vec4 color(const std::vector<double>& factor) {
    glm::vec4 out(1.0f);
    for (std::size_t i = 0; i < std::min<std::size_t>(factor.size(), 4); ++i)
        out[static_cast<int>(i)] = static_cast<float>(factor[i]);
    return out;
}

/// The older material model: its diffuse colour is used as base colour.
void specular_glossiness(const Value& extension, Material& material, TextureUse& base) {
    if (!extension.IsObject()) return;
    for (int i = 0; i < 4; ++i)
        material.base_color[i] =
            static_cast<float>(number(extension, "diffuseFactor", static_cast<std::size_t>(i), 1.0));
    if (extension.Has("glossinessFactor"))
        material.roughness = 1.0f - static_cast<float>(number(extension.Get("glossinessFactor"), 1.0));
    if (!extension.Has("diffuseTexture") || !extension.Get("diffuseTexture").IsObject()) return;
    const Value& texture = extension.Get("diffuseTexture");
    if (texture.Has("index") && texture.Get("index").IsInt()) base.texture = texture.Get("index").GetNumberAsInt();
    if (texture.Has("texCoord") && texture.Get("texCoord").IsInt())
        base.uv.set = texture.Get("texCoord").GetNumberAsInt();
}

/// Materials that the file wants see-through, by their mode.
void warn_of_alpha(const std::vector<tinygltf::Material>& materials, std::vector<std::string>& warnings) {
    constexpr std::size_t most_named = 5;
    for (const char* mode : {"MASK", "BLEND"}) {
        std::size_t count = 0;
        std::string names;
        for (const tinygltf::Material& material : materials)
            if (material.alphaMode == mode && ++count <= most_named)
                names += (count > 1 ? ", " : "") + (material.name.empty() ? "(unnamed)" : material.name);
        if (count > 0)
            warnings.push_back(counted(count, "material has", "materials have") + " the alpha mode " + mode + " (" +
                               names + (count > most_named ? ", ..." : "") + "); drawn opaque");
    }
}

UvUse read_material(const tinygltf::Material& from, int index, Images& images, RawOrgan& organ) {
    const std::string place = "/materials/" + std::to_string(index);
    const auto& pbr = from.pbrMetallicRoughness;
    Material material;
    material.name = from.name;
    material.base_color = color(pbr.baseColorFactor);
    material.roughness = std::clamp(static_cast<float>(pbr.roughnessFactor), 0.0f, 1.0f);
    material.normal_scale = static_cast<float>(from.normalTexture.scale);
    material.double_sided = from.doubleSided;

    TextureUse base{pbr.baseColorTexture.index, uv_use(pbr.baseColorTexture.texCoord, pbr.baseColorTexture.extensions)};
    const TextureUse normal{from.normalTexture.index,
                            uv_use(from.normalTexture.texCoord, from.normalTexture.extensions)};
    const auto old = from.extensions.find("KHR_materials_pbrSpecularGlossiness");
    if (old != from.extensions.end() && base.texture < 0) specular_glossiness(old->second, material, base);

    material.base_color_image = images.of_texture(base.texture, place + "/baseColorTexture");
    material.normal_image = images.of_texture(normal.texture, place + "/normalTexture");
    const bool both = material.base_color_image >= 0 && material.normal_image >= 0;
    if (both && base.uv != normal.uv) {
        // Vertices have one set of texture coordinates.
        organ.warnings.push_back("material " + from.name + ": its normal map has other texture coordinates than its " +
                                 "base colour; the normal map is left out");
        material.normal_image = -1;
    }
    organ.materials.push_back(std::move(material));
    return base.texture >= 0 ? base.uv : normal.texture >= 0 ? normal.uv : UvUse{};
}

}  // namespace

glm::vec2 UvUse::apply(glm::vec2 uv) const {
    // KHR_texture_transform: translation * rotation * scale, v down.
    const glm::vec2 scaled = uv * scale;
    const float c = std::cos(rotation), s = std::sin(rotation);
    return offset + glm::vec2(c * scaled.x + s * scaled.y, -s * scaled.x + c * scaled.y);
}

std::vector<UvUse> read_materials(GltfDocument& document, RawOrgan& organ) {
    Images images(document, organ);
    std::vector<UvUse> uses;
    int index = 0;
    for (const tinygltf::Material& material : document.model.materials)
        uses.push_back(read_material(material, index++, images, organ));
    warn_of_alpha(document.model.materials, organ.warnings);
    return uses;
}

}  // namespace lapfx::organ
