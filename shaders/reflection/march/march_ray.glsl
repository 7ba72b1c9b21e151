// The whole way of a ray.
#ifndef MARCH_RAY_GLSL
#define MARCH_RAY_GLSL

#ifdef CELLS
#include "march_cells.glsl"
#else
#include "march_strides.glsl"
#endif

// From `from` along the unit `direction`, which leads away from the plane, for so many metres. `noise` is 0..1.
March marched(const MirrorBlock mirror, vec3 from, vec3 direction, float metres, float noise) {
    vec4 perMetre = settings.pixelFromRelative * vec4(direction, 0.0);
    Track track = trackOf(mirror, settings.pixelFromRelative * vec4(from, 1.0), perMetre, metres);
    if (!(track.range.x < track.range.y)) return March(infoUnknown, vec3(0.0), refused);

    Progress at = atStart(track, noise);
    // The share at which something is met, or else where the ray first passes behind something; and where that shows.
    float share = 0.0;
    vec3 shown = vec3(0.0);
    int found = refused;
    bool thin = false;
    // Invocations stay together: all look for a crossing, then all settle theirs.
    int alarms = 0;
    do {
        Crossing crossing = nextCrossing(mirror, track, at);
        if (crossing.found) {
            int worth = settled(mirror, track, crossing);
            // What is thin has been met: out of it the ray comes.
            if (worth == underside && thin) found = met;
            if (worth > found) {
                thin = crossing.thin;
                found = worth;
                share = crossing.share;
                shown = crossing.shown;
            }
        }
    } while (++alarms <= falseAlarms && found < underside && at.taps > 0 && at.reached < 1.0);
    if (found != refused) {
        shown.z = fromInfinity(mirror, signedDepth(mirror, shown.z));
        return March(infoOfHit(trackMetres(track, share)), shown, found);
    }
    bool sky = at.reached >= 1.0 && !at.hidden && !track.leavesPicture && reachesSky(mirror, track, perMetre);
    return March(sky ? infoSky : infoUnknown, vec3(0.0), found);
}

#endif
