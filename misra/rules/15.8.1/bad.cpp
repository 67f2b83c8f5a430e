// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
class Buffer {
  public:
    Buffer& operator=(const Buffer& other) {  // flagged
        delete place;
        place = new int(*other.place);
        return *this;
    }

  private:
    int* place;
};
