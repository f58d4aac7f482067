# SPDX-License-Identifier: Apache-2.0
# GTKWave's writer of fast signal traces (FST), of the sources that come with Debian's verilator.
find_package(ZLIB REQUIRED)
find_path(PYRASIM_FST_SOURCES fstapi.c PATHS /usr/share/verilator/include/gtkwave /usr/local/share/verilator/include/gtkwave
          NO_DEFAULT_PATH DOC "folder of GTKWave's fstapi.c, fastlz.c and lz4.c")
if(NOT PYRASIM_FST_SOURCES)
  message(FATAL_ERROR "GTKWave's fstapi.c is missing: install verilator, or set PYRASIM_FST_SOURCES to its folder")
endif()

add_library(pyrasim_fst STATIC ${PYRASIM_FST_SOURCES}/fstapi.c ${PYRASIM_FST_SOURCES}/fastlz.c
                               ${PYRASIM_FST_SOURCES}/lz4.c)
target_include_directories(pyrasim_fst SYSTEM INTERFACE $<BUILD_INTERFACE:${PYRASIM_FST_SOURCES}>)
target_compile_definitions(pyrasim_fst PRIVATE FST_CONFIG_INCLUDE="fst_config.h")
target_compile_options(pyrasim_fst PRIVATE -w)
target_link_libraries(pyrasim_fst PRIVATE ZLIB::ZLIB)
