# SPDX-License-Identifier: Apache-2.0
# Tests of pairs: overlap/<first>_<second>_test.cpp, or overlap/<second>_test.cpp for all pairs of one shape.
# vesica_pair_tests(out stems): those of all pairs of VESICA_EACH_PAIR in include/vesica/each_shape.hpp, and the pairs'
# names, which pairs_test compares with the list.
set(vesica_shapes_file ${CMAKE_CURRENT_LIST_DIR}/../../include/vesica/each_shape.hpp)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${vesica_shapes_file})

function(vesica_pair_tests out stems)
  file(READ ${vesica_shapes_file} text)
  string(REGEX MATCHALL "  X\\([a-z_]+, [A-Z][A-Za-z]+, [a-z_]+, [A-Z]" pairs "${text}")
  foreach(pair IN LISTS pairs)
    string(REGEX MATCH "X\\(([a-z_]+), [A-Za-z]+, ([a-z_]+)," match "${pair}")
    list(APPEND names ${CMAKE_MATCH_1}_${CMAKE_MATCH_2})
    set(file overlap/${CMAKE_MATCH_1}_${CMAKE_MATCH_2}_test.cpp)
    if(NOT EXISTS ${CMAKE_CURRENT_SOURCE_DIR}/${file})
      set(file overlap/${CMAKE_MATCH_2}_test.cpp)
    endif()
    list(APPEND files ${file})
  endforeach()
  list(REMOVE_DUPLICATES files)
  set(${out} ${files} PARENT_SCOPE)
  list(JOIN names " " names)
  set(${stems} "${names}" PARENT_SCOPE)
endfunction()
