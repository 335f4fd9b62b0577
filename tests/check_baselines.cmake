# SPDX-License-Identifier: Apache-2.0
#
# The kernels compile whatever instruction set the compiler may use already: Highway then has other
# targets to build. COMPILER, ROOT, GLM, HIGHWAY.
foreach(baseline x86-64-v2 x86-64-v3 x86-64-v4 sapphirerapids native)
  foreach(kernel coverage/coverage_kernel.cpp cycle/cycle_kernel.cpp frame/frame_kernel.cpp)
    execute_process(COMMAND ${COMPILER} -std=c++20 -fsyntax-only -march=${baseline}
                            -I${ROOT}/cmodel -I${GLM} -I${HIGHWAY}
                            ${ROOT}/cmodel/engines/${kernel}
                    RESULT_VARIABLE result ERROR_VARIABLE output)
    if(result)
      message(FATAL_ERROR "${kernel} does not compile for ${baseline}:\n${output}")
    endif()
  endforeach()
endforeach()
