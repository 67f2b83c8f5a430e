// Views of bytes that cannot overrun, and little-endian access (CiA 301 sends the least significant byte first).
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace canproof {

/// Read-only view of bytes. Reading past its end gives zero, never memory beside it.
class ByteView {
  public:
    constexpr ByteView() noexcept = default;
    constexpr ByteView(const std::uint8_t* const data, const std::size_t size) noexcept : data_{data}, size_{size} {}
    template <std::size_t N>
    constexpr explicit ByteView(const std::array<std::uint8_t, N>& bytes) noexcept : data_{bytes.data()}, size_{N} {}

    constexpr std::size_t size() const noexcept { return size_; }
    constexpr bool empty() const noexcept { return size_ == 0U; }
    constexpr const std::uint8_t* data() const noexcept { return data_; }
    constexpr std::uint8_t operator[](const std::size_t at) const noexcept {
        return (at < size_) ? data_[at] : std::uint8_t{0U};
    }
    /// At most `count` bytes from `from`; shorter when the view ends before.
    constexpr ByteView part(const std::size_t from, const std::size_t count) const noexcept {
        const std::size_t start = (from < size_) ? from : size_;
        const std::size_t rest = size_ - start;
        return ByteView{data_ + start, (count < rest) ? count : rest};
    }

  private:
    const std::uint8_t* data_{nullptr};
    std::size_t size_{0U};
};

/// Writable view of bytes. Writing past its end does nothing.
class MutableBytes {
  public:
    constexpr MutableBytes() noexcept = default;
    constexpr MutableBytes(std::uint8_t* const data, const std::size_t size) noexcept : data_{data}, size_{size} {}
    template <std::size_t N>
    constexpr explicit MutableBytes(std::array<std::uint8_t, N>& bytes) noexcept : data_{bytes.data()}, size_{N} {}

    constexpr std::size_t size() const noexcept { return size_; }
    constexpr ByteView view() const noexcept { return ByteView{data_, size_}; }
    constexpr std::uint8_t operator[](const std::size_t at) const noexcept {
        return (at < size_) ? data_[at] : std::uint8_t{0U};
    }
    constexpr void set(const std::size_t at, const std::uint8_t value) noexcept {
        if (at < size_) {
            data_[at] = value;
        }
    }
    /// Copies `source` to `at`; bytes that would not fit are dropped.
    constexpr void copy(const std::size_t at, const ByteView source) noexcept {
        const std::size_t room = (at < size_) ? (size_ - at) : std::size_t{0U};
        const std::size_t count = (source.size() < room) ? source.size() : room;
        for (std::size_t i = 0U; i < count; ++i) {
            data_[at + i] = source.data()[i];
        }
    }
    /// copy() of the first N bytes of `source`: the compiler knows how many, and makes a few moves of a loop.
    template <std::size_t N>
    void copy_first(const std::size_t at, const ByteView source) noexcept {
        if ((source.size() >= N) && (at <= size_) && (N <= (size_ - at))) {
            static_cast<void>(std::copy_n(source.data(), N, data_ + at));
        } else {
            copy(at, source.part(0U, N));
        }
    }
    /// The low `count` (0…8) bytes of `value` at `at`, least significant first; bytes that would not fit are dropped.
    constexpr void set_le(const std::size_t at, const std::size_t count, const std::uint64_t value) noexcept {
        const std::size_t room = (at < size_) ? (size_ - at) : std::size_t{0U};
        const std::size_t fitting = (count < room) ? count : room;
        std::uint64_t rest{value};
        for (std::size_t i = 0U; i < fitting; ++i) {
            data_[at + i] = static_cast<std::uint8_t>(rest & 0xFFU);
            rest >>= 8U;
        }
    }
    constexpr MutableBytes part(const std::size_t from, const std::size_t count) const noexcept {
        const std::size_t start = (from < size_) ? from : size_;
        const std::size_t rest = size_ - start;
        return MutableBytes{data_ + start, (count < rest) ? count : rest};
    }

  private:
    std::uint8_t* data_{nullptr};
    std::size_t size_{0U};
};

/// `count` (0…8) bytes from `at`, least significant first; bytes beyond the view read as zero.
constexpr std::uint64_t read_le(const ByteView bytes, const std::size_t at, const std::size_t count) noexcept {
    const ByteView part = bytes.part(at, count);
    std::uint64_t value{0U};
    for (std::size_t i = part.size(); i > 0U; --i) {
        value = (value << 8U) | part.data()[i - 1U];
    }
    return value;
}

constexpr std::uint16_t read_u16(const ByteView bytes, const std::size_t at) noexcept {
    return static_cast<std::uint16_t>(read_le(bytes, at, 2U));
}
constexpr std::uint32_t read_u32(const ByteView bytes, const std::size_t at) noexcept {
    return static_cast<std::uint32_t>(read_le(bytes, at, 4U));
}

/// Writes the low `count` (0…8) bytes of `value` at `at`, least significant first.
constexpr void write_le(MutableBytes bytes, const std::size_t at, const std::size_t count,
                        const std::uint64_t value) noexcept {
    bytes.set_le(at, count, value);
}

/// The bit pattern of a value of equal size (what C++20 calls std::bit_cast).
template <typename To, typename From>
To bit_cast(const From& from) noexcept {
    static_assert(sizeof(To) == sizeof(From), "a bit pattern keeps its size");
    To to{};
    static_cast<void>(std::memcpy(&to, &from, sizeof(To)));
    return to;
}

}  // namespace canproof
