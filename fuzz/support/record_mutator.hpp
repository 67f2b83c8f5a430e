// SPDX-License-Identifier: Apache-2.0
// A libFuzzer mutator for inputs that are records of one size. It removes, repeats, swaps or changes whole records, so
// that the following records keep their meaning. At times it changes bytes as libFuzzer does.
#pragma once

#if defined(FUZZING_BUILD_MODE_UNSAFE_FOR_PRODUCTION)

#include <cstdint>
#include <cstring>
#include <random>

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);

namespace canproof::fuzz {

/// Mutates `size` bytes at `data`, which are whole records; the result has at most `max_size` bytes.
inline std::size_t mutate_records(std::uint8_t* data, std::size_t size, std::size_t max_size, std::size_t record,
                                  unsigned seed) {
    std::minstd_rand random{seed};
    const std::size_t count = size / record;
    const auto pick = [&](std::size_t below) { return below == 0 ? 0 : random() % below; };
    std::uint8_t* const at = data + pick(count) * record;
    const std::size_t behind = static_cast<std::size_t>(data + count * record - at);
    switch (count == 0 ? 0 : random() % 6) {
        case 1:  // removes a record
            std::memmove(at, at + record, behind - record);
            return (count - 1) * record;
        case 2:  // repeats a record
            if ((count + 1) * record <= max_size) {
                std::memmove(at + record, at, behind);
                return (count + 1) * record;
            }
            return count * record;
        case 3: {  // swaps two records
            std::uint8_t* const other = data + pick(count) * record;
            for (std::size_t i = 0; i < record; ++i) {
                const std::uint8_t byte = at[i];
                at[i] = other[i];
                other[i] = byte;
            }
            return count * record;
        }
        case 4:
        case 5:  // changes a record
            LLVMFuzzerMutate(at, record, record);
            return count * record;
        default:
            return LLVMFuzzerMutate(data, size, max_size);
    }
}

}  // namespace canproof::fuzz

#define CANPROOF_FUZZ_RECORDS(record)                                                                          \
    extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size, \
                                                   unsigned seed) {                                            \
        return canproof::fuzz::mutate_records(data, size, max_size, record, seed);                             \
    }

#else

#define CANPROOF_FUZZ_RECORDS(record)

#endif
