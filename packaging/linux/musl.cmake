# SPDX-License-Identifier: Apache-2.0
# CMake toolchain: Debian's g++ with musl's headers and C library, of VESICA_PROCESSOR (x86_64 or aarch64; by default
# this machine's) and in the folder VESICA_MUSL (by default /, where musl-tools puts them). There is no libstdc++ for
# musl to link with: its headers are enough for the library, and programs in C++ add tests/platforms/runtime.cpp.
set(CMAKE_TRY_COMPILE_PLATFORM_VARIABLES VESICA_PROCESSOR VESICA_MUSL)
if(NOT VESICA_PROCESSOR)
  set(VESICA_PROCESSOR ${CMAKE_HOST_SYSTEM_PROCESSOR})
endif()
if(NOT VESICA_PROCESSOR STREQUAL CMAKE_HOST_SYSTEM_PROCESSOR)
  set(CMAKE_SYSTEM_NAME Linux)
  set(CMAKE_SYSTEM_PROCESSOR ${VESICA_PROCESSOR})
endif()
set(CMAKE_C_COMPILER ${VESICA_PROCESSOR}-linux-gnu-gcc)
set(CMAKE_CXX_COMPILER ${VESICA_PROCESSOR}-linux-gnu-g++)
set(CMAKE_CXX_COMPILER_WORKS TRUE)

# gcc's own description of how it works with musl, with the places that it has there.
file(READ ${VESICA_MUSL}/usr/lib/${VESICA_PROCESSOR}-linux-musl/musl-gcc.specs specs)
string(REPLACE " /usr/" " ${VESICA_MUSL}/usr/" specs "${specs}")
string(REPLACE "-L/usr/lib/" "-L${VESICA_MUSL}/lib/${VESICA_PROCESSOR}-linux-musl -L${VESICA_MUSL}/usr/lib/" specs
  "${specs}")
file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/musl-gcc.specs CONTENT "${specs}" @ONLY)
set(CMAKE_C_FLAGS_INIT "-specs=${CMAKE_BINARY_DIR}/musl-gcc.specs")

# g++ searches libstdc++'s headers first; then come musl's, and the compiler's own.
execute_process(COMMAND ${CMAKE_CXX_COMPILER} -E -v -x c++ /dev/null
  ERROR_VARIABLE searched OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "\n /[^\n]*/c\\+\\+/[^\n]*" folders "${searched}")
execute_process(COMMAND ${CMAKE_CXX_COMPILER} -print-file-name=include
  OUTPUT_VARIABLE own_headers OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
list(APPEND folders ${VESICA_MUSL}/usr/include/${VESICA_PROCESSOR}-linux-musl ${own_headers})
set(CMAKE_CXX_FLAGS_INIT "-nostdinc")
foreach(folder IN LISTS folders)
  string(STRIP "${folder}" folder)
  string(APPEND CMAKE_CXX_FLAGS_INIT " -isystem ${folder}")
endforeach()
# What libstdc++'s headers ask glibc's.
string(APPEND CMAKE_CXX_FLAGS_INIT " \"-D__GLIBC_PREREQ(major,minor)=0\"")
