# vesica_library(name MAP map SOURCES source... [LINK library...] [HAND_ON library...]): one library behind the C interface,
# shared or static as BUILD_SHARED_LIBS says. Programs that link it also link what is handed on. The target
# vesica_methods has the alias vesica::methods, and its file is libvesica-methods.
include(CheckLinkerFlag)
include(${CMAKE_CURRENT_LIST_DIR}/windows.cmake)

# A linker that does not know a flag does without: names are hidden by the compiler already, and versions of symbols
# are ELF's alone. The map of the trial is empty, for a linker may insist that the names in a map are defined.
set(any_map ${CMAKE_CURRENT_BINARY_DIR}/any.map)
file(WRITE ${any_map} "{ local: *; };\n")
check_linker_flag(C -Wl,--version-script=${any_map} VESICA_LINKER_HAS_VERSION_SCRIPT)
set(library_link_options)
foreach(flag --no-undefined-version -z,defs -O1)
  string(MAKE_C_IDENTIFIER "VESICA_LINKER_HAS${flag}" known)
  check_linker_flag(C -Wl,${flag} ${known})
  if(${known})
    list(APPEND library_link_options -Wl,${flag})
  endif()
endforeach()

# MSVC's runtime has the functions of libm.
set(libm m)
if(WIN32 AND NOT MINGW)
  set(libm)
endif()

function(vesica_library name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "MAP" "SOURCES;LINK;HAND_ON")
  string(REGEX REPLACE "^vesica_" "" alias ${name})
  string(REPLACE "_" "-" output ${name})
  add_library(${name} ${arg_SOURCES})
  set(headers $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  target_link_libraries(${name}
    PRIVATE $<BUILD_INTERFACE:vesica_core> $<BUILD_INTERFACE:vesica_flags> ${arg_LINK} ${libm}
    INTERFACE ${arg_HAND_ON})
  target_include_directories(${name} PUBLIC ${headers} PRIVATE ${PROJECT_SOURCE_DIR}/src)
  target_compile_definitions(${name} PRIVATE VESICA_BUILDING)
  target_compile_options(${name} PRIVATE -fno-exceptions -fno-rtti -fno-threadsafe-statics)
  # Linked by the C driver, so that nothing of libstdc++ can slip in: an undefined symbol of it fails the link.
  # Position independent in the archive too, which then serves the shared libraries of other languages.
  set_target_properties(${name} PROPERTIES
    OUTPUT_NAME ${output}
    EXPORT_NAME ${alias}
    LINKER_LANGUAGE C
    POSITION_INDEPENDENT_CODE ON
    DEFINE_SYMBOL ""
    CXX_VISIBILITY_PRESET hidden
    VISIBILITY_INLINES_HIDDEN ON
    VERSION ${PROJECT_VERSION}
    SOVERSION ${PROJECT_VERSION_MAJOR})
  if(BUILD_SHARED_LIBS)
    # As one source: apart, most of the time goes into headers that all of them read. An archive keeps its parts, so
    # that a program takes from it what it calls.
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
      set_target_properties(${name} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 0)
    endif()
    target_link_options(${name} PRIVATE ${library_link_options})
    if(WIN32)
      vesica_windows_exports(${name} ${arg_MAP})
      # SSE2 has no instruction that counts bits: the compiler calls a function of its own, by default in another DLL.
      target_link_options(${name} PRIVATE $<$<BOOL:${MINGW}>:-static-libgcc>)
    elseif(VESICA_LINKER_HAS_VERSION_SCRIPT)
      target_link_options(${name} PRIVATE -Wl,--version-script=${arg_MAP})
      set_target_properties(${name} PROPERTIES LINK_DEPENDS ${arg_MAP})
    endif()
    add_library(vesica::${alias} ALIAS ${name})
  else()
    # Whoever links an archive of C++ is linked by the C++ driver and with its runtime, which this one does not need.
    # So it is handed on as a file, by a target that is installed as vesica::${alias} too: what a parent installs may
    # then name it. The installed archive is vesica::${alias}_archive, and vesica-config.cmake says its language.
    add_library(${name}_interface INTERFACE)
    add_dependencies(${name}_interface ${name})
    target_include_directories(${name}_interface INTERFACE ${headers})
    list(TRANSFORM arg_HAND_ON APPEND _interface)
    target_link_libraries(${name}_interface INTERFACE
      $<BUILD_INTERFACE:$<TARGET_FILE:${name}>> $<INSTALL_INTERFACE:${name}> ${arg_LINK} ${arg_HAND_ON} ${libm})
    set_target_properties(${name} PROPERTIES EXPORT_NAME ${alias}_archive)
    set_target_properties(${name}_interface PROPERTIES EXPORT_NAME ${alias})
    add_library(vesica::${alias} ALIAS ${name}_interface)
  endif()
endfunction()
