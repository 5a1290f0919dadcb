#include <fstream>  // which it uses, and without its own reading of files does not include

#define TINYGLTF_IMPLEMENTATION
#include "organ/tinygltf.h"
