// A glTF file taken apart: the structure by tinygltf, the bytes by us.
//
// tinygltf 2.7 trusts a file too much: it reads image data at unchecked offsets, takes any path or folder for
// a buffer, refuses the empty fallback buffers of EXT_meshopt_compression, and descends into extras without
// limit. So it is given the JSON without buffers, images, extras and what an organ has no use for; those are
// read here.
#pragma once

#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "organ/file.h"
#include "organ/tinygltf.h"

namespace lapfx::organ {

struct GltfDocument {
    std::string file;                          ///< as faults name it
    std::filesystem::path folder;              ///< of the file
    tinygltf::Model model;                     ///< buffers[].data and images[].uri, bufferView filled in by us
    std::vector<std::filesystem::path> files;  ///< of buffers, read besides it
    std::vector<std::string> warnings;         ///< what was taken out of it
    bool has_skins = false;
    std::map<int, Bytes> decoded;  ///< buffer views that were compressed, by index
    std::size_t unpacked = 0;      ///< bytes that a codec has made of primitives

    /// The bytes of a buffer view, decompressed where needed. Throws Error when it is not there or not in its
    /// buffer.
    std::span<const std::uint8_t> view(int index, const std::string& place);

    /// Where an image lies that is a file of its own; empty: it is none. Throws Error when its URI may not be followed.
    std::filesystem::path image_file(int index) const;

    /// The bytes of an image, of a view, a data URI or a file (kept in `storage`); the reason in `fault` when
    /// the file cannot be read. Throws Error when the image's URI may not be followed.
    std::span<const std::uint8_t> image_bytes(int index, Bytes& storage, std::string& fault);
};

/// Throws Error: no glTF, malformed JSON, a version other than 2, a missing buffer, a required extension that
/// is not read (each named).
GltfDocument read_gltf_document(const std::filesystem::path& path, const std::string& file, const Bytes& bytes);

}  // namespace lapfx::organ
