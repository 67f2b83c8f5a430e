// SPDX-License-Identifier: Apache-2.0
#include "host/assess/mutation/test_server.hpp"

#include <fmt/format.h>
#include <sys/mman.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "host/assess/trace/evidence.hpp"
#include "host/base/input_error.hpp"
#include "host/base/write_all.hpp"

namespace canproof::host {

std::vector<std::string> tab_separated(const std::string& line) {
    std::vector<std::string> parts(1);
    for (const char c : line) {
        if (c == '\t') {
            parts.emplace_back();
        } else {
            parts.back() += c;
        }
    }
    return parts;
}

std::vector<AlteredCell> read_cells(const std::filesystem::path& program) {
    Pipe pipe = make_pipe();
    const pid_t process = start_process({program.string(), "--cells"}, {}, {-1, pipe.writes.number()});
    pipe.writes = {};
    const PipeStream from = open_stream(std::move(pipe.reads), "r");
    std::vector<AlteredCell> cells;
    for (std::string line; read_line(from.get(), line);) {
        const auto parts = tab_separated(line);
        if (parts.size() == 4) {
            cells.push_back({cells.size(), parts[1], parts[2], parts[3]});
        }
    }
    if (wait_for_process(process) != 0 || cells.empty()) {
        throw InputError{
            fmt::format("{} lists no alterations; build this program with the preset `mutation`", program.string())};
    }
    return cells;
}

TestServer::TestServer(const std::filesystem::path& program) {
    Pipe in = make_pipe();
    Pipe out = make_pipe();
    process_ = start_process({program.string(), "--serve"}, {}, {in.reads.number(), out.writes.number()});
    to_ = open_stream(std::move(in.writes), "w");
    from_ = open_stream(std::move(out.reads), "r");
}

TestServer::~TestServer() {
    to_.reset();  // the process ends at the end of its input
    from_.reset();
    reap_process(process_);
}

namespace {

/// Limit in milliseconds for the work before the first test in a forked copy of a program.
constexpr unsigned most_for_fork = 500;
/// Limit in milliseconds for the start of a program.
constexpr unsigned most_for_start = 2000;

/// Returns the limit in milliseconds for the tests alone. An alteration makes some tests slower, and the two threads of
/// a core slow each other down.
unsigned limit_of_tests(const TestSelection& tests) {
    constexpr double slower = 5.0;
    constexpr double milliseconds = 1000.0;
    return static_cast<unsigned>(slower * milliseconds * tests.unaltered);
}

}  // namespace

unsigned TestSelection::limit() const {
    return most_for_fork + limit_of_tests(*this);
}

unsigned TestSelection::limit_with_start() const {
    return most_for_start + limit_of_tests(*this);
}

std::string TestServer::run(std::size_t number, const TestSelection& tests) {
    std::fprintf(to_.get(), "%zu\t%u\t%s\n", number, tests.limit(), tests.filter.c_str());
    std::fflush(to_.get());
    std::string line;
    while (read_line(from_.get(), line)) {
        const auto parts = tab_separated(line);
        if (parts.size() >= 2 && parts[0] == fmt::format("{}", number)) {
            return parts[1] == "survived" ? "" : parts.size() > 2 ? parts[2] : "died";
        }
    }
    throw InputError{fmt::format(
        "the test program ended at alteration {}; run this program with CANPROOF_ALTER={} to see why", number, number)};
}

namespace {

/// Returns a file in memory that contains the filter as a flag of GoogleTest. A filter can be longer than the 128 KiB
/// that Linux permits for one argument of a process. The started program inherits the descriptor.
Descriptor flag_file(const TestSelection& tests) {
    Descriptor file{memfd_create("gtest_flags", 0)};
    const std::string flag = "--gtest_filter=" + tests.filter + "\n";
    if (!file.is_open() || !write_all(file.number(), flag)) {
        throw InputError{fmt::format("cannot keep a list of tests in memory: {}", std::strerror(errno))};
    }
    return file;
}

}  // namespace

bool fails_when_started_altered(const std::filesystem::path& program, std::size_t number, const TestSelection& tests) {
    const Descriptor flags = flag_file(tests);
    const pid_t process = start_process(
        {program.string(), "--gtest_fail_fast", fmt::format("--gtest_flagfile=/dev/fd/{}", flags.number())},
        {fmt::format("CANPROOF_ALTER={}", number),
         fmt::format("CANPROOF_ALTER_MILLISECONDS={}", tests.limit_with_start())},
        {});
    return wait_for_process(process) != 0;
}

void pass_unaltered(const std::filesystem::path& program, const std::filesystem::path& verdicts,
                    const std::vector<std::string>& more_environment) {
    std::filesystem::remove(verdicts);
    const int status = wait_for_process(
        start_process({program.string(), "--gtest_output=xml:" + verdicts.string()}, more_environment, {}));
    if (status == 0) {
        return;
    }
    std::string failed;
    if (std::filesystem::exists(verdicts)) {
        for (const auto& test : read_verdict_file(verdicts).runs) {
            failed += test.passed ? "" : (failed.empty() ? "" : ", ") + test.name;
        }
    }
    throw InputError{fmt::format("{} fails without any alteration (exit status {}); fix it first: {}", program.string(),
                                 status, failed.empty() ? "no test reports a failure" : failed)};
}

}  // namespace canproof::host
