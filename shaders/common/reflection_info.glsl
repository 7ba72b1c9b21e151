// One half float says what is known of a mirrored pixel, so that a reflection takes no more memory than it must:
// positive, the distance from the mirror to what is hit [m]; zero, nothing is known; negative, it is the sky.

const float infoUnknown = 0.0;
const float infoSky = -1.0;

// Within what a half holds as a normal number: a contact is a hit too.
float infoOfHit(float distance) {
    return clamp(distance, 6.2e-5, 65000.0);
}

bool infoIsHit(float info) {
    return info > 0.0;
}

bool infoIsSky(float info) {
    return info < 0.0;
}
