# -DNAMESPACE: the namespace of the tables; default lapfx::gl.
if(NOT NAMESPACE)
    set(NAMESPACE lapfx::gl)
endif()
set(text "// Written at build time from shaders/ by effects/cmake/write_embedded_shaders.cmake.
#include <array>
#include <string_view>
#include <utility>
namespace ${NAMESPACE} {
extern const std::pair<std::string_view, std::string_view>* const embedded_shaders;
extern const unsigned embedded_shader_count;
static constexpr std::pair<std::string_view, std::string_view> files[] = {\n")
foreach(file IN LISTS FILES)
    get_filename_component(name ${file} NAME)
    file(READ ${file} content)
    string(APPEND text "{\"${name}\", R\"shader(${content})shader\"},\n")
endforeach()
string(APPEND text "};
const std::pair<std::string_view, std::string_view>* const embedded_shaders = files;
const unsigned embedded_shader_count = sizeof files / sizeof files[0];
}\n")
file(WRITE ${OUTPUT} "${text}")
