# SPDX-License-Identifier: GPL-3.0-or-later
# How every target of the project is compiled.

# An interface that carries language, warnings and floating-point rules.
add_library(gyro_compile INTERFACE)
target_compile_features(gyro_compile INTERFACE cxx_std_20)
target_include_directories(gyro_compile INTERFACE ${PROJECT_SOURCE_DIR})
target_compile_options(gyro_compile INTERFACE
  $<$<COMPILE_LANGUAGE:CXX>:-Wall -Wextra -Wpedantic -Wshadow -Werror>
  # Same bits on every machine, thread count and device: no contraction, no reordering.
  # Not asking for errno or traps changes no value and lets loops vectorise.
  $<$<COMPILE_LANGUAGE:CXX>:-ffp-contract=off -fno-math-errno -fno-trapping-math>)
if(GYRO_NATIVE)
  # -Wno-psabi: packs of 16 floats are only passed inside inlined functions.
  # Not what is handed to other machines, a target with the property GYRO_PORTABLE.
  target_compile_options(gyro_compile INTERFACE
    $<$<AND:$<COMPILE_LANGUAGE:CXX>,$<NOT:$<BOOL:$<TARGET_PROPERTY:GYRO_PORTABLE>>>>:-march=native -mprefer-vector-width=512>)
endif()
target_compile_options(gyro_compile INTERFACE $<$<COMPILE_LANGUAGE:CXX>:-Wno-psabi>)

# Sanitizers change no arithmetic: the floating-point rules above stay.
set(GYRO_SANITIZE "" CACHE STRING "Sanitizers, as in -fsanitize=: address,undefined or thread (with clang++)")
if(GYRO_SANITIZE)
  set(sanitize -fsanitize=${GYRO_SANITIZE} -fno-sanitize-recover=all)
  target_compile_options(gyro_compile INTERFACE
    $<$<COMPILE_LANGUAGE:CXX>:${sanitize} -fno-omit-frame-pointer>
    # The inserted checks hide from GCC that a value is set on every path.
    $<$<COMPILE_LANG_AND_ID:CXX,GNU>:-Wno-maybe-uninitialized>)
  target_link_options(gyro_compile INTERFACE $<$<LINK_LANGUAGE:CXX>:${sanitize}>)
endif()

# gyro_library(NAME SOURCES ... [PUBLIC libs...] [PRIVATE libs...])
function(gyro_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;PUBLIC;PRIVATE" ${ARGN})
  add_library(${name} STATIC ${ARG_SOURCES})
  target_link_libraries(${name} PUBLIC gyro_compile ${ARG_PUBLIC} PRIVATE ${ARG_PRIVATE})
endfunction()

# gyro_test(NAME SOURCES ... LIBS ... [LABELS ...]): one Catch2 executable, one ctest per test case.
# Without LABELS a test is `unit`; `nightly` ones run only when asked for.
function(gyro_test name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LIBS;LABELS" ${ARGN})
  if(NOT ARG_LABELS)
    set(ARG_LABELS unit)
  endif()
  add_executable(${name} ${ARG_SOURCES})
  target_link_libraries(${name} PRIVATE gyro_compile ${ARG_LIBS} Catch2::Catch2WithMain)
  catch_discover_tests(${name} TEST_PREFIX "${name}: " PROPERTIES TIMEOUT 600)
  # catch_discover_tests() would keep only the first of several labels. Its file, which ctest
  # has read by the time it reads ours, leaves the names in <name>_TESTS.
  set(labels_file ${CMAKE_CURRENT_BINARY_DIR}/${name}_labels.cmake)
  file(WRITE ${labels_file}
    "foreach(test IN LISTS ${name}_TESTS)\n"
    "  set_tests_properties(\"\${test}\" PROPERTIES LABELS \"${ARG_LABELS}\")\n"
    "endforeach()\n")
  set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES ${labels_file})
endfunction()
