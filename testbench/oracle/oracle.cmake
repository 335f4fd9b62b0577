# SPDX-License-Identifier: Apache-2.0

# halfspace_oracle, when CGAL is there: exact predicates, no line of cmodel/.
if(NOT TARGET halfspace_oracle)
  find_package(CGAL QUIET)
  if(CGAL_FOUND)
    add_library(halfspace_oracle STATIC
      ${CMAKE_CURRENT_LIST_DIR}/oracle.cpp ${CMAKE_CURRENT_LIST_DIR}/metrics.cpp)
    target_include_directories(halfspace_oracle PUBLIC ${CMAKE_CURRENT_LIST_DIR})
    target_link_libraries(halfspace_oracle PRIVATE halfspace_options CGAL::CGAL)
  endif()
endif()
