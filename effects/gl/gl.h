// The OpenGL 4.5 functions. Every file that calls GL includes this and nothing else for it.
#pragma once

#include <glad/gl.h>
