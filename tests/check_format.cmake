# SPDX-License-Identifier: Apache-2.0
#
# Every C++ file is as clang-format (.clang-format) writes it, version 14 (Debian 12) or 19 (13):
# the sources are written so that these two agree.
find_program(CLANG_FORMAT NAMES clang-format clang-format-14 clang-format-19 REQUIRED)
execute_process(COMMAND ${CLANG_FORMAT} --version OUTPUT_VARIABLE version)
string(REGEX MATCH "version ([0-9]+)" found "${version}")
if(NOT CMAKE_MATCH_1 MATCHES "^(14|19)$")
  string(STRIP "${version}" version)
  message(STATUS "SKIPPED: ${version} may format otherwise than 14 and 19, which agree")
  return()
endif()
file(GLOB_RECURSE sources ${ROOT}/cmodel/*.[ch]pp ${ROOT}/cmodel/*.[ch] ${ROOT}/testbench/*.[ch]pp
                          ${ROOT}/testbench/*.[ch] ${ROOT}/tests/*.[ch]pp ${ROOT}/tests/*.[ch])
list(LENGTH sources count)
if(count EQUAL 0)
  message(FATAL_ERROR "no sources found below ${ROOT}")
endif()
execute_process(COMMAND ${CLANG_FORMAT} --dry-run --Werror ${sources}
                RESULT_VARIABLE result ERROR_VARIABLE output)
if(result)
  message(FATAL_ERROR "not formatted; run clang-format -i:\n${output}")
endif()
message(STATUS "${count} files formatted, says clang-format ${CMAKE_MATCH_1}")
