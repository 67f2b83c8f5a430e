// Writes a run for other programs: JSON and JUnit.
#pragma once

#include <string>

#include "host/conform/run/conform_report.hpp"

namespace canproof::host::conform {

std::string write_json(const ConformReport& report);
std::string write_junit_xml(const ConformReport& report);
/// Smallest, mean and largest of measured times, in µs.
struct Spread {
    std::size_t count{0};
    std::uint64_t smallest{0};
    std::uint64_t mean{0};
    std::uint64_t largest{0};
};
Spread spread_of(const std::vector<std::uint64_t>& times);

}  // namespace canproof::host::conform
