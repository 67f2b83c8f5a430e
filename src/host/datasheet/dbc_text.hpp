// SPDX-License-Identifier: Apache-2.0
// Model and text of a DBC file, the database of CAN messages for tools such as SavvyCAN, cantools and canmatrix. All
// signals are little endian with factor 1 and offset 0.
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace canproof::host {

/// Values with their words.
using DbcWords = std::vector<std::pair<std::uint64_t, std::string>>;

struct DbcSignal {
    enum class Multiplex { none, switches, switched };
    enum class Number { natural, integer, single_real, double_real };

    std::string name;
    unsigned start{0};   ///< first bit, counted from 0
    unsigned length{0};  ///< bits, 1 to 64
    Number number{Number::natural};
    Multiplex multiplex{Multiplex::none};
    std::uint64_t switched_by{0};  ///< value of the multiplexor at which the signal exists
    double minimum{0.0};
    double maximum{0.0};  ///< 0 in both: no limits
    std::string unit;
    std::string comment;
    DbcWords words;
};

struct DbcMessage {
    std::uint32_t id{0};  ///< of 11 bits; of 29 bits with is_extended
    bool is_extended{false};
    std::string name;
    unsigned length{0};  ///< bytes
    std::string sender;
    std::string receiver;
    std::string comment;
    std::vector<DbcSignal> signals;
};

struct DbcFile {
    std::vector<std::string> nodes;
    std::string comment;
    std::vector<DbcMessage> messages;
};

/// Unique names of one scope: each is a valid identifier of at most 32 characters. Names differ in more than their
/// case, because SavvyCAN looks them up without regard to it.
class DbcNames {
  public:
    /// Returns the text as a unique name: other characters become underscores, and _2, _3 … make it unique.
    std::string take(const std::string& text);

  private:
    std::set<std::string> taken_;  ///< in lower case
};

/// Returns the file with LF line breaks and ASCII characters only.
std::string dbc_text(const DbcFile& file);

}  // namespace canproof::host
