# SPDX-License-Identifier: Apache-2.0
#
# Every C++ file is as clang-format (.clang-format) writes it.
find_program(CLANG_FORMAT NAMES clang-format clang-format-14 REQUIRED)
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
message(STATUS "${count} files formatted")
