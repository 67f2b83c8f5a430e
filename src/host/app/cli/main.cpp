// SPDX-License-Identifier: Apache-2.0
#include <csignal>

#include "host/app/cli/command_line.hpp"

int main(int argc, char** argv) {
    std::signal(SIGXFSZ, SIG_IGN);  // a write beyond the file size limit fails instead of ending the program
    return canproof::host::run_command_line(argc, argv);
}
