# lapfx_discover_suites(TARGET LABEL): each suite of a program of tests becomes one test of ctest. To start a program
# that links OpenCV takes 0.2 s, which one process for each of some thousand tests would pay again and again.
#     tests/run -R Haze        build/lapfx_unit_tests --gtest_filter='HazeCurve.*'
set(write_suites ${CMAKE_CURRENT_LIST_DIR}/write_suites.cmake)

function(lapfx_discover_suites target label)
    set(list ${CMAKE_CURRENT_BINARY_DIR}/${target}_suites.cmake)
    add_custom_command(TARGET ${target} POST_BUILD
        COMMAND ${CMAKE_COMMAND} -D PROGRAM=$<TARGET_FILE:${target}> -D LIST=${list} -D LABEL=${label} -P ${write_suites}
        BYPRODUCTS ${list} VERBATIM)
    # Before the first build there is no list, and no test.
    file(GENERATE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/${target}_include.cmake CONTENT "include(\"${list}\" OPTIONAL)\n")
    set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES ${CMAKE_CURRENT_BINARY_DIR}/${target}_include.cmake)
endfunction()
