# SPDX-License-Identifier: Apache-2.0
# CMake toolchain: Debian's musl-tools for C; for C++ the system's g++ with musl's headers. There is no libstdc++ for
# musl to link with: its headers are enough for the library, and programs in C++ add runtime.cpp.
set(CMAKE_C_COMPILER musl-gcc)
set(CMAKE_CXX_COMPILER g++)
set(CMAKE_CXX_COMPILER_WORKS TRUE)
function(ask_compiler option answer)
  execute_process(COMMAND ${CMAKE_CXX_COMPILER} ${option}
    OUTPUT_VARIABLE text OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
  set(${answer} ${text} PARENT_SCOPE)
endfunction()
ask_compiler(-dumpversion version)
ask_compiler(-print-multiarch multiarch)
ask_compiler(-print-file-name=include own_headers)
set(CMAKE_CXX_FLAGS_INIT "-nostdinc")
foreach(folder
    /usr/include/c++/${version}
    /usr/include/${multiarch}/c++/${version}
    /usr/include/${CMAKE_HOST_SYSTEM_PROCESSOR}-linux-musl
    ${own_headers})
  string(APPEND CMAKE_CXX_FLAGS_INIT " -isystem ${folder}")
endforeach()
# What libstdc++'s headers ask glibc's.
string(APPEND CMAKE_CXX_FLAGS_INIT " \"-D__GLIBC_PREREQ(major,minor)=0\"")
