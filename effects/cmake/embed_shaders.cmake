# Every file in shaders/ as a string in the library: the core needs no data folder to draw. The editor reads the
# same files from disk instead, so that a change shows while it runs (gl/shader_source.h).
file(GLOB shader_files CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/shaders/*)
list(FILTER shader_files EXCLUDE REGEX "/ui[^/]*$")  # the UI toolkit embeds these itself
set(embedded ${PROJECT_BINARY_DIR}/embedded_shaders.cpp)
add_custom_command(OUTPUT ${embedded}
    COMMAND ${CMAKE_COMMAND} -DOUTPUT=${embedded} "-DFILES=${shader_files}"
        -P ${CMAKE_CURRENT_LIST_DIR}/write_embedded_shaders.cmake
    DEPENDS ${shader_files} ${CMAKE_CURRENT_LIST_DIR}/write_embedded_shaders.cmake
    COMMENT "Embedding shaders/" VERBATIM)
add_library(lapfx_shaders OBJECT ${embedded})
