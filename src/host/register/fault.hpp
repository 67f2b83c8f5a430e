// SPDX-License-Identifier: Apache-2.0
// A fault in spec/: what is wrong, its place, and its fix.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace canproof::host {

/// A place in a file; lines count from 1. The path of a file of the register begins with spec/, or with canproof/spec/
/// for rules of an installed canproof. For any other file, it is the path that the user named.
struct Place {
    std::string file;
    unsigned line{0};
};

struct Fault {
    Fault(Place at, std::string wrong, std::string remedy)
        : place{std::move(at)}, what{std::move(wrong)}, fix{std::move(remedy)} {}

    Place place;
    std::string what;
    std::string fix;

    /// Returns the fault as one line: `file:line: what; fix`.
    std::string text() const;
};

/// A list of faults. It keeps the first 10,000 and only counts the others, so that a file with millions of faults needs
/// bounded memory.
class Faults {
  public:
    static constexpr std::size_t most = 10000;

    void push_back(Fault fault) {
        if (kept_.size() < most) {
            kept_.push_back(std::move(fault));
        } else {
            ++left_out_;
        }
    }
    void emplace_back(Place at, std::string what, std::string fix) {
        push_back(Fault{std::move(at), std::move(what), std::move(fix)});
    }

    bool empty() const { return kept_.empty(); }
    std::size_t size() const { return kept_.size(); }
    std::size_t left_out() const { return left_out_; }
    const Fault& front() const { return kept_.front(); }
    const Fault& operator[](std::size_t at) const { return kept_[at]; }
    std::vector<Fault>::const_iterator begin() const { return kept_.begin(); }
    std::vector<Fault>::const_iterator end() const { return kept_.end(); }
    std::vector<Fault>::iterator begin() { return kept_.begin(); }
    std::vector<Fault>::iterator end() { return kept_.end(); }
    void erase(std::vector<Fault>::const_iterator first, std::vector<Fault>::const_iterator last) {
        kept_.erase(first, last);
    }

  private:
    std::vector<Fault> kept_;
    std::size_t left_out_{0};
};

}  // namespace canproof::host
