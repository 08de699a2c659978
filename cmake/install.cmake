# `cmake --install` puts the program and what it needs below a prefix, and `scripts/package` makes a Debian package of the same.
include(GNUInstallDirs)
set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY ON)  # the program alone has to be built

install(TARGETS unbruised RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(DIRECTORY configs/ DESTINATION ${CMAKE_INSTALL_DATADIR}/unbruised/configs)
install(FILES packaging/unbruised.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(FILES packaging/unbruised.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME unbruised)
install(FILES packaging/_unbruised DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions)
install(FILES packaging/unbruised.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d)
install(FILES README.md CHANGELOG.md LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY docs DESTINATION ${CMAKE_INSTALL_DOCDIR})

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME unbruised)
set(CPACK_PACKAGE_CONTACT "Unbruised <unbruised@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "finds how a gripper may handle a delicate product")
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION
  "Simulates how a robot grips, lifts and puts down a product that must neither\n fall nor be marked, and finds the grip forces and strategies with which it\n does not. Compiled for ${UNBRUISED_ARCH}.")
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
include(CPack)
