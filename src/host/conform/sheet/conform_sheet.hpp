// What the electronic data sheet says of the slave under test.
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
    std::string name;      ///< of the file, or of the catalogue device
    std::string text;      ///< as the file has it
    std::string checksum;  ///< SHA-256 of the text
    Part part;             ///< as read_eds() reads it
    IniFile ini;           ///< the same, key by key; empty for an XDD
    std::string notes;     ///< what read_eds() assumed, a line each
    std::uint8_t node_id{1};

    /// An entry with nullptr inside when the data sheet has none.
    SheetEntry find(std::uint16_t index, std::uint8_t subindex) const;
    const Object* object(std::uint16_t index) const;
    /// Number of communication parameter objects 1400h… (receive) or 1800h… (transmit), ascending.
    std::vector<unsigned> pdos(bool transmit) const;
    /// Text of a key, as `DeviceInfo`, `LSS_Supported`; nothing where it is absent.
    std::optional<std::string> key(const std::string& section, const std::string& key) const;
};

/// Reads the text of an EDS, DCF or XDD. Throws InputError with every fault that leaves no data sheet.
ConformSheet read_sheet(const std::string& text, const std::string& name, std::uint8_t node_id);
/// A device of a register, by way of its own electronic data sheet; its node-ID is that of the register.
ConformSheet sheet_of(const Register& content, const Part& part);
/// The same for a part that stands alone.
ConformSheet sheet_of(const Part& part);

/// Bytes of a value of the entry: its type's, or its default's length where that is a string; 0 when not known.
std::size_t entry_size(const Entry& entry);
bool is_readable(const Entry& entry);
bool is_writable(const Entry& entry);
/// The largest number that may be written; nothing for what is no integer, or limited by another object.
std::optional<std::int64_t> highest_of(const Entry& entry);
std::optional<std::int64_t> lowest_of(const Entry& entry);
/// `1017h sub 00h (Producer heartbeat time)`
std::string entry_words(const SheetEntry& one);

}  // namespace canproof::host::conform
