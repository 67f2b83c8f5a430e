// What is wrong in spec/, where, and how to mend it.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace canproof::host {

/// A place in a file of the register. Paths start at spec/; lines count from 1.
struct Place {
    std::string file;
    unsigned line{0};
};

struct Fault {
    Fault(Place at, std::string wrong, std::string remedy)
        : place{std::move(at)}, what{std::move(wrong)}, mend{std::move(remedy)} {}

    Place place;
    std::string what;
    std::string mend;

    /// `file:line: what; mend`
    std::string text() const;
};

using Faults = std::vector<Fault>;

}  // namespace canproof::host
