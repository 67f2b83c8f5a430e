// A test program built with changeable cells, kept running: it alters a cell in a copy of itself and runs tests there.
// See tests/mutation/main.cpp.
#pragma once

#include <sys/types.h>

#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

namespace canproof::host {

std::vector<std::string> tab_separated(const std::string& line);

/// One line of `--cells`.
struct AlteredCell {
    std::size_t number{0};
    std::string item;
    std::string cell;
    std::string change;
};

/// Throws InputError when the program cannot be run or prints something else.
std::vector<AlteredCell> read_cells(const std::filesystem::path& program);

class TestServer {
  public:
    explicit TestServer(const std::filesystem::path& program);
    TestServer(const TestServer&) = delete;
    TestServer& operator=(const TestServer&) = delete;
    ~TestServer();

    /// Runs the tests of the filter with the cell altered. The test that failed, or how the process died; empty when
    /// all passed. It dies after so many seconds of processor time. Throws InputError when the server has gone.
    std::string run(std::size_t number, const std::string& filter, unsigned seconds = 10U);

  private:
    pid_t process_{-1};
    std::FILE* to_{nullptr};
    std::FILE* from_{nullptr};
};

/// Runs the program anew with the cell altered before anything is computed from it; whether a test failed.
bool fails_when_started_altered(const std::filesystem::path& program, std::size_t number, const std::string& filter);

/// Runs all tests unaltered and leaves their verdicts; whether all passed. `more_environment`: `NAME=value`.
bool run_unaltered(const std::filesystem::path& program, const std::filesystem::path& verdicts,
                   const std::vector<std::string>& more_environment = {});

}  // namespace canproof::host
