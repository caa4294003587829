# SPDX-License-Identifier: MIT
# Writes what PROGRAM prints to OUT.
execute_process(COMMAND ${PROGRAM} OUTPUT_FILE ${OUT} COMMAND_ERROR_IS_FATAL ANY)
