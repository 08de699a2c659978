# `cmake --install` puts the program and what it needs below a prefix, and `scripts/package` makes a Debian package of the same.
include(GNUInstallDirs)
set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY ON)  # the program alone has to be built

install(TARGETS unbruised RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
# All that goes into a package: optional parts where they are built.
add_custom_target(package_contents DEPENDS unbruised unbruised_core)
foreach(part unbruised_mpi unbruised_python)
  if(TARGET ${part})
    add_dependencies(package_contents ${part})
  endif()
endforeach()
if(UNBRUISED_PORTABLE)
  install(DIRECTORY ${UNBRUISED_LIBRARIES}/ DESTINATION lib/unbruised)
  set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${UNBRUISED_LIBRARIES})
endif()
if(TARGET unbruised_mpi)
  install(TARGETS unbruised_mpi LIBRARY DESTINATION lib/unbruised OPTIONAL)
endif()
install(DIRECTORY examples DESTINATION ${CMAKE_INSTALL_DOCDIR})
# The simulator as a library, with the headers that docs/install.md names and what they include; left out where it was not built.
include(CMakePackageConfigHelpers)
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/Unbruised)
configure_package_config_file(cmake/UnbruisedConfig.cmake.in ${PROJECT_BINARY_DIR}/UnbruisedConfig.cmake
  INSTALL_DESTINATION ${package_folder} PATH_VARS CMAKE_INSTALL_LIBDIR CMAKE_INSTALL_INCLUDEDIR)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/UnbruisedConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/UnbruisedConfig.cmake ${PROJECT_BINARY_DIR}/UnbruisedConfigVersion.cmake
  DESTINATION ${package_folder})
install(TARGETS unbruised_core ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} OPTIONAL)
set(api_headers
  core/contact/compliance_size.hpp
  core/contact/contact_event.hpp
  core/outcome/curve.hpp
  core/outcome/outcome.hpp
  core/outcome/replay.hpp
  core/outcome/trace.hpp
  core/scenario/cell_surface.hpp
  core/scenario/factor_key.hpp
  core/scenario/finger.hpp
  core/scenario/mesh_fault.hpp
  core/scenario/pad.hpp
  core/scenario/product_mesh.hpp
  core/scenario/product_parameters.hpp
  core/scenario/range_sensor.hpp
  core/scenario/robot.hpp
  core/scenario/rules.hpp
  core/scenario/scenario.hpp
  core/scenario/sensor.hpp
  core/scenario/smooth_mesh.hpp
  core/scenario/triangle_mesh.hpp
  core/scenario/triangle_tree.hpp
  core/simulation/simulation.hpp)
foreach(header ${api_headers})
  cmake_path(GET header PARENT_PATH folder)
  install(FILES ${header} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/unbruised/${folder})
endforeach()
install(DIRECTORY configs/ DESTINATION ${CMAKE_INSTALL_DATADIR}/unbruised/configs)
install(FILES packaging/unbruised.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(FILES packaging/unbruised.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME unbruised)
install(FILES packaging/_unbruised DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions)
install(FILES packaging/unbruised.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d)
install(FILES README.md CHANGELOG.md LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY docs DESTINATION ${CMAKE_INSTALL_DOCDIR})

if(UNBRUISED_PORTABLE)
  set(compiled_for "Needs an x86-64-v3 machine;\n takes AVX-512 where there is it.")
else()
  set(compiled_for "Compiled for ${UNBRUISED_ARCH}.")
endif()
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME unbruised)
set(CPACK_PACKAGE_CONTACT "Unbruised <unbruised@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "finds how a gripper may handle a delicate product")
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION
  "Simulates how a robot grips, lifts and puts down a product that must neither\n fall nor be marked, and finds the grip forces and strategies with which it\n does not. ${compiled_for}")
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "python3, python3-numpy, python3-xarray, python3-pandas, python3-h5py")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "openmpi-bin, slurm-client, libsuitesparse-dev, cmake, g++")
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
include(CPack)
