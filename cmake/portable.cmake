# One package for all x86-64-v3 machines. The program and Python's module are small, compiled for any x86-64; what they do is in
# shared libraries of one name, compiled for an instruction set each, in glibc-hwcaps/ where the dynamic loader takes the best
# that the machine has. Above them is, for machines that have neither, a library that says so.
if(NOT UNBRUISED_ARCH MATCHES "^x86-64-v[34]$")
  message(FATAL_ERROR "UNBRUISED_ARCH = ${UNBRUISED_ARCH}: a portable build is for x86-64-v3 or x86-64-v4")
endif()
set(UNBRUISED_LIBRARIES ${PROJECT_BINARY_DIR}/lib/unbruised CACHE PATH "where a portable build puts its shared libraries")
add_custom_target(unbruised_kernels)

# unbruised_chosen_library(TARGET NAME ENTRY FALLBACK_SOURCE): makes TARGET libNAME.so of this instruction set, of which nothing
# but ENTRY is seen, and TARGET_fallback the one for machines without; against that one programs are linked.
function(unbruised_chosen_library target name entry fallback_source)
  set(seen ${CMAKE_CURRENT_BINARY_DIR}/${target}.map)
  file(CONFIGURE OUTPUT ${seen} CONTENT "{ global: ${entry}; local: *; };\n")
  add_library(${target}_fallback SHARED ${fallback_source})
  set_target_properties(${target} PROPERTIES
    LIBRARY_OUTPUT_DIRECTORY ${UNBRUISED_LIBRARIES}/glibc-hwcaps/${UNBRUISED_ARCH} LINK_DEPENDS ${seen})
  set_target_properties(${target}_fallback PROPERTIES LIBRARY_OUTPUT_DIRECTORY ${UNBRUISED_LIBRARIES})
  set_target_properties(${target} ${target}_fallback PROPERTIES OUTPUT_NAME ${name} PREFIX lib SUFFIX .so)
  target_link_options(${target} PRIVATE -Wl,--version-script=${seen})
  target_link_options(${target}_fallback PRIVATE -Wl,--no-as-needed)
  add_dependencies(unbruised_kernels ${target})
endfunction()

# The small part: finds the libraries below its own folder, as it is built and as it is installed.
function(unbruised_starts target chosen_library folder_when_installed)
  target_link_libraries(${target} PRIVATE ${chosen_library}_fallback)
  target_link_options(${target} PRIVATE -Wl,--no-as-needed)
  set_target_properties(${target} PROPERTIES BUILD_RPATH_USE_ORIGIN ON INSTALL_RPATH "\$ORIGIN/${folder_when_installed}")
  add_dependencies(${target} ${chosen_library})
endfunction()
