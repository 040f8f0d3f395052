# SPDX-License-Identifier: Apache-2.0
# vesica_windows_exports(target map): a DLL that exports the names of the version script and nothing else, by a module
# definition file made from it. It is installed too: other compilers make their import library from it.
function(vesica_windows_exports target map)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${map})
  file(STRINGS ${map} names REGEX "^ +[a-z0-9_]+;$")
  list(TRANSFORM names REPLACE "[ ;]" "")
  list(JOIN names "\n  " names)
  get_target_property(output ${target} OUTPUT_NAME)
  set(definition ${CMAKE_CURRENT_BINARY_DIR}/${output}.def)
  file(CONFIGURE OUTPUT ${definition} CONTENT "LIBRARY ${output}.dll\nEXPORTS\n  @names@\n" @ONLY)
  target_sources(${target} PRIVATE ${definition})
  set_target_properties(${target} PROPERTIES PREFIX "")  # vesica.dll, not libvesica.dll
  if(VESICA_INSTALL)
    install(FILES ${definition} DESTINATION ${CMAKE_INSTALL_LIBDIR})
  endif()
endfunction()
