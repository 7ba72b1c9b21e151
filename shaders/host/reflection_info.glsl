// One half float says what is known of a mirrored pixel, so that a reflection takes no more memory than it must:
// positive, the distance from the mirror to what is hit [m]; zero, nothing is known; negative, it is the sky.
#ifndef SEAGLASS_REFLECTION_INFO_GLSL
#define SEAGLASS_REFLECTION_INFO_GLSL

const float infoUnknown = 0.0;
const float infoSky = -1.0;

// Within what a half holds as a normal number: a contact is a hit too.
float infoOfHit(float distance) {
    return clamp(distance, 6.2e-5, 65000.0);
}

bool infoIsHit(float info) {
    return info > 0.0;
}

// Between two passes that find it: a hit on what a ray comes out of, which stands unless another way is found.
float infoOfDoubt(float hit) {
    return -2.0 - hit;
}

float hitOfDoubt(float info) {
    return infoOfHit(-2.0 - info);
}

bool infoIsDoubt(float info) {
    return info < -1.5;
}

// Between the same: sky beside what is mirrored, which stands unless a ray meets something.
const float infoDoubtedSky = -1.25;

bool infoIsOpen(float info) {
    return info == infoUnknown || info == infoDoubtedSky || infoIsDoubt(info);
}

// What stands of it.
float infoUndoubted(float info) {
    return infoIsDoubt(info) ? hitOfDoubt(info) : infoSky;
}

bool infoIsSky(float info) {
    return info < 0.0;
}

#endif
