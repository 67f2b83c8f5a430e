// SPDX-License-Identifier: Apache-2.0
// The memory of an image on models: image_memory() and failure_words() of target/image/image.hpp give it to the image.
#pragma once

#include "target/image/image.hpp"
#include "tests/support/stm32f405/clock_model.hpp"
#include "tests/support/stm32f405/ram_model.hpp"
#include "tests/support/stm32f405/sealed_flash.hpp"

namespace canproof::test {

struct ImageStore {
    SealedFlash flash{72, 200};
    RamModel ram{64};
    RamModel guard{8};
    PlainModel<stm32f405::FailureWords> failure;
};

/// Returns the memory of all images that are constructed while no OwnStore exists. It exists before the first image.
ImageStore& common_store();

/// Gives its own memory to the images that are constructed while it exists.
class OwnStore {
  public:
    OwnStore();
    ~OwnStore();
    OwnStore(const OwnStore&) = delete;
    OwnStore& operator=(const OwnStore&) = delete;
    OwnStore(OwnStore&&) = delete;
    OwnStore& operator=(OwnStore&&) = delete;

    ImageStore& operator*() { return store_; }
    ImageStore* operator->() { return &store_; }

  private:
    ImageStore store_;
};

}  // namespace canproof::test
