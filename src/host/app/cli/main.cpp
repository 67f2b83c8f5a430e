#include <csignal>

#include "host/app/cli/command_line.hpp"

int main(int argc, char** argv) {
    std::signal(SIGXFSZ, SIG_IGN);  // a file that would become too long is a write that fails
    return canproof::host::run_command_line(argc, argv);
}
