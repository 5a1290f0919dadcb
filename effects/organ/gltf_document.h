// A glTF file: tinygltf reads the structure, our code reads the bytes.
//
// tinygltf 2.7 trusts a file too much: it reads image data at unchecked offsets, takes any path or folder for a buffer,
// refuses the empty fallback buffers of EXT_meshopt_compression, and descends into extras without limit. So it gets the
// JSON without buffers, images, extras and everything that an organ does not use; buffers and images are read here.
#pragma once

#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "organ/file.h"
#include "organ/tinygltf.h"

namespace lapfx::organ {

/// tinygltf 2.7 refuses one without inverse bind matrices.
struct GltfSkin {
    std::vector<int> joints;  ///< nodes
    int inverse_bind = -1;    ///< accessor; -1: the joints were bound at the origin
};

struct GltfDocument {
    std::string file;                          ///< the name in faults
    std::filesystem::path folder;              ///< of the file
    tinygltf::Model model;                     ///< with our buffers[].data, images[].uri and images[].bufferView
    std::vector<std::filesystem::path> files;  ///< further files that were read, for buffers
    std::vector<std::string> warnings;         ///< parts that were removed from it
    std::vector<GltfSkin> skins;
    std::map<int, Bytes> decoded;  ///< buffer views that were compressed, by index
    std::size_t unpacked = 0;      ///< bytes that a codec has made of primitives

    /// The bytes of a buffer view, decompressed where needed. Throws Error when it is not there or not in its
    /// buffer.
    std::span<const std::uint8_t> view(int index, const std::string& place);

    /// The path of an image that is a separate file; empty: it is not. Throws Error when its URI may not be followed.
    std::filesystem::path image_file(int index) const;

    /// The bytes of an image, from a view, a data URI or a file (kept in `storage`). When the file cannot be read,
    /// `fault` has the reason. Throws Error when the image's URI may not be followed.
    std::span<const std::uint8_t> image_bytes(int index, Bytes& storage, std::string& fault);
};

/// Throws Error: not a glTF, malformed JSON, a version other than 2, a missing buffer, a required extension that lapfx
/// does not read (each named).
GltfDocument read_gltf_document(const std::filesystem::path& path, const std::string& file, const Bytes& bytes);

}  // namespace lapfx::organ
