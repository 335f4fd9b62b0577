# SPDX-License-Identifier: Apache-2.0

# The components of this build. Each brings the licence, in the folder of the Debian package that it
# becomes.
set(components runtime development)
set(package_runtime halfspace)
set(package_development libhalfspace-dev)
if(HALFSPACE_CAPI)
  list(APPEND components library)
  get_target_property(abi halfspace_capi SOVERSION)
  set(package_library libhalfspace${abi})
endif()
if(TARGET halfspace_python)
  list(APPEND components python)
  set(package_python python3-halfspace)
endif()
foreach(component IN LISTS components)
  install(FILES ${PROJECT_SOURCE_DIR}/LICENSE RENAME copyright COMPONENT ${component}
          DESTINATION ${CMAKE_INSTALL_DATAROOTDIR}/doc/${package_${component}})
endforeach()

# CMake installs nothing of a component that it does not know, and calls that a success.
if(PROJECT_IS_TOP_LEVEL)
  list(JOIN components "|" pattern)
  list(JOIN components ", " names)
  install(CODE "
    if(CMAKE_INSTALL_COMPONENT AND NOT CMAKE_INSTALL_COMPONENT MATCHES \"^(${pattern})$\")
      message(FATAL_ERROR \"no component \${CMAKE_INSTALL_COMPONENT}, but ${names}\")
    endif()" ALL_COMPONENTS)
endif()
if(PROJECT_IS_TOP_LEVEL AND HALFSPACE_CLI AND TARGET halfspace_python)
  include(debian.cmake)
endif()
