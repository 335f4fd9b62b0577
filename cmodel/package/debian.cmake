# SPDX-License-Identifier: Apache-2.0

# ./run package: a Debian package of each component, by CPack. What shared libraries they need,
# dpkg-shlibdeps finds; what it cannot see is named here.
set(CPACK_GENERATOR DEB)
set(CPACK_COMPONENTS_ALL ${components})
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
if(NOT CPACK_PACKAGE_CONTACT)
  set(CPACK_PACKAGE_CONTACT "Halfspace maintainers <halfspace@example.invalid>")
endif()
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_ENABLE_COMPONENT_DEPENDS ON)
foreach(component IN LISTS components)
  string(TOUPPER ${component} key)
  set(CPACK_DEBIAN_${key}_PACKAGE_NAME ${package_${component}})
endforeach()

# The program builds RTL on demand, waves with zlib. dpi/run.py has Verilator run make, and builds
# against the library.
set(CPACK_COMPONENT_RUNTIME_DESCRIPTION
    "The program halfspace, the SystemVerilog of the design, and the model for its benches.")
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SECTION electronics)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_RECOMMENDS "verilator, g++ | c++-compiler, make, zlib1g-dev")
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SUGGESTS "libhalfspace-dev, python3")

set(CPACK_COMPONENT_LIBRARY_DESCRIPTION "The shared library of the C interface.")
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SECTION libs)
# What a package that links the library depends on, for its dpkg-shlibdeps.
file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/shlibs
     "libhalfspace ${abi} ${package_library} (>= ${PROJECT_VERSION})\n")
set(CPACK_DEBIAN_LIBRARY_PACKAGE_CONTROL_EXTRA ${CMAKE_CURRENT_BINARY_DIR}/shlibs)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

# Dependencies are those of the default components of find_package, recommendations of the others.
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION
    "Headers and static libraries of the C++ model and the C interface, with files for builds.")
set(CPACK_COMPONENT_DEVELOPMENT_DEPENDS library)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "libglm-dev, libhwy-dev")
set(io libfmt-dev libpng-dev libtbb-dev nlohmann-json3-dev zlib1g-dev)
if(HALFSPACE_HAS_MESHOPTIMIZER)
  list(APPEND io libmeshoptimizer-dev)
endif()
list(JOIN io ", " CPACK_DEBIAN_DEVELOPMENT_PACKAGE_RECOMMENDS)

# The module is built for one version of the interpreter.
get_directory_property(python DIRECTORY ${PROJECT_SOURCE_DIR}/cmodel/python
                       DEFINITION Python_VERSION_MINOR)
math(EXPR next "${python} + 1")
set(CPACK_COMPONENT_PYTHON_DESCRIPTION "The Python module.")
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
    "python3 (>= 3.${python}~), python3 (<< 3.${next}), python3-numpy")

include(CPack)
