# SPDX-License-Identifier: GPL-3.0-or-later
# The case file. yaml-cpp stays inside yaml_tree.cpp, nlohmann-json inside schema_json.cpp,
# libzip and pugixml inside fmu.
find_package(yaml-cpp 0.7 REQUIRED)
find_package(nlohmann_json 3.11 REQUIRED)
# Debian's configuration file of libzip asks for its tools, too; library and header are enough.
find_path(LIBZIP_INCLUDE_DIR zip.h REQUIRED)
find_library(LIBZIP_LIBRARY zip REQUIRED)
find_package(pugixml 1.12 REQUIRED)
if(NOT TARGET yaml-cpp::yaml-cpp)
  add_library(yaml-cpp::yaml-cpp ALIAS yaml-cpp)  # the name that yaml-cpp has from 0.8 on
endif()

gyro_library(gyro_case
  SOURCES case_build.cpp case_checks.cpp case_complete.cpp case_difference.cpp case_drivetrain.cpp case_fmu.cpp case_load.cpp
          fmu/archive.cpp fmu/connect.cpp fmu/export.cpp fmu/model_description.cpp fmu/model_description_write.cpp fmu/open.cpp
          case_start_state.cpp case_tables.cpp csv.cpp schema.cpp schema_describe.cpp schema_json.cpp schema_keys.cpp
          schema_read.cpp schema_values.cpp
          schema_write.cpp units.cpp yaml_tree.cpp
  PUBLIC gyro_mbd
  PRIVATE gyro_geometry yaml-cpp::yaml-cpp nlohmann_json::nlohmann_json ${LIBZIP_LIBRARY}
          pugixml::pugixml)
target_include_directories(gyro_case PRIVATE ${LIBZIP_INCLUDE_DIR})
# GCC 12 sees overlapping copies in `"text" + string` that are none (GCC bug 105651).
target_compile_options(gyro_case PUBLIC $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>)
