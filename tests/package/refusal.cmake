# SPDX-License-Identifier: MIT
# What does not fit is refused while configuring, in words: another minor version, a component that isn't there.
function(refused message)
    file(REMOVE_RECURSE ${FOLDER})
    execute_process(COMMAND ${CMAKE_COMMAND} -S ${SOURCE} -B ${FOLDER} -DCMAKE_PREFIX_PATH=${PREFIX} ${ARGN}
        RESULT_VARIABLE result OUTPUT_QUIET ERROR_VARIABLE errors)
    if(result EQUAL 0 OR NOT errors MATCHES "${message}")
        message(FATAL_ERROR "${ARGN}: configured with ${result}: ${errors}")
    endif()
endfunction()

refused("compatible with requested[ \n]+version \"0\\.0\\.1\"" -DWANTED_VERSION=0.0.1)
refused("compatible with requested[ \n]+version \"1\\.0\"" -DWANTED_VERSION=1.0)
refused("has no component 'embroidery'" -DMORE_COMPONENTS=embroidery)
