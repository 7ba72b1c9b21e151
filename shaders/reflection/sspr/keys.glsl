// The keys that the scatter left in the buffer Keys.

// Of keyGrid(), loaded once: CPU devices load uniforms anew in each turn of a loop.
ivec2 lastCell;

void loadKeyGrid(const MirrorBlock mirror) {
    lastCell = keyGrid(mirror) - 1;
}

// Beyond the border its own keys again, which have had their turn.
uint keyAt(ivec2 cell) {
    cell = clamp(cell, ivec2(0), lastCell);
    return keys[cell.y * (lastCell.x + 1) + cell.x];
}
