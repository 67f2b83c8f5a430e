// SPDX-License-Identifier: Apache-2.0
// The electronic data sheet of the slave under test.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "host/datasheet/ini.hpp"
#include "host/register/register.hpp"

namespace canproof::host::conform {

/// An entry of the data sheet together with its object.
struct SheetEntry {
    const Object* object{nullptr};
    const Entry* entry{nullptr};
};

struct ConformSheet {
    std::string name;      ///< name of the file or of the device in the catalogue
    std::string text;      ///< the contents of the file
    std::string checksum;  ///< SHA-256 of the text
    Part part;             ///< result of read_eds()
    IniFile ini;           ///< contents of the file as sections and keys; empty for an XDD
    std::string notes;     ///< notes of read_eds() about values that it assumed, one on each line
    std::uint8_t node_id{1};

    /// Returns an entry with its object; both pointers are nullptr when the data sheet does not contain the entry.
    SheetEntry find(std::uint16_t index, std::uint8_t subindex) const;
    const Object* object(std::uint16_t index) const;
    /// Returns the numbers of the transmit or receive PDOs in ascending order. The communication parameter objects in
    /// the data sheet determine them: 1400h… for receive PDOs, 1800h… for transmit PDOs.
    std::vector<unsigned> pdos(bool transmit) const;
    /// Returns the text of a key in a section, such as `LSS_Supported` in `DeviceInfo`; nothing when it is absent.
    std::optional<std::string> key(const std::string& section, const std::string& key) const;
};

/// Reads the text of an EDS, DCF or XDD. Throws InputError with all faults when the text gives no data sheet.
ConformSheet read_sheet(const std::string& text, const std::string& name, std::uint8_t node_id);
/// Returns the data sheet of a device in a requirements register: writes the device as an EDS and reads this EDS. Uses
/// the node-ID in the register.
ConformSheet sheet_of(const Register& content, const Part& part);
/// Returns the data sheet of a device description (`Part`) that belongs to no requirements register.
ConformSheet sheet_of(const Part& part);

/// Returns the size in bytes of the entry's type. For a type of variable size, returns the length of the entry or of
/// its default, whichever is greater; 0 when both are unknown.
std::size_t entry_size(const Entry& entry);
bool is_readable(const Entry& entry);
bool is_writable(const Entry& entry);
/// Returns the largest number that may be written: the upper limit if it is a number, otherwise the largest number of
/// the integer type. Returns nothing for another type without an upper limit.
std::optional<std::int64_t> highest_of(const Entry& entry);
std::optional<std::int64_t> lowest_of(const Entry& entry);
/// Returns the entry as text: `1017h sub 00h (Producer heartbeat time)`.
std::string entry_words(const SheetEntry& one);

}  // namespace canproof::host::conform
