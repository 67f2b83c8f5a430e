// SPDX-License-Identifier: Apache-2.0
// A check in all tests of a device: no setting changes in a call of the device that counts no change of a setting. The
// self-test of the settings (src/target/stm32f405/selftest/settings_guard.hpp) would end such a call in the safe state.
#pragma once

#include <gtest/gtest.h>

#include <cstring>
#include <vector>

#include "firmware/canopen/node.hpp"

namespace canproof::test {

/// Calls `visit` with each piece of memory that holds settings: its address and its bytes. Leaves out empty pieces.
template <typename Visit>
void for_each_piece(const NodeSettings& settings, const Visit& visit) {
    const auto piece = [&visit](const void* begin, std::size_t size) {
        if (size != 0) {
            visit(static_cast<const std::uint8_t*>(begin), size);
        }
    };
    piece(settings.values.data(), settings.values.size());
    for (const ReceivePdoSettings& pdo : settings.received) {
        piece(&pdo, sizeof pdo);
    }
    for (const TransmitPdoSettings& pdo : settings.sent) {
        piece(&pdo, sizeof pdo);
    }
    for (const Slots<PdoLine>* lines : {&settings.received_lines, &settings.sent_lines}) {
        piece(lines->begin(), lines->size() * sizeof(PdoLine));
    }
}

/// Returns the settings as separate pieces of memory; an empty one is left out.
inline std::vector<MutableBytes> pieces_of(const NodeSettings& settings) {
    std::vector<MutableBytes> pieces;
    for_each_piece(settings, [&pieces](const std::uint8_t* begin, std::size_t size) {
        pieces.emplace_back(const_cast<std::uint8_t*>(begin), size);
    });
    return pieces;
}

/// Keeps a checksum and no copy, because the tests also run in the small memory of the microcontroller.
class SettingsWatch {
  public:
    /// Compares the settings with those of the last call, unless this is the first one or the device has counted a
    /// change since then.
    void look(const NodeSettings& settings) {
        std::uint32_t sum = 0;
        for_each_piece(settings, [&sum](const std::uint8_t* begin, std::size_t size) {
            for (std::size_t at = 0; at < size; at += sizeof sum) {
                std::uint32_t word = 0;
                std::memcpy(&word, begin + at, sizeof word);  // each piece is a whole number of words
                sum = ((sum << 1U) | (sum >> 31U)) + word;
            }
        });
        EXPECT_TRUE(sum == sum_ || !looked_ || settings.changes != changes_)
            << "a setting changed without being counted";
        looked_ = true;
        sum_ = sum;
        changes_ = settings.changes;
    }

  private:
    std::uint32_t sum_{0};
    std::uint32_t changes_{0};
    bool looked_{false};
};

}  // namespace canproof::test
