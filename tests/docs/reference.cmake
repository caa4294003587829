# SPDX-License-Identifier: MIT
# Runs Doxygen over sdk/docs/Doxyfile, into OUT/reference. From the root of the sources.
file(READ sdk/docs/Doxyfile settings)
file(MAKE_DIRECTORY ${OUT})
file(WRITE ${OUT}/Doxyfile "${settings}\nOUTPUT_DIRECTORY = ${OUT}\n")
execute_process(COMMAND ${DOXYGEN} ${OUT}/Doxyfile RESULT_VARIABLE status)
if(NOT status EQUAL 0)
    message(FATAL_ERROR "doxygen warned of what is above")
endif()
