// The program's command line.
#pragma once

namespace canproof::host {

/// Does what the words say. Exit status 0 done, 1 the thing checked does not hold, 2 wrong use or
/// unreadable input.
int run_command_line(int argc, char** argv);

}  // namespace canproof::host
