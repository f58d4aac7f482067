# SPDX-License-Identifier: Apache-2.0
# Debian packages, by cpack: pyrasim, the program, and libpyrasim-dev, what others build upon.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "pyrasim developers <pyrasim@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "software model of a ray tracing processor")
set(CPACK_VERBATIM_VARIABLES ON)
set(CPACK_STRIP_FILES ON)

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL program development)
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)

if(PYRASIM_ARCH STREQUAL "native")
  set(runs_on "It is optimised for the processor that built it, and may not start on another one.")
elseif(PYRASIM_ARCH)
  set(runs_on "It runs on every processor of the instruction set ${PYRASIM_ARCH}.")
else()
  set(runs_on "It runs on every processor of its architecture.")
endif()
set(CPACK_COMPONENT_PROGRAM_DESCRIPTION
    "Renders and simulates pictures, cycle by cycle, whose edges are smoothed by pixel pyramids. ${runs_on}")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME pyrasim)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS "glmark2-data, gtkwave")  # the mesh of a scene; a viewer for --trace

set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION
    "Libraries, headers and the CMake package: the renderer, and the processor's stages as SystemC modules. ${runs_on}")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libpyrasim-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
string(CONCAT CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
       "pyrasim (= ${PROJECT_VERSION}), libsystemc-dev, libglm-dev, nlohmann-json3-dev, libfmt-dev, libpng-dev, zlib1g-dev, libssl-dev, "
       "pkg-config")

foreach(package IN ITEMS pyrasim libpyrasim-dev)
  set(component program)
  if(package STREQUAL "libpyrasim-dev")
    set(component development)
  endif()
  install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${package} RENAME copyright
          COMPONENT ${component})
endforeach()
include(CPack)
