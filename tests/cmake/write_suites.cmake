# cmake -D PROGRAM=... -D LIST=... -D LABEL=... -P write_suites.cmake: asks the program for its suites and writes a test
# for each into LIST. A suite counts as skipped when no test of it ran.
execute_process(COMMAND ${PROGRAM} --gtest_list_tests OUTPUT_VARIABLE listed RESULT_VARIABLE result)
if(result)
    message(FATAL_ERROR "${PROGRAM} --gtest_list_tests: ${result}\n${listed}")
endif()
string(REPLACE ";" "\\;" listed "${listed}")
string(REPLACE "\n" ";" lines "${listed}")
set(written "")
foreach(line IN LISTS lines)
    if(line MATCHES "^([A-Za-z0-9_/]+)\\.( |$)")
        set(suite ${CMAKE_MATCH_1})
        string(APPEND written "add_test([==[${suite}]==] [==[${PROGRAM}]==] [==[--gtest_filter=${suite}.*]==])\n"
            "set_tests_properties([==[${suite}]==] PROPERTIES LABELS ${LABEL} TIMEOUT 3600 "
            "SKIP_REGULAR_EXPRESSION [==[\\[  PASSED  \\] 0 tests\\.\n(\\[  SKIPPED \\] [^\n]*\n)+$]==])\n")
    endif()
endforeach()
file(WRITE ${LIST} "${written}")
