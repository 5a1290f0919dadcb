# lapfx_discover_groups(TARGET LABEL [BY_FILE]): the cases of a program of tests become tests of ctest, one for each
# folder of test files, or for each file. Cases of a group share a process: to start a program that links OpenCV takes
# 0.2 s, and to open a context and load an organ takes longer. A group is labelled with its suites:
#     tests/run -R unit.smoke        tests/run -L Haze        build/lapfx_unit_tests --gtest_filter='HazeCurve.*'
set(write_groups ${CMAKE_CURRENT_LIST_DIR}/write_groups.py)

function(lapfx_discover_groups target label)
    set(list ${CMAKE_CURRENT_BINARY_DIR}/${target}_groups.cmake)
    add_custom_command(TARGET ${target} POST_BUILD
        COMMAND ${LAPFX_PYTHON} ${write_groups} $<TARGET_FILE:${target}> ${PROJECT_SOURCE_DIR}/tests ${list} ${label} ${ARGN}
        BYPRODUCTS ${list} VERBATIM)
    # Before the first build there is no list, and no test.
    file(GENERATE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/${target}_include.cmake CONTENT "include(\"${list}\" OPTIONAL)\n")
    set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES ${CMAKE_CURRENT_BINARY_DIR}/${target}_include.cmake)
endfunction()
