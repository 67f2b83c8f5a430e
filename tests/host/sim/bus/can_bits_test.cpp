// SPDX-License-Identifier: Apache-2.0
// Frames as bits: lengths counted by hand, the CRC compared with its catalogue value and a division, and stuff bits.
#include "host/sim/bus/can_bits.hpp"

#include <gtest/gtest.h>

#include <random>
#include <string>

#include "firmware/canopen/frame.hpp"
#include "host/sim/bus/candump.hpp"

namespace canproof::host::test {

namespace {

std::vector<bool> bits_of(const std::string& text) {
    std::vector<bool> bits;
    for (const char c : text) {
        if (c != ' ') {
            bits.push_back(c == '1');
        }
    }
    return bits;
}

std::string text_of(const std::vector<bool>& bits) {
    std::string text;
    for (const bool bit : bits) {
        text += bit ? '1' : '0';
    }
    return text;
}

Frame frame(const std::string& text) {
    return parse_frame(text, "test");
}

/// Returns the remainder of the polynomial division of `bits` × x^15, computed as on paper.
unsigned divided(std::vector<bool> bits) {
    const std::vector<bool> divisor = bits_of("1100010110011001");  // x^15+x^14+x^10+x^8+x^7+x^4+x^3+1
    bits.insert(bits.end(), 15, false);
    for (std::size_t i = 0; i + 15 < bits.size(); ++i) {
        for (std::size_t k = 0; bits[i] && k < divisor.size(); ++k) {
            bits[i + k] = bits[i + k] != divisor[k];
            if (k == 0) {
                // the loop condition needs the leading bit until the subtraction ends
                bits[i] = true;
            }
        }
        bits[i] = false;
    }
    unsigned rest = 0;
    for (std::size_t i = bits.size() - 15; i < bits.size(); ++i) {
        rest = rest * 2U + (bits[i] ? 1U : 0U);
    }
    return rest;
}

}  // namespace

TEST(CanBits, Crc15OfTheDigits1To9IsThePublishedCheckValue) {
    // CRC-15/CAN of the ASCII text 123456789 is 059Eh in the catalogue of parametrised CRC algorithms.
    std::vector<bool> bits;
    for (const char c : std::string{"123456789"}) {
        for (int i = 7; i >= 0; --i) {
            bits.push_back(((static_cast<unsigned>(c) >> static_cast<unsigned>(i)) & 1U) != 0U);
        }
    }
    EXPECT_EQ(crc15(bits), 0x059E);
}

TEST(CanBits, CrcEqualsTheRemainderOfALongDivision) {
    std::mt19937 random{1};
    for (int i = 0; i < 200; ++i) {
        std::vector<bool> bits;
        for (unsigned n = 0; n < 20 + random() % 80; ++n) {
            bits.push_back((random() & 1U) != 0U);
        }
        ASSERT_EQ(crc15(bits), divided(bits)) << text_of(bits);
    }
}

TEST(CanBits, FieldsHaveTheOrderOfTheStandard) {
    // the fields: SOF, identifier 703h, RTR, IDE, r0, DLC 1, one byte 05h
    EXPECT_EQ(text_of(unstuffed_bits(frame("703#05"))), text_of(bits_of("0 11100000011 0 0 0 0001 00000101")));
    // a remote frame has a recessive RTR and no data
    EXPECT_EQ(text_of(unstuffed_bits(frame("703#R1"))), text_of(bits_of("0 11100000011 1 0 0 0001")));
    // 29 bits: 11 bits of base identifier, SRR, IDE, 18 further bits, RTR, r1, r0
    EXPECT_EQ(text_of(unstuffed_bits(frame("00040001#"))),
              text_of(bits_of("0 00000000001 1 1 000000000000000001 0 0 0 0000")));
}

TEST(CanBits, StuffBitFollowsFiveEqualBitsAndBeginsTheNextFive) {
    EXPECT_EQ(count_stuff_bits(bits_of("0000")), 0U);
    EXPECT_EQ(count_stuff_bits(bits_of("1111")), 0U);
    EXPECT_EQ(count_stuff_bits(bits_of("11111")), 1U);
    EXPECT_EQ(count_stuff_bits(bits_of("00000")), 1U);
    EXPECT_EQ(count_stuff_bits(bits_of("000001")), 1U);
    // the inserted 1 and the following four make five, so a second stuff bit follows
    EXPECT_EQ(count_stuff_bits(bits_of("00000 1111")), 2U);
    EXPECT_EQ(count_stuff_bits(bits_of("00000 1111 0000")), 3U);
    EXPECT_EQ(count_stuff_bits(bits_of("00000 00000")), 2U);
    EXPECT_EQ(count_stuff_bits(bits_of("0101010101")), 0U);
}

TEST(CanBits, FrameLengthIsFieldsPlusStuffBits) {
    // A frame has 1 + 11 + 3 + 4 + 8 n + 15 + 1 + 2 + 7 = 44 + 8 n bits without stuff bits. The bits of 555h and of the
    // bytes 55h alternate, so only the DLC (000100, 1000 …) and the CRC can need stuff bits. The test counts these in
    // the bits themselves.
    for (const auto& [text, plain] : {std::pair<std::string, unsigned>{"555#", 44},
                                      {"555#55", 52},
                                      {"555#5555555555555555", 108},
                                      {"15555555#55", 72},
                                      {"555#R8", 44}}) {
        std::vector<bool> bits = unstuffed_bits(frame(text));
        const unsigned crc = divided(bits);
        for (int i = 14; i >= 0; --i) {
            bits.push_back(((crc >> static_cast<unsigned>(i)) & 1U) != 0U);
        }
        EXPECT_EQ(frame_bits(frame(text)), plain + count_stuff_bits(bits)) << text;
    }
}

TEST(CanBits, NmtStartFrameHasTheBitsAndStuffBitsCountedByHand) {
    // 000#0100 is 0 00000000000 0 0 0 0010 00000001 00000000, then the CRC. The frame begins with 17 zeros: stuff bits
    // follow the 5th, 10th and 15th zero, because each inserted 1 ends the run. After the 1 of the DLC come eight
    // zeros: one stuff bit follows the fifth. After the 1 of the first byte come eight zeros: one stuff bit follows the
    // fifth.
    const auto header = unstuffed_bits(frame("000#0100"));
    EXPECT_EQ(header.size(), 35U);
    EXPECT_EQ(count_stuff_bits(header), 3U + 1U + 1U);
}

TEST(CanBits, ArbitrationGoesToTheDominantBit) {
    const auto wins = [](const char* a, const char* b) {
        return arbitration_rank(frame(a)) < arbitration_rank(frame(b));
    };
    EXPECT_TRUE(wins("080#", "081#"));
    EXPECT_TRUE(wins("703#05", "703#R1"));     // RTR is dominant in the data frame
    EXPECT_TRUE(wins("001#", "00040000#"));    // same base identifier: SRR and IDE of the second frame are recessive
    EXPECT_TRUE(wins("001#R", "00040000#R"));  // RTR and SRR are both recessive, so IDE decides
    EXPECT_TRUE(wins("0003FFFF#", "001#"));    // base identifier 0 is lower
    EXPECT_TRUE(wins("00040000#", "00040001#"));
}

TEST(CanBits, ArbitrationRankHasTheBitsOfTheArbitrationField) {
    const auto rank = [](const char* text) { return arbitration_rank(frame(text)); };
    EXPECT_EQ(rank("703#"), 0xE0600000U);       // 11100000011 0, then a dominant IDE
    EXPECT_EQ(rank("703#R"), 0xE0700000U);      // RTR is the twelfth bit
    EXPECT_EQ(rank("00040001#"), 0x00380002U);  // 00000000001 1 1 000000000000000001 0
    EXPECT_EQ(rank("1FFFFFFF#R"), 0xFFFFFFFFU);
}

}  // namespace canproof::host::test
