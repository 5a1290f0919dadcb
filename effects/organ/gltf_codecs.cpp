#include "organ/gltf_codecs.h"

#include <algorithm>

#include "organ/draco.h"
#include "organ/meshopt.h"

namespace lapfx::organ {

namespace {

constexpr GltfCodec codecs[] = {
    {.extension = "EXT_meshopt_compression", .decode_view = decode_meshopt},
    {.extension = "KHR_draco_mesh_compression", .decode_primitive = decode_draco},
};

}  // namespace

const GltfCodec* find_codec(std::string_view extension) {
    const auto found = std::find_if(std::begin(codecs), std::end(codecs),
                                    [&](const GltfCodec& codec) { return codec.extension == extension; });
    return found != std::end(codecs) ? found : nullptr;
}

}  // namespace lapfx::organ
