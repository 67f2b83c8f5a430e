// SPDX-License-Identifier: Apache-2.0
// A firmware image with the bridge of src/target/bridge. Here it runs as a thread of this program, behind the same two
// pipes as an image in QEMU.
#pragma once

#include <unistd.h>

#include <functional>
#include <memory>
#include <thread>

#include "host/base/child_process.hpp"
#include "host/sim/image/image_link.hpp"
#include "target/bridge/bridge.hpp"

namespace canproof::host::test {

class PipeChannel final : public target::Channel {
  public:
    PipeChannel(Descriptor in, Descriptor out) : in_{std::move(in)}, out_{std::move(out)} {}

  protected:
    bool read(std::uint8_t* to, std::size_t count) override {
        std::size_t done = 0;
        while (done < count) {
            const ssize_t got = ::read(in_.number(), to + done, count - done);
            if (got <= 0) {
                return false;
            }
            done += static_cast<std::size_t>(got);
        }
        return true;
    }
    bool write(ByteView bytes) override {
        return ::write(out_.number(), bytes.data(), bytes.size()) == static_cast<ssize_t>(bytes.size());
    }

  private:
    Descriptor in_;
    Descriptor out_;
};

class BridgedImage {
  public:
    /// `life` is the function that runs as the program of the firmware image.
    explicit BridgedImage(const std::function<void(target::Channel&)>& life) {
        Pipe to = make_pipe();
        Pipe from = make_pipe();
        link_ = std::make_unique<ImageLink>(std::move(to.writes), std::move(from.reads), "box.elf");
        thread_ = std::thread{[life, in = std::move(to.reads), out = std::move(from.writes)]() mutable {
            PipeChannel channel{std::move(in), std::move(out)};
            life(channel);
        }};
    }
    /// Closes the link, which ends the image, and waits for the end of its thread.
    ~BridgedImage() {
        link_.reset();
        thread_.join();
    }
    BridgedImage(const BridgedImage&) = delete;
    BridgedImage& operator=(const BridgedImage&) = delete;

    std::unique_ptr<ImageLink> take_link() { return std::move(link_); }

  private:
    std::unique_ptr<ImageLink> link_;
    std::thread thread_;
};

}  // namespace canproof::host::test
