// SPDX-License-Identifier: Apache-2.0
#include "host/app/cli/prove_command.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>

#include "host/base/child_process.hpp"
#include "host/base/input_error.hpp"

namespace canproof::host {

int prove(const std::vector<std::string>& words) {
    const auto own = std::filesystem::read_symlink("/proc/self/exe").parent_path();
    const std::string program = own / "canproof-prove";
    if (!std::filesystem::exists(program)) {
        throw InputError{
            fmt::format("there is no {}; build the target canproof-prove, or use a build that has it", program)};
    }
    std::vector<std::string> command{program};
    command.insert(command.end(), words.begin(), words.end());
    return wait_for_process(start_process(command, {}, {-1, STDOUT_FILENO}));
}

}  // namespace canproof::host
