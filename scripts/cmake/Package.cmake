# The Debian packages: `cpack` in the build folder, or scripts/package. tp100-camera is a package of its own, so that a
# robot's host does not need OpenCV. Man pages are generated from the programs' --help.
if(TP100_SANITIZE OR TP100_FUZZ OR NOT TP100_BUILD_FIRMWARE)
  return()
endif()

# A component is a binary package; files installed below belong to tp100 unless stated otherwise.
set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME tp100)
set(programs tp100d tp100-sim)
if(TARGET tp100-camera)
  list(APPEND programs tp100-camera)
endif()

set(manual ${CMAKE_BINARY_DIR}/manual)
# Folder from which programs can be run here: emulated when cross-compiling.
set(runnable ${CMAKE_RUNTIME_OUTPUT_DIRECTORY})
if(CMAKE_CROSSCOMPILING)
  set(runnable ${CMAKE_BINARY_DIR}/emulated)
  list(JOIN CMAKE_CROSSCOMPILING_EMULATOR "' '" emulator)
  foreach(program tp100d tp100-sim tp100-camera)
    file(WRITE ${runnable}/${program}
      "#!/bin/sh\nexec '${emulator}' '${CMAKE_RUNTIME_OUTPUT_DIRECTORY}/${program}' \"$@\"\n")
    file(CHMOD ${runnable}/${program} PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE
      WORLD_READ WORLD_EXECUTE)
  endforeach()
endif()
# Scripts that are installed as tp100-NAME.
foreach(name flash campaign)
  configure_file(scripts/${name} ${manual}/bin/tp100-${name} COPYONLY)
endforeach()
find_program(PYTHON3 python3 REQUIRED)
set(written)
foreach(program IN LISTS programs ITEMS tp100-flash tp100-campaign)
  set(component tp100)
  if(program STREQUAL tp100-camera)
    set(component camera)
  endif()
  set(path ${runnable}/${program})
  set(on ${program})
  if(NOT TARGET ${program})
    set(path ${manual}/bin/${program})
    string(REPLACE tp100- scripts/ on ${program})
  endif()
  add_custom_command(OUTPUT ${manual}/${program}.1.gz
    COMMAND ${PYTHON3} -B ${CMAKE_SOURCE_DIR}/scripts/manual.py ${path} ${PROJECT_VERSION} ${manual}
    DEPENDS ${on} scripts/manual.py VERBATIM)
  list(APPEND written ${manual}/${program}.1.gz)
  install(FILES ${manual}/${program}.1.gz DESTINATION share/man/man1 COMPONENT ${component})
  install(FILES scripts/completion.bash DESTINATION share/bash-completion/completions RENAME ${program}
    COMPONENT ${component})
endforeach()
add_custom_target(tp100_manual ALL DEPENDS ${written})

install(TARGETS tp100d tp100-sim DESTINATION bin)
install(PROGRAMS ${manual}/bin/tp100-flash ${manual}/bin/tp100-campaign DESTINATION bin)
install(FILES ${CMAKE_BINARY_DIR}/firmware/tp100.hex ${CMAKE_BINARY_DIR}/firmware/tp100_fake.hex
  DESTINATION share/tp100)
install(DIRECTORY config/campaigns config/courses config/robots config/cameras DESTINATION share/tp100)
install(FILES config/tp100.toml config/lichtblick.json DESTINATION share/tp100)
install(FILES config/systemd/tp100d@.service DESTINATION lib/systemd/system)
install(FILES config/systemd/tp100.conf DESTINATION lib/sysusers.d)
install(FILES config/udev/65-tp100.rules DESTINATION lib/udev/rules.d)
install(FILES config/udev/64-tp100-bridges.rules scripts/tp100_client.py DESTINATION share/doc/tp100/examples)
install(FILES config/tp100.toml DESTINATION /etc/tp100)

set(debian ${CMAKE_SOURCE_DIR}/scripts/debian)
set(documents ${CMAKE_BINARY_DIR}/debian)
file(MAKE_DIRECTORY ${documents})
file(WRITE ${documents}/conffiles "/etc/tp100/tp100.toml\n")
execute_process(COMMAND gzip -9nc INPUT_FILE ${debian}/changelog OUTPUT_FILE ${documents}/changelog.gz
  COMMAND_ERROR_IS_FATAL ANY)
