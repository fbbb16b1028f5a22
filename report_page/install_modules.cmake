# npm ci in the working directory: cmake -DNPM=... -DFROM=<folder of package.json> -DSTAMP=... -P install_modules.cmake
file(COPY ${FROM}/package.json ${FROM}/package-lock.json DESTINATION .)
# No script of a package runs: none is needed, and what is installed is what the lock file's hashes say.
execute_process(COMMAND ${NPM} ci --ignore-scripts --prefer-offline --no-audit --no-fund --loglevel=error
  RESULT_VARIABLE result ERROR_VARIABLE complaint OUTPUT_QUIET)
if(result)
  message(FATAL_ERROR "npm could not install what report_page/package-lock.json lists:\n${complaint}\n"
    "It needs a package registry: check the network and `npm ping`, then build again. To build without the page of "
    "`reliefbench report`: cmake -DRELIEFBENCH_REPORT_PAGE=OFF ...")
endif()
file(TOUCH ${STAMP})
