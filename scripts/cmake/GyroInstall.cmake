# SPDX-License-Identifier: GPL-3.0-or-later
# What `cmake --install` puts in place, and the CMake package `gyrosim`.
#
#   find_package(gyrosim REQUIRED)                        # gyrosim::engine: scenes of particles, walls and bonds
#   find_package(gyrosim REQUIRED COMPONENTS drivetrain)  # and gyrosim::drivetrain: motor, gear and eccentric
#   find_package(gyrosim REQUIRED COMPONENTS simulation)  # and gyrosim::simulation: the coupled run, feed and product
include(CMakePackageConfigHelpers)

# Headers keep their paths, so that a program includes "core/scene/scene.hpp" as the sources do. `core` and `app` are
# names that others use as well: the headers are therefore in a folder of their own, include/gyrosim, which only who
# links a gyrosim target has on its include path.
set(headers ${CMAKE_INSTALL_INCLUDEDIR}/gyrosim)
set(package ${CMAKE_INSTALL_LIBDIR}/cmake/gyrosim)
set(data ${CMAKE_INSTALL_DATADIR}/gyrosim)

# gyro_export(COMPONENT target...): installs libraries as a component of the package; gyro_engine is gyrosim::engine.
function(gyro_export component)
  foreach(target IN LISTS ARGN)
    string(REGEX REPLACE "^gyro_" "" name ${target})
    string(REPLACE "mbd" "drivetrain" name ${name})
    set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
  endforeach()
  install(TARGETS ${ARGN} EXPORT gyrosim-${component} ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}/gyrosim)
  install(EXPORT gyrosim-${component} NAMESPACE gyrosim:: DESTINATION ${package})
endfunction()

set(engine gyro_rules gyro_scene gyro_surfaces gyro_engine)
if(GYRO_WITH_CUDA)
  list(APPEND engine gyro_gpu)
  install(DIRECTORY gpu DESTINATION ${headers} FILES_MATCHING PATTERN "*.hpp")
endif()
gyro_export(engine ${engine})
gyro_export(drivetrain gyro_mbd)
gyro_export(simulation gyro_walls gyro_geometry gyro_rocks gyro_fragments gyro_feed gyro_simulation)
install(DIRECTORY core mbd DESTINATION ${headers} FILES_MATCHING PATTERN "*.hpp")
install(DIRECTORY app/simulation DESTINATION ${headers}/app FILES_MATCHING PATTERN "*.hpp")

configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/gyrosimConfig.cmake.in
  ${PROJECT_BINARY_DIR}/gyrosimConfig.cmake INSTALL_DESTINATION ${package})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/gyrosimConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/gyrosimConfig.cmake ${PROJECT_BINARY_DIR}/gyrosimConfigVersion.cmake
  DESTINATION ${package})

# The program: what is split for the sake of a short first build is one again.
install(PROGRAMS $<TARGET_FILE:gyrosim-complete> DESTINATION ${CMAKE_INSTALL_BINDIR} RENAME gyrosim)
install(TARGETS gyro_drivetrain_fmu LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/gyrosim)
install(DIRECTORY cases DESTINATION ${data})
install(PROGRAMS scripts/plot.py scripts/render.py scripts/laboratory.py scripts/paper_library.py DESTINATION ${data}/scripts)
install(FILES scripts/errors.py DESTINATION ${data}/scripts)
install(DIRECTORY scripts/plotting scripts/rendering DESTINATION ${data}/scripts FILES_MATCHING PATTERN "*.py")
install(FILES README.md CHANGELOG.md LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(FILES ${PROJECT_BINARY_DIR}/pages/gyrosim.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(FILES ${PROJECT_BINARY_DIR}/pages/bash/gyrosim DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
install(FILES ${PROJECT_BINARY_DIR}/pages/zsh/_gyrosim DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/site-functions)
