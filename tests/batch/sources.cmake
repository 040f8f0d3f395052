# SPDX-License-Identifier: Apache-2.0
# What the tests of batches are made of, here and on other processors (tests/platforms); paths from tests/.
set(workload_sources
  properties/answers.cpp
  properties/exact_changes.cpp
  properties/generators.cpp
  properties/near_contact.cpp
  properties/pair.cpp
  properties/shape_maker.cpp
  properties/touching.cpp)
set(batch_test_sources
  batch/casts_test.cpp
  batch/checked_test.cpp
  batch/data.cpp
  batch/given_up_test.cpp
  batch/guard_pages.cpp
  batch/guard_pages_test.cpp
  batch/instruction_sets.cpp
  batch/invalid_test.cpp
  batch/many_test.cpp
  batch/matrix_test.cpp
  batch/queries/undecided_test.cpp
  batch/select_test.cpp
  batch/stack_test.cpp
  batch/ties_test.cpp
  batch/tiles_test.cpp
  batch/undecided_test.cpp
  batch/unit_axes_test.cpp)
