// Each marked line must be flagged.
int read(int* place) {  // flagged
    return *place;
}
