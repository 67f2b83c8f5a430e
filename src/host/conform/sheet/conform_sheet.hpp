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
    std::string name;      ///< name of the file, or of the catalogue device
    std::string text;      ///< the contents of the file
    std::string checksum;  ///< SHA-256 of the text
    Part part;             ///< the result of read_eds()
    IniFile ini;           ///< the same content by sections and keys; empty for an XDD
    std::string notes;     ///< the assumptions of read_eds(), one per line
    std::uint8_t node_id{1};

    /// Returns an entry; its pointers are nullptr when the data sheet does not contain it.
    SheetEntry find(std::uint16_t index, std::uint8_t subindex) const;
    const Object* object(std::uint16_t index) const;
    /// Returns the numbers of the PDOs of a direction, from the communication parameter objects 1400h… (receive) or
    /// 1800h… (transmit), ascending.
    std::vector<unsigned> pdos(bool transmit) const;
    /// Returns the text of a key such as `DeviceInfo`, `LSS_Supported`; nothing when it is absent.
    std::optional<std::string> key(const std::string& section, const std::string& key) const;
};

/// Reads the text of an EDS, DCF or XDD. Throws InputError with all faults when no data sheet results.
ConformSheet read_sheet(const std::string& text, const std::string& name, std::uint8_t node_id);
/// Returns the data sheet of a device of a requirements register, by way of its EDS; the node-ID is that of the
/// register.
ConformSheet sheet_of(const Register& content, const Part& part);
/// The same for a single part without a register.
ConformSheet sheet_of(const Part& part);

/// Returns the bytes of a value of the entry: the size of its type, or the length of its default for a string; 0 when
/// unknown.
std::size_t entry_size(const Entry& entry);
bool is_readable(const Entry& entry);
bool is_writable(const Entry& entry);
/// Returns the largest number that may be written; nothing for other types than integers, or when another object is the
/// limit.
std::optional<std::int64_t> highest_of(const Entry& entry);
std::optional<std::int64_t> lowest_of(const Entry& entry);
/// Returns `1017h sub 00h (Producer heartbeat time)`.
std::string entry_words(const SheetEntry& one);

}  // namespace canproof::host::conform
