// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
struct Queue {
    bool pop();
    bool empty() const;
};
bool ready(const bool open, int& count) {
    return open && (++count > 3);  // flagged
}
bool taken(Queue& queue, const bool open) {
    return open && queue.pop();  // flagged
}
