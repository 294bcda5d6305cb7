# SPDX-License-Identifier: GPL-3.0-or-later
# How every target of the project is compiled.

# What a program that includes our headers must share with the libraries: language, include path, and no contraction,
# so that laws in headers have the same bits there.
add_library(gyro_rules INTERFACE)
target_compile_features(gyro_rules INTERFACE cxx_std_20)
target_include_directories(gyro_rules INTERFACE
  $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/gyrosim>)
target_compile_options(gyro_rules INTERFACE $<$<COMPILE_LANGUAGE:CXX>:-ffp-contract=off>)

# What our own files are compiled with besides.
add_library(gyro_compile INTERFACE)
target_link_libraries(gyro_compile INTERFACE gyro_rules)
option(GYRO_WERROR "Warnings are errors" OFF)
target_compile_options(gyro_compile INTERFACE
  $<$<COMPILE_LANGUAGE:CXX>:-Wall -Wextra -Wpedantic -Wshadow>
  $<$<AND:$<BOOL:${GYRO_WERROR}>,$<COMPILE_LANGUAGE:CXX>>:-Werror>
  # Not asking for errno or traps changes no value and lets loops vectorise.
  $<$<COMPILE_LANGUAGE:CXX>:-fno-math-errno -fno-trapping-math>)
if(GYRO_NATIVE)
  # -Wno-psabi: packs of 16 floats are only passed inside inlined functions.
  set(native -march=native -mprefer-vector-width=512)
  # GCC copies structs of packs in halves of 16 bytes otherwise, and the processor waits when it reads them as one.
  include(CheckCXXCompilerFlag)
  check_cxx_compiler_flag(-mmove-max=512 GYRO_HAS_MOVE_MAX)
  if(GYRO_HAS_MOVE_MAX)
    list(APPEND native -mmove-max=512 -mstore-max=512)
  endif()
  # Not what is handed to other machines, a target with the property GYRO_PORTABLE.
  target_compile_options(gyro_compile INTERFACE
    "$<$<AND:$<COMPILE_LANGUAGE:CXX>,$<NOT:$<BOOL:$<TARGET_PROPERTY:GYRO_PORTABLE>>>>:${native}>")
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

# What clang's libFuzzer needs to see which code an input has reached.
option(GYRO_FUZZ "Build the targets of tests/fuzz for libFuzzer (with clang++)" OFF)
if(GYRO_FUZZ)
  target_compile_options(gyro_compile INTERFACE $<$<COMPILE_LANGUAGE:CXX>:-fsanitize=fuzzer-no-link>)
endif()

# Bounds of buffers and return addresses are checked at run time.
if(NOT GYRO_SANITIZE)  # which checks more
  target_compile_options(gyro_compile INTERFACE
    $<$<AND:$<COMPILE_LANGUAGE:CXX>,$<CONFIG:Release,RelWithDebInfo>>:-fstack-protector-strong -U_FORTIFY_SOURCE -D_FORTIFY_SOURCE=3>)
endif()
add_link_options(LINKER:-z,relro,-z,now)

# With GYRO_PRECOMPILE, GCC parses the headers of the standard library once for all targets; for most files of io and app
# that is a third of the compile time. The project's CI builds without it, so every file includes what it
# uses, and with GYRO_WERROR. Switch it off for a compiler cache: caches do not look into precompiled headers.
option(GYRO_PRECOMPILE "Parse the headers of the standard library once" ON)
if(GYRO_PRECOMPILE)
  add_library(gyro_precompiled OBJECT ${CMAKE_CURRENT_LIST_DIR}/precompiled.cpp)
  target_link_libraries(gyro_precompiled PRIVATE gyro_compile)
  target_precompile_headers(gyro_precompiled PRIVATE ${CMAKE_CURRENT_LIST_DIR}/precompiled.hpp)
  # GCC 12 then warns falsely inside std::string.
  target_compile_options(gyro_compile INTERFACE
    $<$<COMPILE_LANG_AND_ID:CXX,GNU>:-Wno-array-bounds -Wno-stringop-overflow -Wno-stringop-overread -Wno-restrict>)
endif()

# gyro_precompile(TARGET): uses the precompiled headers.
function(gyro_precompile target)
  if(GYRO_PRECOMPILE)
    target_precompile_headers(${target} REUSE_FROM gyro_precompiled)
  endif()
endfunction()

# gyro_library(NAME SOURCES ... [PUBLIC libs...] [PRIVATE libs...])
function(gyro_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;PUBLIC;PRIVATE" ${ARGN})
  add_library(${name} STATIC ${ARG_SOURCES})
  gyro_precompile(${name})
  target_link_libraries(${name} PUBLIC gyro_rules $<BUILD_INTERFACE:gyro_compile> ${ARG_PUBLIC} PRIVATE ${ARG_PRIVATE})
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
