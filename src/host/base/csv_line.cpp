// SPDX-License-Identifier: Apache-2.0
#include "host/base/csv_line.hpp"

namespace canproof::host {

namespace {

std::string field(const std::string& text) {
    if (text.find_first_of(",\"\n\r") == std::string::npos) {
        return text;
    }
    std::string quoted{"\""};
    for (const char one : text) {
        quoted += one == '"' ? "\"\"" : std::string(1, one);
    }
    return quoted + "\"";
}

}  // namespace

std::string csv_line(const std::vector<std::string>& fields) {
    std::string text;
    for (std::size_t i = 0; i < fields.size(); ++i) {
        text += (i == 0 ? "" : ",") + field(fields[i]);
    }
    return text + "\r\n";
}

}  // namespace canproof::host
