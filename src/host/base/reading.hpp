// Streams read so that a read error is never taken for the end, and no line beyond a bound.
#pragma once

#include <array>
#include <cstddef>
#include <istream>
#include <string>

#include "host/base/input_error.hpp"
#include "host/base/read_file.hpp"

namespace canproof::host {

/// Throws InputError when the stream ended by an error and not by the end of what it reads.
void check_read(const std::istream& in, const std::string& name);

/// Lines one after another, with file and line for messages. A byte order mark before the first and a carriage return
/// at an end are left out.
class LineReader {
  public:
    static constexpr std::size_t longest_line = 4096;

    LineReader(std::istream& in, std::string name) : in_{in}, name_{std::move(name)} {}

    /// False at the end. Throws InputError for a read error and for a line longer than longest_line.
    bool next();
    const std::string& line() const { return line_; }
    std::size_t number() const { return number_; }
    /// `bus.log:7`
    std::string where() const;

  private:
    std::istream& in_;
    std::string name_;
    std::string line_;
    std::array<char, longest_line + 1> buffer_{};
    std::size_t number_{0};
};

}  // namespace canproof::host
