// SPDX-License-Identifier: Apache-2.0
#include "host/prove/replay.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <sstream>

#include "host/base/child_process.hpp"
#include "host/base/files.hpp"
#include "host/base/input_error.hpp"
#include "host/base/read_file.hpp"

namespace canproof::host::prove {

namespace {

const std::string reproduced = "reproduced: ";

/// Returns the line of the messages that describes the fault: the line of a sanitizer, or else the first line, which
/// properties/proofs/support/replay.cpp prints.
std::string complaint(const std::string& messages) {
    std::istringstream lines{messages};
    std::string first;
    for (std::string line; std::getline(lines, line);) {
        const bool says_why = line.find("runtime error:") != std::string::npos ||
                              line.find("ERROR: AddressSanitizer") != std::string::npos;
        if (says_why) {
            return line;
        }
        first = first.empty() ? line : first;
    }
    return first;
}

}  // namespace

void replay(Compiler& compiler, const std::filesystem::path& scratch, const SeedPlace& seeds, TheoremResult& result) {
    try {
        const std::string stem = (scratch / ("counterexample_" + result.name)).string();
        std::string text;
        for (const InputBytes& bytes : result.inputs) {
            text += fmt::format("{}\n", fmt::join(bytes, " "));
        }
        write_file(stem + ".txt", text);
        const std::string program = compiler.native(result.file, result.name).string();
        const std::string messages = stem + ".messages";
        std::vector<std::string> settings{"CANPROOF_COUNTEREXAMPLE=" + stem + ".txt", "ASAN_OPTIONS=detect_leaks=0"};
        if (!seeds.folder.empty()) {
            settings.push_back("CANPROOF_SEEDS=" + seeds.folder.string());
            settings.push_back("CANPROOF_SEED=" + (seeds.name.empty() ? "prove_" + result.name : seeds.name));
        }
        const pid_t process =
            start_process({"/bin/sh", "-c", "exec \"$0\" 2>'" + messages + "'", program}, settings, {});
        const int status = wait_for_process(process);
        const std::string why = complaint(read_file(messages));
        const bool fails = status != 0 && status != 11 && status != 12;
        result.replay = fails ? reproduced + why : fmt::format("not reproduced (exit status {}): {}", status, why);
    } catch (const InputError& error) {
        result.replay = std::string{"not replayed: "} + error.what();
    }
}

bool is_reproduced(const TheoremResult& result) {
    return result.replay.rfind(reproduced, 0) == 0;
}

}  // namespace canproof::host::prove
