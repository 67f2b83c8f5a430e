// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
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
