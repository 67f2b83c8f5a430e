// Each marked line must be flagged.
int again(int value) {
back:
    ++value;
    if (value < 9) {
        goto back;  // flagged
    }
    return value;
}
