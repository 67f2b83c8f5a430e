// SPDX-License-Identifier: Apache-2.0
// Reads streams with limits: a read error is not mistaken for the end, and the length of a line is bounded.
#pragma once

#include <array>
#include <cstddef>
#include <istream>
#include <string>

#include "host/base/input_error.hpp"
#include "host/base/read_file.hpp"

namespace canproof::host {

/// Throws InputError when reading ended because of an error and not at the end of the input.
void check_read(const std::istream& in, const std::string& name);

/// Reads lines one after another and provides file and line number for messages. Removes a byte order mark before the
/// first line and a carriage return at the end of each line.
class LineReader {
  public:
    static constexpr std::size_t longest_line = 4096;

    LineReader(std::istream& in, std::string name) : in_{in}, name_{std::move(name)} {}

    /// Reads the next line. Returns false at the end. Throws InputError for a read error and for a line longer than
    /// longest_line.
    bool next();
    const std::string& line() const { return line_; }
    std::size_t number() const { return number_; }
    /// Returns file and line: `bus.log:7`.
    std::string where() const;

  private:
    std::istream& in_;
    std::string name_;
    std::string line_;
    std::array<char, longest_line + 1> buffer_{};
    std::size_t number_{0};
};

}  // namespace canproof::host
