// SPDX-License-Identifier: Apache-2.0
#include "host/prove/compile.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <sstream>

#include "host/base/child_process.hpp"
#include "host/base/files.hpp"
#include "host/base/input_error.hpp"
#include "host/base/read_file.hpp"

namespace canproof::host::prove {

namespace {

const char* const clang = "clang++-19";

/// The compiler turns undefined behaviour into a trap, and the prover shows that no trap is reached. The compiler's
/// checks for null pointers, alignment, object sizes and address arithmetic are switched off, because the prover's own
/// model of memory checks them. -fno-access-control lets a harness use private members.
const std::vector<std::string> bitcode_flags = {
    "-std=c++17",
    "-O1",
    "-fno-access-control",
    "-Xclang",
    "-disable-llvm-passes",
    "-gline-tables-only",
    "-fno-discard-value-names",  // the invariant of a loop names local variables
    "-fno-exceptions",
    "-fno-rtti",
    "-ffp-contract=off",  // no fused multiply-add, as in the shipped program (g++ -std=c++17)
    "-fsanitize=undefined,float-divide-by-zero",
    "-fstrict-flex-arrays=3",  // an array at the end of a struct is not longer than its type says
    "-fno-sanitize=null,alignment,object-size,pointer-overflow,vptr,function,bool,enum,float-divide-by-zero",
    "-fsanitize-trap=all",
    "-emit-llvm",
    "-c"};

const std::vector<std::string> native_flags = {"-std=c++17",
                                               "-O1",
                                               "-fno-access-control",
                                               "-gline-tables-only",
                                               "-fno-exceptions",
                                               "-fno-rtti",
                                               "-ffp-contract=off",
                                               "-fsanitize=address,undefined",
                                               "-fstrict-flex-arrays=3",
                                               "-fno-sanitize=vptr",
                                               "-fno-sanitize-recover=all"};

/// Starts the compiler, which writes its messages to the file `messages`.
pid_t start_clang(std::vector<std::string> words, const std::string& messages) {
    words.insert(words.end(), {"-fdiagnostics-color=never", "-Wno-everything"});
    std::vector<std::string> shell{"/bin/sh", "-c", "exec \"$0\" \"$@\" 2>'" + messages + "'"};
    shell.insert(shell.end(), words.begin(), words.end());
    return start_process(shell, {}, {});
}

void wait_for_clang(pid_t process, const std::string& what, const std::string& messages) {
    if (wait_for_process(process) != 0) {
        throw InputError{fmt::format("{} does not compile {}:\n{}", clang, what, read_file(messages))};
    }
}

/// Returns the file that defines the invariant of the class in a header, if the class has one. For
/// `src/firmware/canopen/sdo_server.hpp` it is `properties/invariants/sdo_server.cpp`, and for
/// `src/devices/ax130751/firmware/relay.hpp` it is `properties/invariants/ax130751/relay.cpp`.
std::filesystem::path invariant_of(const std::filesystem::path& header) {
    std::filesystem::path folder = "properties/invariants";
    if (header.string().rfind("src/devices/", 0) == 0) {
        folder /= header.parent_path().parent_path().filename();
    }
    return folder / header.filename().replace_extension(".cpp");
}

/// Returns the sources that define what a header of the firmware declares. For `…/src/firmware/canopen/sdo_server.hpp`,
/// these are `src/firmware/canopen/sdo_server.cpp`, the sources whose names begin with `sdo_server_` and that have no
/// header, such as `sdo_server_block.cpp`, and the invariant of the class. Returns none for any other header.
std::vector<std::filesystem::path> sources_of_header(const std::string& header) {
    std::vector<std::filesystem::path> all;
    for (const std::string folder : {"src/firmware/", "src/devices/"}) {
        const std::size_t at = header.rfind(folder);
        if (at == std::string::npos || std::filesystem::path{header}.extension() != ".hpp") {
            continue;
        }
        const std::filesystem::path own = std::filesystem::path{header.substr(at)};
        for (const auto& one : std::filesystem::directory_iterator(own.parent_path())) {
            const std::filesystem::path source = own.parent_path() / one.path().filename();
            const bool belongs = source.stem() == own.stem() ||
                                 (source.stem().string().rfind(own.stem().string() + "_", 0) == 0 &&
                                  !std::filesystem::exists(std::filesystem::path{source}.replace_extension(".hpp")));
            if (source.extension() == ".cpp" && belongs) {
                all.push_back(source);
            }
        }
        if (const auto invariant = invariant_of(own); std::filesystem::exists(invariant)) {
            all.push_back(invariant);
        }
        break;
    }
    std::sort(all.begin(), all.end());
    return all;
}

}  // namespace

std::vector<std::string> Compiler::include_flags() const {
    std::vector<std::string> flags;
    if (!tree_.overlay.empty()) {
        flags.push_back("-I" + (tree_.overlay / "src").string());
    }
    flags.insert(flags.end(), {"-Isrc", "-I" + tree_.generated.string(), "-I."});
    return flags;
}

std::filesystem::path Compiler::in_tree(const std::filesystem::path& source) const {
    const auto replaced = tree_.overlay / source;
    return !tree_.overlay.empty() && std::filesystem::exists(replaced) ? replaced : source;
}

struct Compiler::Run {
    std::filesystem::path source;
    std::string stem;
    pid_t process;
};

Compiler::Run Compiler::start(const std::filesystem::path& source) {
    const std::string stem = (tree_.scratch / std::to_string(done_.size())).string();
    done_[source] = stem + ".bc";
    std::vector<std::string> words{clang};
    words.insert(words.end(), bitcode_flags.begin(), bitcode_flags.end());
    const auto includes = include_flags();
    words.insert(words.end(), includes.begin(), includes.end());
    words.insert(words.end(), {"-MD", "-MF", stem + ".d", "-o", stem + ".bc", in_tree(source).string()});
    return {source, stem, start_clang(words, stem + ".txt")};
}

void Compiler::collect(const Run& run) {
    wait_for_clang(run.process, run.source.string(), run.stem + ".txt");
    std::istringstream names{read_file(run.stem + ".d")};
    std::vector<std::filesystem::path>& needed = needs_[run.source];
    for (std::string name; names >> name;) {
        for (const auto& other : sources_of_header(name)) {
            const bool is_new = other != run.source && std::find(needed.begin(), needed.end(), other) == needed.end();
            if (is_new) {
                needed.push_back(other);
            }
        }
    }
}

void Compiler::compile(const std::vector<std::filesystem::path>& proofs) {
    std::deque<std::filesystem::path> waiting{proofs.begin(), proofs.end()};
    std::deque<Run> running;
    while (!waiting.empty() || !running.empty()) {
        if (!waiting.empty() && running.size() < tree_.jobs) {
            if (done_.find(waiting.front()) == done_.end()) {
                running.push_back(start(waiting.front()));
            }
            waiting.pop_front();
            continue;
        }
        collect(running.front());
        const auto& needed = needs_.at(running.front().source);
        waiting.insert(waiting.end(), needed.begin(), needed.end());
        running.pop_front();
    }
}

std::vector<std::filesystem::path> Compiler::sources(const std::filesystem::path& proof) const {
    std::vector<std::filesystem::path> all{proof};
    for (std::size_t i = 0; i < all.size(); ++i) {
        for (const auto& other : needs_.at(all[i])) {
            if (std::find(all.begin(), all.end(), other) == all.end()) {
                all.push_back(other);
            }
        }
    }
    return all;
}

std::vector<std::filesystem::path> Compiler::bitcode(const std::filesystem::path& proof) const {
    std::vector<std::filesystem::path> all = sources(proof);
    for (auto& one : all) {
        one = done_.at(one);
    }
    return all;
}

std::filesystem::path Compiler::native(const std::filesystem::path& proof, const std::string& theorem) {
    const std::string stem = (tree_.scratch / ("native_" + theorem)).string();
    write_file(stem + ".cpp", fmt::format("namespace canproof::proofs {{\nvoid {0}();\n}}\n"
                                          "int main() {{\n    canproof::proofs::{0}();\n}}\n",
                                          theorem));
    std::vector<std::string> words{clang};
    words.insert(words.end(), native_flags.begin(), native_flags.end());
    const auto includes = include_flags();
    words.insert(words.end(), includes.begin(), includes.end());
    words.insert(words.end(), {"-o", stem, stem + ".cpp", "properties/proofs/support/replay.cpp"});
    for (const auto& source : sources(proof)) {
        words.push_back(in_tree(source).string());
    }
    wait_for_clang(start_clang(words, stem + ".txt"), proof.string(), stem + ".txt");
    return stem;
}

}  // namespace canproof::host::prove
