// SPDX-License-Identifier: Apache-2.0
// Runs a fuzz target on files instead of under libFuzzer: NAME_fuzz [--xml FILE] [--frames FOLDER] FILE|FOLDER… With
// --xml it writes, for the audit, whether the run passed. With --frames it writes a candump log of the frames given to
// the device (candump_of_run.hpp).
// For a device it also writes how much the target has compared with the naive model.
// A violated requirement aborts the process, so a run that reaches its end has passed. A file that cannot be read ends
// the process with 2.
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>

#include "fuzz/support/beside_hook.hpp"
#include "fuzz/support/candump_of_run.hpp"
#include "fuzz/support/claims.hpp"
#include "fuzz/support/model_counts.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

void write_verdict(const std::filesystem::path& path, const std::string& target, std::size_t inputs) {
    std::filesystem::create_directories(path.parent_path());
    std::ofstream out{path};
    out << "<testsuites><testsuite><testcase classname=\"fuzz\" name=\"" << target << " (" << inputs
        << " inputs)\" status=\"run\"><properties>";
    for (const auto& id : canproof::fuzz::claims()) {
        out << "<property name=\"" << id << "\" value=\"fuzz\"/>";
    }
    out << "</properties></testcase></testsuite></testsuites>\n";
}

std::size_t run_file(const std::filesystem::path& path) {
    std::ifstream in{path, std::ios::binary};
    const std::vector<char> text{std::istreambuf_iterator<char>{in}, {}};
    if (!in.is_open() || in.bad()) {
        std::cerr << path.string() << " cannot be read\n";
        std::exit(2);
    }
    const std::vector<std::uint8_t> bytes{text.begin(), text.end()};
    LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
    return 1;
}

void write_counts() {
    using canproof::fuzz::model_counts;
    if (model_counts.events == 0) {
        return;
    }
    std::cout << model_counts.events << " event(s) compared with the naive model\n";
    for (const auto& [why, events] : model_counts.left_out) {
        std::cout << "  " << events << " left out: " << why << '\n';
    }
    for (const auto& [why, inputs] : model_counts.ended) {
        std::cout << "  " << inputs << " input(s) ended early: " << why << '\n';
    }
}

}  // namespace

int main(int argc, char** argv) {
    std::vector<std::string> arguments(argv + 1, argv + argc);
    canproof::fuzz::samples.take_all();
    std::filesystem::path xml;
    while (arguments.size() >= 2 && arguments[0].rfind("--", 0) == 0) {
        if (arguments[0] == "--xml") {
            xml = arguments[1];
        } else if (arguments[0] != "--frames" || !canproof::fuzz::begin_frame_log(arguments[1])) {
            std::cerr
                << arguments[0] << ' ' << arguments[1]
                << ": this is no option of this target, or the folder cannot be written; the options are --xml FILE, "
                   "and --frames FOLDER if the target has frames\n";
            return 2;
        }
        arguments.erase(arguments.begin(), arguments.begin() + 2);
    }
    std::size_t inputs = 0;
    for (const std::filesystem::path path : arguments) {
        if (!std::filesystem::is_directory(path)) {
            inputs += run_file(path);
            continue;
        }
        for (const auto& file : std::filesystem::recursive_directory_iterator(path)) {
            inputs += file.is_regular_file() ? run_file(file.path()) : 0;
        }
    }
    std::cout << inputs << " input(s) replayed\n";
    write_counts();
    if (inputs == 0) {
        std::cerr << "nothing to replay; name a file or a folder with files\n";
        return 2;
    }
    if (!xml.empty()) {
        write_verdict(xml, std::filesystem::path{argv[0]}.filename().string(), inputs);
    }
    return 0;
}