install(FILES ${debian}/copyright ${documents}/changelog.gz DESTINATION share/doc/tp100)
# In the folders of the source tree, because they link to each other.
file(GLOB pages RELATIVE ${CMAKE_SOURCE_DIR} README.md config/*.md daemon/*.md daemon/*/*.md firmware/*.md sim/*.md
  sim/*/*.md tests/PROOF.md tests/data/real/README.md)
foreach(page IN LISTS pages)
  cmake_path(GET page PARENT_PATH folder)
  install(FILES ${page} DESTINATION share/doc/tp100/${folder})
endforeach()
install(FILES daemon/web/cockpit.png daemon/web/plan.png daemon/web/analyse.png DESTINATION share/doc/tp100/daemon/web)
install(FILES daemon/web/dist/licences.txt DESTINATION share/doc/tp100 RENAME page-licences.txt)
if(TARGET tp100-camera)
  install(TARGETS tp100-camera DESTINATION bin COMPONENT camera)
  # CAMERA.md in both packages: a host with tp100-camera does not need tp100.
  install(FILES ${debian}/copyright ${documents}/changelog.gz daemon/camera/CAMERA.md
    DESTINATION share/doc/tp100-camera COMPONENT camera)
  install(FILES config/view.toml DESTINATION share/tp100 COMPONENT camera)
endif()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME tp100)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_CONTACT "TP100 maintainers <maintainers@tp100.invalid>")
set(CPACK_PACKAGE_DIRECTORY ${CMAKE_BINARY_DIR}/package)
set(CPACK_STRIP_FILES ON)
# Needed because /etc is not below the prefix.
set(CPACK_SET_DESTDIR ON)
set(CPACK_INSTALL_PREFIX /usr)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_SECTION electronics)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
if(CMAKE_CROSSCOMPILING)
  set(CPACK_DEBIAN_PACKAGE_ARCHITECTURE ${TP100_DEBIAN_ARCHITECTURE})
  set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${CMAKE_SYSROOT}/lib/${CMAKE_LIBRARY_ARCHITECTURE}
    ${CMAKE_SYSROOT}/usr/lib/${CMAKE_LIBRARY_ARCHITECTURE})
endif()
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
# The first line of each description is its summary.
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL tp100)

set(CPACK_DEBIAN_TP100_PACKAGE_NAME tp100)
# The maintainer scripts use systemd-sysusers, udevadm and userdel.
set(CPACK_DEBIAN_TP100_PACKAGE_DEPENDS "systemd | systemd-standalone-sysusers | systemd-sysusers, passwd")
# tp100-campaign uses GNU parallel.
set(CPACK_DEBIAN_TP100_PACKAGE_RECOMMENDS "avrdude, parallel, udev")
set(CPACK_DEBIAN_TP100_PACKAGE_SUGGESTS "arduino-core-avr, tp100-camera")
set(CPACK_DEBIAN_TP100_PACKAGE_CONTROL_EXTRA
  ${documents}/conffiles ${debian}/postinst ${debian}/prerm ${debian}/postrm)
set(CPACK_DEBIAN_TP100_DESCRIPTION
"real-time bridge and emulator for the TP100 crawler
tp100d reads encoder and IMU frames from an Arduino Mega over USB serial at up
to 1 kHz, integrates a slip-compensated skid-steer model and returns the pose
and a trajectory controller's yaw command. It shows a page, records MCAP files
and runs as a service, one instance for each robot.

tp100-sim is an emulated robot: the same firmware on a rigid body with tracks,
over a wire with real byte times. tp100-campaign drives it thousands of times,
by GNU parallel or on a Slurm cluster. tp100-flash writes the firmware that
comes with the package to a Mega; for that it needs avrdude.")

if(TARGET tp100-camera)
  list(APPEND CPACK_COMPONENTS_ALL camera)
  set(CPACK_DEBIAN_CAMERA_PACKAGE_NAME tp100-camera)
  set(CPACK_DEBIAN_CAMERA_PACKAGE_SUGGESTS tp100)
  set(CPACK_DEBIAN_CAMERA_DESCRIPTION
"overhead camera for the TP100 crawler
tp100-camera finds a printed marker on the robot in the images of a camera, a
video or a folder and sends its pose on the floor to tp100d, on this machine or
another, as UDP datagrams; or it writes them as a TUM file. It calibrates the
lens and prints the markers.")
endif()
include(CPack)
