# SPDX-License-Identifier: GPL-3.0-or-later
# The output directory of a run. HDF5, VTK, JSON and spdlog stay inside this target.
enable_language(C)  # find_package(HDF5) compiles a trial program in C
find_package(HDF5 REQUIRED COMPONENTS C)
if(HDF5_IS_PARALLEL)
  message(FATAL_ERROR "the serial HDF5 is needed, a parallel one was found; install libhdf5-dev or set HDF5_ROOT")
endif()
find_package(VTK 9.1 REQUIRED COMPONENTS CommonCore CommonDataModel IOXML)
find_package(nlohmann_json 3.11 REQUIRED)
find_package(spdlog 1.10 REQUIRED)
# Who links gyro_output links these too, in whatever folder.
foreach(library HDF5::HDF5 VTK::CommonCore VTK::CommonDataModel VTK::IOXML nlohmann_json::nlohmann_json spdlog::spdlog)
  set_target_properties(${library} PROPERTIES IMPORTED_GLOBAL TRUE)
endforeach()

gyro_library(gyro_output
  SOURCES hdf5.cpp hdf5_dataset.cpp hdf5_internal.cpp library_file.cpp log.cpp progress.cpp replace_file.cpp results.cpp
          run_directory.cpp snapshots.cpp state_file.cpp summary.cpp summary_text.cpp
  PRIVATE HDF5::HDF5 VTK::CommonCore VTK::CommonDataModel VTK::IOXML nlohmann_json::nlohmann_json spdlog::spdlog)
