// SPDX-License-Identifier: Apache-2.0
// Decodes a frame: its CANopen service, its node and its content (CiA 301, 7.2 and 7.3.3; CiA 305).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "firmware/canopen/frame.hpp"
#include "firmware/canopen/object_dictionary.hpp"
#include "host/register/register.hpp"

namespace canproof::host {

/// A node with its dictionary. The dictionary identifies the node's PDOs and gives the names of their values.
struct KnownNode {
    std::string name;
    std::uint8_t node_id{0};
    const Part* part{nullptr};
    const ObjectDictionary* objects{nullptr};
};

enum class FrameService { nmt, sync, time, emcy, pdo, sdo, error_control, lss, other };

struct FrameWords {
    FrameService service{FrameService::other};
    /// name of a known node, otherwise `node 5`; empty when the frame belongs to no node or to all nodes
    std::string node;
    std::string text;
};

class FrameDecoder {
  public:
    /// Keeps a reference to `content`, which contains the words for the services of all devices and must outlive the
    /// decoder.
    explicit FrameDecoder(const Register& content) : register_{content} {}

    /// Decodes any frame. For an unknown frame, returns the service `other` and the bytes. For an NMT, SDO or error
    /// control frame with a wrong length, returns the service and a description of the fault.
    FrameWords decode(const Frame& frame, const std::vector<KnownNode>& nodes) const;

  private:
    std::string word(const Part* part, const char* enumeration, std::uint64_t value) const;
    std::string nmt(ByteView data, const std::vector<KnownNode>& nodes) const;
    std::string emcy(ByteView data, const KnownNode* node) const;
    std::string error_control(const Frame& frame) const;
    std::string sdo_request(ByteView data, const Part* part) const;
    std::string sdo_answer(ByteView data, const Part* part) const;
    std::string abort_words(ByteView data, const Part* part) const;
    std::string lss(ByteView data, bool request) const;

    const Register& register_;
};

/// Returns the name of a service: `NMT`, `PDO` …
const char* service_word(FrameService service);

/// Returns the values in `data` as `name = value, …`. The node's mapping object `index` determines names and positions.
std::string mapped_words(const KnownNode& node, std::uint16_t index, ByteView data);

}  // namespace canproof::host
