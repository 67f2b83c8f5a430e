// What fuzz/throughput compares with: everything libFuzzer does around a target, and nothing else.
#include <cstddef>
#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t*, std::size_t) {
    return 0;
}
