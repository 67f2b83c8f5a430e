// SPDX-License-Identifier: Apache-2.0
// The compiler of the requirements register. `speccompiler --spec DIR --out DIR` checks the requirements register and
// writes the C++ tables. The build runs it.
#include <CLI/CLI.hpp>
#include <iostream>

#include "host/base/input_error.hpp"
#include "host/codegen/cpp_text.hpp"
#include "host/codegen/write_all.hpp"
#include "host/register/load.hpp"
#include "host/register/spec_files.hpp"

int main(int argc, char** argv) {
    using namespace canproof::host;
    CLI::App app{"Compiles the register in spec/ to C++ tables"};
    std::string spec;
    std::string out;
    app.add_option("--spec", spec, "folder of the register")->check(CLI::ExistingDirectory);
    app.add_option("--out", out, "folder to write to")->required();
    std::string package;
    app.add_option(
           "--package", package,
           "spec/ of canproof: its shared rules apply to a register without canopen/; without --spec, only they are "
           "compiled")
        ->check(CLI::ExistingDirectory);
    bool changeable = false;
    app.add_flag("--changeable", changeable,
                 "generate cells that a running program can alter, and the list of alterations");
    CLI11_PARSE(app, argc, argv);
    try {
        if (spec.empty() && package.empty()) {
            throw InputError{"name a register with --spec, or spec/ of canproof with --package"};
        }
        const SpecFiles shared = package.empty() ? SpecFiles{} : read_spec_files(package);
        const SpecFiles files = with_shared_rules(spec.empty() ? SpecFiles{} : read_spec_files(spec), shared);
        const LoadResult loaded = load_register(files);
        for (const auto& fault : loaded.faults) {
            std::cerr << fault.text() << '\n';
        }
        if (!loaded.faults.empty()) {
            std::cerr << loaded.faults.size() + loaded.faults.left_out()
                      << " fault(s) in the register; nothing written\n";
            return 1;
        }
        write_all(loaded.content, files, out, changeable ? Cells::changeable : Cells::constant);
    } catch (const std::exception& error) {
        std::cerr << "speccompiler: " << error.what() << '\n';
        return 2;
    }
    return 0;
}
