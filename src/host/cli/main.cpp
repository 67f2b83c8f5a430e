#include "host/cli/commands.hpp"

int main(int argc, char** argv) {
    return canproof::host::run_command_line(argc, argv);
}
