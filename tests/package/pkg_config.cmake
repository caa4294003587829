# SPDX-License-Identifier: MIT
# Plain gcc and pkg-config, as a host with makefiles has them: shared and static, with and without formats and picking.
set(ENV{PKG_CONFIG_PATH} ${PREFIX}/${LIBDIR}/pkgconfig)
set(ENV{LD_LIBRARY_PATH} ${PREFIX}/${LIBDIR})
file(REMOVE_RECURSE ${FOLDER})
file(MAKE_DIRECTORY ${FOLDER})

function(build_and_run name sources packages)
    execute_process(COMMAND ${PKG_CONFIG} --cflags --libs ${ARGN} ${packages} OUTPUT_VARIABLE flags
        OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
    if(ARGN MATCHES "static")
        # Beside a shared library, the linker takes that: the static one is asked for by its file.
        string(REGEX REPLACE "-l(filigree[a-z_]*)" "-l:lib\\1.a" flags "${flags}")
    endif()
    separate_arguments(flags UNIX_COMMAND "${flags}")
    execute_process(COMMAND ${CC} -std=c11 -Wall -Wextra -Werror ${sources} -o ${FOLDER}/${name} ${flags} COMMAND_ERROR_IS_FATAL ANY)
    execute_process(COMMAND ${FOLDER}/${name} WORKING_DIRECTORY ${FOLDER} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

build_and_run(core ${SOURCE}/core.c filigree)
build_and_run(core_static ${SOURCE}/core.c filigree --static)
if(WITH_IO)
    build_and_run(formats ${SOURCE}/formats.c filigree_io)
    build_and_run(formats_static ${SOURCE}/formats.c filigree_io --static)
endif()
if(WITH_PICK)
    build_and_run(picking ${SOURCE}/picking.c filigree_pick)
    build_and_run(picking_static ${SOURCE}/picking.c filigree_pick --static)
endif()
