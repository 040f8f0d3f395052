# SPDX-License-Identifier: Apache-2.0
# Tests of pairs: overlap/<first>_<second>_test.cpp, or overlap/<second>_test.cpp for all pairs of one shape.
# vesica_pair_tests(out): those of all pairs of VESICA_EACH_PAIR in include/vesica/each_shape.hpp.
set(vesica_shapes_file ${CMAKE_CURRENT_LIST_DIR}/../include/vesica/each_shape.hpp)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${vesica_shapes_file})

function(vesica_pair_tests out)
  file(STRINGS ${vesica_shapes_file} lines REGEX "^  X\\([a-z]+, [A-Z][a-z]+, [a-z]+, [A-Z]")
  foreach(line IN LISTS lines)
    string(REGEX MATCH "X\\(([a-z]+), [A-Za-z]+, ([a-z]+)," match "${line}")
    set(file overlap/${CMAKE_MATCH_1}_${CMAKE_MATCH_2}_test.cpp)
    if(NOT EXISTS ${CMAKE_CURRENT_SOURCE_DIR}/${file})
      set(file overlap/${CMAKE_MATCH_2}_test.cpp)
    endif()
    list(APPEND files ${file})
  endforeach()
  list(REMOVE_DUPLICATES files)
  set(${out} ${files} PARENT_SCOPE)
endfunction()
