# cmake -D IMAGE=tp100.elf -P budget.cmake: prints what an image takes of the ATmega2560 and fails
# above the budget.
set(MAX_FLASH 40960)
# The other half of the RAM is left to the stack.
set(MAX_RAM 4096)

if(NOT EXISTS ${IMAGE})
  message(FATAL_ERROR "${IMAGE}: no image; build the target tp100_image")
endif()
execute_process(COMMAND avr-size -A ${IMAGE} OUTPUT_VARIABLE sections COMMAND_ERROR_IS_FATAL ANY)

function(sum result)
  set(total 0)
  foreach(section ${ARGN})
    if(sections MATCHES "\n\\.${section} +([0-9]+)")
      math(EXPR total "${total} + ${CMAKE_MATCH_1}")
    endif()
  endforeach()
  set(${result} ${total} PARENT_SCOPE)
endfunction()

sum(flash text data)
sum(ram data bss noinit)
cmake_path(GET IMAGE FILENAME name)
message("${name}: flash ${flash} of ${MAX_FLASH} bytes, RAM ${ram} of ${MAX_RAM} bytes (static)")
if(flash GREATER MAX_FLASH OR ram GREATER MAX_RAM)
  # Otherwise the next build would treat the image as up to date.
  file(REMOVE ${IMAGE})
  message(FATAL_ERROR "${name} is above its budget: make it smaller or raise the budget in "
    "firmware/image/budget.cmake")
endif()
