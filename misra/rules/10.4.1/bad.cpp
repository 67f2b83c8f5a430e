// Each marked line must be flagged.
void idle() {
    asm("nop");  // flagged
}
