// SPDX-License-Identifier: Apache-2.0
// Model and text of a DBC file, the database of CAN messages for tools such as SavvyCAN, cantools and canmatrix. All
// signals are little endian with factor 1 and offset 0.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace canproof::host {

/// Values of a signal, each with the word that tools show for it.
using DbcWords = std::vector<std::pair<std::uint64_t, std::string>>;

struct DbcSignal {
    enum class Multiplex { none, switches, switched };
    enum class Number { natural, integer, single_real, double_real };

    std::string name;
    unsigned start{0};   ///< number of the first bit, from 0
    unsigned length{0};  ///< number of bits, 1 to 64
    Number number{Number::natural};
    Multiplex multiplex{Multiplex::none};
    std::uint64_t switched_by{0};  ///< value of the multiplexor with which the message contains this signal
    double minimum{0.0};
    double maximum{0.0};  ///< if minimum and maximum are both 0, there are no limits
    std::string unit;
    std::string comment;
    DbcWords words;
};

struct DbcMessage {
    std::uint32_t id{0};  ///< identifier of 11 bits, or of 29 bits if `is_extended`
    bool is_extended{false};
    std::string name;
    unsigned length{0};  ///< number of bytes
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

/// The unique names of one scope, such as the signals of one message. Each name is a valid identifier of at most
/// `longest_name` characters, or of fewer. Two names never differ only in upper and lower case, because SavvyCAN
/// ignores this difference.
class DbcNames {
  public:
    static constexpr std::size_t longest_name = 32;  ///< in characters; older tools refuse longer names

    explicit DbcNames(std::size_t most = longest_name) : most_{most} {}

    /// Returns the text as a unique name. Other characters than letters and digits become underscores; an ending such
    /// as _2 or _3 makes it unique.
    std::string take(const std::string& text);

  private:
    std::size_t most_;             ///< greatest length of a name, in characters
    std::set<std::string> taken_;  ///< in lower case
};

/// Returns the text of the DBC file, with LF line breaks and only ASCII characters.
std::string dbc_text(const DbcFile& file);

}  // namespace canproof::host
