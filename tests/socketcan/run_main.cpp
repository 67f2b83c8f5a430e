// SPDX-License-Identifier: Apache-2.0
// canproof_run is a program with only the command `run` of canproof. tests/socketcan uses it for the builds with
// sanitizers, which then compile only the files of this command.
#include <CLI/CLI.hpp>
#include <csignal>
#include <exception>
#include <iostream>

#include "host/app/cli/run_arguments.hpp"
#include "host/base/standard_streams.hpp"

namespace {

constexpr int wrong_use = 2;

int run(int argc, char** argv) {
    CLI::App app{"canproof_run: devices in real time on a bus"};
    app.require_subcommand(1);
    canproof::host::RunOptions options;
    canproof::host::add_run_options(*app.add_subcommand("run", "as canproof run"), options);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : wrong_use;
    }
    const int status = canproof::host::run_devices(options);
    canproof::host::finish_standard_output();
    return status;
}

}  // namespace

int main(int argc, char** argv) {
    std::signal(SIGXFSZ, SIG_IGN);
    canproof::host::keep_standard_descriptors();
    try {
        return run(argc, argv);
    } catch (const std::exception& error) {
        std::cerr << "canproof_run: " << error.what() << '\n';
        return wrong_use;
    }
}
