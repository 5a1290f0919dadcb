# What a host installs: liblapfx.so, which exports what is marked LAPFX_API (lapfx/api.h, lapfx.h), its headers, the
# module for Python, and the files by which find_package(lapfx) and pkg-config find it. No installed file names a folder
# of this machine: the folder that was installed into can be moved.
include(CMakePackageConfigHelpers)

# While the first number of the version is 0, the first two tell what fits.
set(fits ${PROJECT_VERSION_MAJOR})
if(fits EQUAL 0)
    set(fits ${fits}.${PROJECT_VERSION_MINOR})
endif()

# One library: lapfx::c is what a host in C needs of it, lapfx::effects adds what its headers in C++ need.
add_library(lapfx_shared SHARED $<TARGET_OBJECTS:lapfx_simulation> $<TARGET_OBJECTS:lapfx_effects>
    $<TARGET_OBJECTS:lapfx_shaders> $<TARGET_OBJECTS:lapfx_c>)
set_target_properties(lapfx_shared PROPERTIES OUTPUT_NAME lapfx EXPORT_NAME c LINKER_LANGUAGE CXX
    VERSION ${PROJECT_VERSION} SOVERSION ${fits} LINK_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/lapfx.map)
# For the libraries that these link; their own objects are those above.
target_link_libraries(lapfx_shared PRIVATE lapfx_effects)
# Also hidden is what comes from libraries that are linked statically and from templates of the standard library.
target_link_options(lapfx_shared PRIVATE -Wl,--version-script=${CMAKE_CURRENT_SOURCE_DIR}/lapfx.map -Wl,--no-undefined)
add_library(lapfx_in_cpp INTERFACE)
set_target_properties(lapfx_in_cpp PROPERTIES EXPORT_NAME effects)
target_link_libraries(lapfx_in_cpp INTERFACE lapfx_shared glm::glm)
target_compile_features(lapfx_in_cpp INTERFACE cxx_std_20)

install(TARGETS lapfx_shared lapfx_in_cpp EXPORT lapfx
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT library NAMELINK_COMPONENT development
    INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(DIRECTORY include/lapfx DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development
    FILES_MATCHING PATTERN "*.h")
install(FILES c/include/lapfx.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/samples/host DESTINATION ${CMAKE_INSTALL_DATADIR}/lapfx/samples
    COMPONENT development FILES_MATCHING PATTERN "*.cpp" PATTERN "*.c" PATTERN "*.py")
# Debian's Python looks there below /usr; elsewhere PYTHONPATH has to name it.
install(FILES c/lapfx.py DESTINATION lib/python3/dist-packages COMPONENT python)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/lapfx)
install(EXPORT lapfx NAMESPACE lapfx:: FILE lapfxTargets.cmake DESTINATION ${package_dir} COMPONENT development)
set(lapfx_data ${CMAKE_INSTALL_DATADIR}/lapfx)
configure_package_config_file(cmake/lapfxConfig.cmake.in lapfxConfig.cmake INSTALL_DESTINATION ${package_dir}
    PATH_VARS lapfx_data)
write_basic_package_version_file(lapfxConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/lapfxConfig.cmake ${CMAKE_CURRENT_BINARY_DIR}/lapfxConfigVersion.cmake
    DESTINATION ${package_dir} COMPONENT development)

file(RELATIVE_PATH prefix_of_pc /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
foreach(package lapfx lapfx-c)
    configure_file(cmake/${package}.pc.in ${package}.pc @ONLY)
    install(FILES ${CMAKE_CURRENT_BINARY_DIR}/${package}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig
        COMPONENT development)
endforeach()
