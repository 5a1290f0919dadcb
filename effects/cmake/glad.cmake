# The OpenGL 4.5 core loader, written by glad 2 at build time, offline.
find_program(LAPFX_GLAD glad REQUIRED)
set(glad_dir ${PROJECT_BINARY_DIR}/glad)
add_custom_command(OUTPUT ${glad_dir}/src/gl.c ${glad_dir}/include/glad/gl.h
    COMMAND ${LAPFX_GLAD} --quiet --reproducible --api gl:core=4.5 --extensions "" --out-path ${glad_dir} c
    COMMENT "glad: OpenGL 4.5 core loader" VERBATIM)
add_library(lapfx_glad STATIC ${glad_dir}/src/gl.c ${glad_dir}/include/glad/gl.h)
target_include_directories(lapfx_glad SYSTEM PUBLIC ${glad_dir}/include)
set_target_properties(lapfx_glad PROPERTIES POSITION_INDEPENDENT_CODE ON)
