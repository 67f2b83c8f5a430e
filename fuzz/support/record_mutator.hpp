// A libFuzzer mutator for inputs that are records of one size: whole records come, go, change places and repeat, so
// that what follows keeps its meaning; now and then bytes change as libFuzzer itself does it.
#pragma once

#if defined(FUZZING_BUILD_MODE_UNSAFE_FOR_PRODUCTION)

#include <cstdint>
#include <cstring>
#include <random>

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);

namespace canproof::fuzz {

/// `size` bytes at `data` are whole records; the result has at most `max_size`.
inline std::size_t mutate_records(std::uint8_t* data, std::size_t size, std::size_t max_size, std::size_t record,
                                  unsigned seed) {
    std::minstd_rand random{seed};
    const std::size_t count = size / record;
    const auto pick = [&](std::size_t below) { return below == 0 ? 0 : random() % below; };
    std::uint8_t* const at = data + pick(count) * record;
    const std::size_t behind = static_cast<std::size_t>(data + count * record - at);
    switch (count == 0 ? 0 : random() % 6) {
        case 1:  // a record goes
            std::memmove(at, at + record, behind - record);
            return (count - 1) * record;
        case 2:  // a record comes twice
            if ((count + 1) * record <= max_size) {
                std::memmove(at + record, at, behind);
                return (count + 1) * record;
            }
            return count * record;
        case 3: {  // two change places
            std::uint8_t* const other = data + pick(count) * record;
            for (std::size_t i = 0; i < record; ++i) {
                const std::uint8_t byte = at[i];
                at[i] = other[i];
                other[i] = byte;
            }
            return count * record;
        }
        case 4:
        case 5:  // one changes
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
