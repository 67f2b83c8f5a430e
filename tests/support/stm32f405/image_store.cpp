// SPDX-License-Identifier: Apache-2.0
#include "tests/support/stm32f405/image_store.hpp"

namespace canproof::test {

namespace {

ImageStore* own_store = nullptr;

ImageStore& present_store() {
    return own_store == nullptr ? common_store() : *own_store;
}

}  // namespace

ImageStore& common_store() {
    static ImageStore store;
    return store;
}

OwnStore::OwnStore() {
    own_store = &store_;
}

OwnStore::~OwnStore() {
    own_store = nullptr;
}

}  // namespace canproof::test

namespace canproof::target {

stm32f405::ImageMemory image_memory() {
    test::ImageStore& store = test::present_store();
    return {store.flash.vectors(), store.flash.image(), {store.ram.words(), 0, 0}, store.guard.words()};
}

stm32f405::FailureWords& failure_words() {
    return test::present_store().failure.registers();
}

}  // namespace canproof::target
