# SPDX-License-Identifier: Apache-2.0
# The instruction set to compile for, as -march takes it. Results do not depend on it: nothing is contracted or
# reassociated, whatever it is.
if(DEFINED PYRASIM_NATIVE AND NOT PYRASIM_NATIVE)
  message(FATAL_ERROR "PYRASIM_NATIVE=OFF is now PYRASIM_ARCH=x86-64, or any other that -march takes")
endif()
set(own_instruction_set "")
if(CMAKE_BUILD_TYPE STREQUAL "Release")
  set(own_instruction_set native)
endif()
set(PYRASIM_ARCH "${own_instruction_set}" CACHE STRING
    "instruction set: native (this machine's), x86-64, x86-64-v2, x86-64-v3 ...; empty: the compiler's own choice")

if(PYRASIM_ARCH)
  include(CheckCXXCompilerFlag)
  string(MAKE_C_IDENTIFIER "pyrasim_knows_${PYRASIM_ARCH}" known)
  check_cxx_compiler_flag("-march=${PYRASIM_ARCH}" ${known})
  if(NOT ${known})
    message(FATAL_ERROR "PYRASIM_ARCH=${PYRASIM_ARCH}: ${CMAKE_CXX_COMPILER} does not know this instruction set; "
                        "native, x86-64, x86-64-v2 and x86-64-v3 are allowed on a PC")
  endif()
  target_compile_options(pyrasim_flags INTERFACE $<BUILD_INTERFACE:-march=${PYRASIM_ARCH}>)
  check_cxx_compiler_flag(-mno-avx512f pyrasim_knows_avx512)
  if(pyrasim_knows_avx512)  # valgrind does not
    target_compile_options(pyrasim_flags INTERFACE $<BUILD_INTERFACE:-mno-avx512f>)
  endif()
endif()
