# What `cmake --install` puts where, and the Debian package made of it. The program
# finds its cases, its documentation and the finite-element module relative to itself
# (run/arguments/case_library.cpp, fem/plugin_loader.cpp), so that any prefix works.
include(GNUInstallDirs)
set(ASPERITY_LIBRARY_FOLDER lib/asperity) # the same on every system

set_target_properties(asperity PROPERTIES INSTALL_RPATH "$ORIGIN/../${ASPERITY_LIBRARY_FOLDER}")
set_target_properties(asperity_fem_module asperity_base PROPERTIES INSTALL_RPATH "$ORIGIN")
install(TARGETS asperity RUNTIME DESTINATION bin)
install(TARGETS asperity_fem_module LIBRARY DESTINATION ${ASPERITY_LIBRARY_FOLDER})
install(TARGETS asperity_base LIBRARY DESTINATION ${ASPERITY_LIBRARY_FOLDER})

install(DIRECTORY cases/ DESTINATION share/asperity/cases)
install(DIRECTORY python/adapters DESTINATION share/asperity
  PATTERN "__pycache__" EXCLUDE PATTERN "CMakeLists.txt" EXCLUDE)
install(DIRECTORY docs/ DESTINATION share/doc/asperity)
install(FILES README.md CHANGELOG.md CITATION.cff DESTINATION share/doc/asperity)
install(FILES LICENSE DESTINATION share/doc/asperity RENAME copyright)
install(FILES python/asperity.py DESTINATION lib/python3/dist-packages)

# Manual pages and completions come from the command line of the program itself.
set(generated ${PROJECT_BINARY_DIR}/generated/share)
add_custom_command(OUTPUT ${generated}/man/asperity.1 DEPENDS asperity
  COMMAND ${CMAKE_COMMAND} -E make_directory ${generated}/man
  COMMAND asperity man --out ${generated}/man
  COMMAND asperity completion bash > ${generated}/asperity.bash
  COMMAND asperity completion zsh > ${generated}/_asperity
  COMMAND asperity completion fish > ${generated}/asperity.fish VERBATIM)
add_custom_target(asperity_manual ALL DEPENDS ${generated}/man/asperity.1)
install(DIRECTORY ${generated}/man/ DESTINATION share/man/man1 FILES_MATCHING PATTERN "*.1")
install(FILES ${generated}/asperity.bash DESTINATION share/bash-completion/completions
  RENAME asperity)
install(FILES ${generated}/_asperity DESTINATION share/zsh/vendor-completions)
install(FILES ${generated}/asperity.fish DESTINATION share/fish/vendor_completions.d)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME asperity)
set(CPACK_PACKAGE_VENDOR "Asperity")
set(CPACK_PACKAGE_CONTACT "The Asperity developers <asperity@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY ${PROJECT_DESCRIPTION})
set(CPACK_PACKAGE_DESCRIPTION "Asperity presses an elastic block on a rough rigid surface.
From one case file it computes the contact by finite elements, by an
atomistic model, by a continuum half-space and by Persson's theory, and
writes a report that compares them.")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${PROJECT_BINARY_DIR}/base)
set(CPACK_DEBIAN_PACKAGE_DEPENDS "gnuplot-nox | gnuplot")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "libopenblas0-serial") # the direct solver of full blocks
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "lammps, python3-h5py, python3-matplotlib, python3-numpy")
include(CPack)
