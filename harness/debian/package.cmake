# cmake --build build --target package: raygrade_<version>_<architecture>.deb
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME raygrade)
set(CPACK_PACKAGE_CONTACT "raygrade maintainers <maintainers@raygrade.example>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "grader for a ray-casting assignment")
set(CPACK_PACKAGE_DESCRIPTION "Compiles and runs each student's program in a sandbox, reads what it prints,
and gives points for each answer, with feedback.")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION education)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# Every submission is compiled, with GLM, and run in bubblewrap: without one of them nothing is graded.
set(CPACK_DEBIAN_PACKAGE_DEPENDS "g++, libglm-dev, bubblewrap")
# Folders 0755, whatever the umask of whoever builds the package.
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
install(FILES harness/debian/copyright DESTINATION share/doc/raygrade)
# -n: no time in it, so that the same sources give the same file.
add_custom_command(OUTPUT ${CMAKE_BINARY_DIR}/changelog.gz
  COMMAND gzip -9nc ${CMAKE_SOURCE_DIR}/harness/debian/changelog > ${CMAKE_BINARY_DIR}/changelog.gz
  DEPENDS ${CMAKE_SOURCE_DIR}/harness/debian/changelog)
add_custom_target(changelog ALL DEPENDS ${CMAKE_BINARY_DIR}/changelog.gz)
install(FILES ${CMAKE_BINARY_DIR}/changelog.gz DESTINATION share/doc/raygrade)
install(FILES harness/debian/lintian-overrides DESTINATION share/lintian/overrides RENAME raygrade)
include(CPack)
