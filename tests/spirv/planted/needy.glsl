// Takes a constant of whoever includes it.
float halved() {
    return 0.5 * doubled;
}
