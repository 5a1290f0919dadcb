# What a host installs: liblapfx.so, which exports what is marked LAPFX_API (lapfx/api.h), its headers, and the files by
# which find_package(lapfx) and pkg-config find it. No installed file names a folder of this machine: the folder that
# was installed into can be moved.
include(CMakePackageConfigHelpers)

add_library(lapfx_shared SHARED $<TARGET_OBJECTS:lapfx_simulation> $<TARGET_OBJECTS:lapfx_effects>
    $<TARGET_OBJECTS:lapfx_shaders>)
set_target_properties(lapfx_shared PROPERTIES OUTPUT_NAME lapfx EXPORT_NAME effects LINKER_LANGUAGE CXX
    VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR} LINK_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/lapfx.map)
# For the libraries that these link; their own objects are those above.
target_link_libraries(lapfx_shared PRIVATE lapfx_effects INTERFACE glm::glm)
# Also hidden is what comes from libraries that are linked statically and from templates of the standard library.
target_link_options(lapfx_shared PRIVATE -Wl,--version-script=${CMAKE_CURRENT_SOURCE_DIR}/lapfx.map -Wl,--no-undefined)
target_compile_features(lapfx_shared INTERFACE cxx_std_20)

install(TARGETS lapfx_shared EXPORT lapfx
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT library NAMELINK_COMPONENT development
    INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(DIRECTORY include/lapfx DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/lapfx)
install(EXPORT lapfx NAMESPACE lapfx:: FILE lapfxTargets.cmake DESTINATION ${package_dir} COMPONENT development)
configure_package_config_file(cmake/lapfxConfig.cmake.in lapfxConfig.cmake INSTALL_DESTINATION ${package_dir})
# While the first number of the version is 0, the second one tells what fits.
write_basic_package_version_file(lapfxConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/lapfxConfig.cmake ${CMAKE_CURRENT_BINARY_DIR}/lapfxConfigVersion.cmake
    DESTINATION ${package_dir} COMPONENT development)

file(RELATIVE_PATH prefix_of_pc /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
configure_file(cmake/lapfx.pc.in lapfx.pc @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/lapfx.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig
    COMPONENT development)
