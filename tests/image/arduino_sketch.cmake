# cmake -D SKETCH=<tp100.ino> -D WORK=<folder> [-D FAKE_ROBOT=ON] -P arduino_sketch.cmake: compiles the sketch as the
# Arduino IDE does, with all warnings; FAKE_ROBOT: with its line in options.h uncommented. Fails if a source of the
# project causes a warning, if the image is above its budget, or if it is not the requested one.
set(ARDUINO /usr/share/arduino/hardware)
find_program(BUILDER arduino-builder)
if(NOT BUILDER)
  message(FATAL_ERROR "arduino-builder is missing; run scripts/setup")
endif()

# Start anew, because compiled files would not warn again.
file(REMOVE_RECURSE ${WORK}/build)
file(MAKE_DIRECTORY ${WORK}/build ${WORK}/cache)
if(FAKE_ROBOT)
  cmake_path(GET SKETCH PARENT_PATH original)
  file(REMOVE_RECURSE ${WORK}/tp100)
  file(COPY ${original} DESTINATION ${WORK})
  set(SKETCH ${WORK}/tp100/tp100.ino)
  file(READ ${WORK}/tp100/options.h options)
  string(REPLACE "\n// #define FAKE_ROBOT\n" "\n#define FAKE_ROBOT\n" fake "${options}")
  if(fake STREQUAL options)
    message(FATAL_ERROR "${original}/options.h has no line to uncomment")
  endif()
  file(WRITE ${WORK}/tp100/options.h "${fake}")
endif()
cmake_path(GET BUILDER PARENT_PATH bin)
execute_process(
  COMMAND ${BUILDER} -compile -warnings all -ide-version 10819 -fqbn arduino:avr:mega:cpu=atmega2560
    # The second folder has the patterns of ctags.
    -hardware ${ARDUINO} -hardware /usr/share/arduino-builder -tools ${bin}
    -prefs compiler.cpp.extra_flags=-DDECIMAL_DIG=__DECIMAL_DIG__
    -build-path ${WORK}/build -build-cache ${WORK}/cache ${SKETCH}
  RESULT_VARIABLE status OUTPUT_VARIABLE text ERROR_VARIABLE text)
if(status)
  message(FATAL_ERROR "${text}\narduino-builder ended with ${status}")
endif()

# Sources are compiled as copies in <build>/sketch, the .ino under its own name.
cmake_path(GET SKETCH PARENT_PATH folder)
string(REPLACE ";" "," text "${text}")
string(REPLACE "\n" ";" lines "${text}")
foreach(line IN LISTS lines)
  string(FIND "${line}" "${WORK}/build/sketch/" copied)
  string(FIND "${line}" "${folder}/" own)
  if(line MATCHES "warning:" AND (copied EQUAL 0 OR own EQUAL 0))
    message(SEND_ERROR "${line}")
  endif()
endforeach()

set(IMAGE ${WORK}/build/tp100.ino.elf)
execute_process(COMMAND avr-nm -C ${IMAGE} OUTPUT_VARIABLE symbols COMMAND_ERROR_IS_FATAL ANY)
if(NOT FAKE_ROBOT STREQUAL "ON" AND symbols MATCHES "FakeMegaHal")
  message(FATAL_ERROR "${IMAGE} simulates its robot")
elseif(FAKE_ROBOT AND NOT symbols MATCHES "FakeMegaHal")
  message(FATAL_ERROR "${IMAGE} does not simulate its robot")
endif()
include(${CMAKE_CURRENT_LIST_DIR}/../../firmware/image/budget.cmake)
