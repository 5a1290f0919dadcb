# Debian packages: `cpack -G DEB` in the build folder makes, in packages/ there, liblapfx (the shared library),
# liblapfx-dev (what a host is built with), python3-lapfx (its module) and lapfx (the programs, with presets, samples,
# man pages and what a desktop shows). -DCPACK_PACKAGE_CONTACT="NAME <ADDRESS>" says who made them.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME lapfx)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_CONTACT "lapfx <nobody@lapfx.invalid>" CACHE STRING "Name and address of who makes the packages")
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR}/packages)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_COMPONENTS_ALL library development python program)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_STRIP_FILES ON)
# Whatever umask they are made with.
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE
    WORLD_READ WORLD_EXECUTE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# While the first number of the version is 0, a package that is built with one version needs that version.
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS_POLICY =)

set(what_it_is "lapfx draws bleeding, burnt tissue and surgical smoke over the organs of a
laparoscopic simulator, with the OpenGL context of the simulator, as a preset
says that was tuned in its editor.")
set(CPACK_DEBIAN_LIBRARY_PACKAGE_NAME liblapfx)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SECTION libs)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_CONTROL_EXTRA ${CMAKE_CURRENT_LIST_DIR}/triggers)  # the linker's list of libraries
set(CPACK_DEBIAN_LIBRARY_PACKAGE_RECOMMENDS "libosmesa6, libgl1-mesa-dri")  # without a context of the host's
set(CPACK_DEBIAN_LIBRARY_DESCRIPTION "bleeding and surgical smoke for laparoscopic simulators (library)
${what_it_is}

This package has the shared library.")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME liblapfx-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SHLIBDEPS OFF)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "liblapfx (= ${PROJECT_VERSION}), libglm-dev")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_RECOMMENDS "lapfx")  # presets, samples, and the pages that the headers name
set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION "bleeding and surgical smoke for laparoscopic simulators (development)
${what_it_is}

This package has the headers for C++ and C, and the files by which CMake and
pkg-config find the library.")

# Compiled when it is installed, so that nothing is left when it is removed.
set(python ${CMAKE_CURRENT_LIST_DIR}/python)
set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-lapfx)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS OFF)
set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA ${python}/postinst ${python}/prerm)
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "liblapfx (= ${PROJECT_VERSION}), python3, python3-numpy")
set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS "libosmesa6, libgl1-mesa-dri")  # it makes its own contexts
set(CPACK_DEBIAN_PYTHON_DESCRIPTION "bleeding and surgical smoke for laparoscopic simulators (Python 3)
${what_it_is}

This package has the module for Python, which gives pictures as numpy arrays.")

# dpkg-shlibdeps finds what is linked, but not what is opened while it runs: Mesa's drivers and the editor's fonts.
set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME lapfx)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS "libgl1-mesa-dri, libosmesa6, fonts-inter, fonts-dejavu-core")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS "parallel")
set(CPACK_DEBIAN_PROGRAM_DESCRIPTION "editor for bleeding and smoke of laparoscopic simulators
The editor of lapfx tunes bleeding and surgical smoke until they match a
surgery video, and saves the result as a preset, which the library of lapfx
draws in a laparoscopic simulator.

Its commands need no display: they render a scene, measure the blood and smoke
of a video, find the preset that shows as much of both, and tell how close it
is. Presets, organs, clips and a scene to begin with are in this package.")

# The first line of the changelog has the version of the packages.
set(changelog ${CMAKE_CURRENT_LIST_DIR}/changelog)
file(STRINGS ${changelog} newest LIMIT_COUNT 1)
if(NOT newest MATCHES "^lapfx \\(${PROJECT_VERSION}\\) ")
    message(FATAL_ERROR "${changelog} begins with \"${newest}\"; allowed is \"lapfx (${PROJECT_VERSION}) ...\"")
endif()
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${changelog})
execute_process(COMMAND gzip -9nc ${changelog} OUTPUT_FILE ${PROJECT_BINARY_DIR}/changelog.gz COMMAND_ERROR_IS_FATAL ANY)
foreach(component ${CPACK_COMPONENTS_ALL})
    string(TOUPPER ${component} name)
    install(FILES ${CMAKE_CURRENT_LIST_DIR}/copyright ${PROJECT_BINARY_DIR}/changelog.gz
        DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${CPACK_DEBIAN_${name}_PACKAGE_NAME} COMPONENT ${component})
endforeach()
include(CPack)
