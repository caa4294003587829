# SPDX-License-Identifier: MIT
# Installs BUILD to a folder and moves that to PREFIX, so that no path of the first is left to be found.
cmake_path(GET PREFIX PARENT_PATH folder)
file(REMOVE_RECURSE ${PREFIX} ${folder}/first)
file(MAKE_DIRECTORY ${folder})
execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD} --prefix ${folder}/first --strip OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
file(RENAME ${folder}/first ${PREFIX})
