// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
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
