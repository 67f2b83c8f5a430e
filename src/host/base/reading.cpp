// SPDX-License-Identifier: Apache-2.0
#include "host/base/reading.hpp"

#include <fmt/format.h>

#include "host/base/input_error.hpp"

namespace canproof::host {

namespace {

const std::string byte_order_mark = "\xEF\xBB\xBF";

}  // namespace

void check_read(const std::istream& in, const std::string& name) {
    if (in.bad()) {
        throw InputError{fmt::format(
            "{} cannot be read to its end: the system reports a read error; check its disk or connection", name)};
    }
}

bool LineReader::next() {
    in_.getline(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
    check_read(in_, name_);
    const auto count = static_cast<std::size_t>(in_.gcount());
    if (in_.fail() && count == 0) {
        return false;
    }
    ++number_;
    if (in_.fail()) {
        throw InputError{fmt::format("{}: a line has more than {} bytes; shorten the line, or name another file",
                                     where(), longest_line)};
    }
    // `count` includes the line break, except for a last line without one.
    line_.assign(buffer_.data(), in_.eof() ? count : count - 1);
    if (number_ == 1 && line_.compare(0, byte_order_mark.size(), byte_order_mark) == 0) {
        line_.erase(0, byte_order_mark.size());
    }
    if (!line_.empty() && line_.back() == '\r') {
        line_.pop_back();
    }
    return true;
}

std::string LineReader::where() const {
    return fmt::format("{}:{}", name_, number_);
}

}  // namespace canproof::host
