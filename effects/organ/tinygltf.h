// tinygltf as a part of the core: lapfx::organ::tinygltf, compiled from the package's header by tinygltf.cpp.
//
// Debian's libdraco exports a tinygltf of another build under the same names as libtinygltf, with other layouts. Which
// of the two a program gets is a matter of the order in which they are loaded; a host that loads libdraco first would
// crash. Under a name of its own the core meets neither. Files and images we read ourselves (gltf_document.h).
#pragma once

#define TINYGLTF_NO_FS
#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#define tinygltf lapfx::organ::tinygltf
#include <tiny_gltf.h>
#undef tinygltf
