// How drops fly that leave a crest with its own speed, in closed form: their drag is linear, of what lets them fall as fast as
// drops of their size do.
#ifndef SPRAY_FLIGHT_GLSL
#define SPRAY_FLIGHT_GLSL

#include "hash.glsl"

struct Flight {
    vec3 moved;      // from where it left the crest [m]
    vec3 velocity;
    float radius;    // of the cloud [m]
    float stretch;   // how much longer it is along its flight
    float ragged;    // 1: thrown drops, 0: mist
    float shown;     // by age
};

// At an age [s], where the air moves by `blows` and the crest by `runs` [m/s]. Drops are seen `shownFor` seconds.
Flight flightOf(inout uint draws, float age, vec2 blows, float runs, float shownFor) {
    float size = nextShare(draws);
    bool thrown = size > 0.8;
    // Falling speeds of drops of 50 to 250 um, and of 1 mm (Gunn and Kinzer 1949) [m/s].
    float falls = thrown ? mix(2.5, 5.0, nextShare(draws)) : mix(0.3, 1.4, size * size);
    float lag = falls / 9.81;   // time in which they come to the air's speed
    float caught = lag * (1.0 - exp(-age / lag));
    vec2 downwind = normalize(blows);
    vec2 crest = runs * downwind;
    // Gusts, and eddies that grow as they carry on.
    float gust = 0.75 + 0.5 * nextShare(draws);
    vec3 eddy = vec3(nextShare(draws), nextShare(draws), nextShare(draws)) - 0.5;
    float turbulence = 0.16 * length(blows);
    vec2 air = gust * blows + turbulence * eddy.xz;
    float lifts = (0.45 + 1.1 * eddy.y) * turbulence;   // up the face, and by what the crest sheds
    float leaps = (thrown ? mix(0.12, 0.4, nextShare(draws)) : 0.12) * runs;
    Flight f;
    vec2 over = air * (age - caught) + crest * caught;
    float up = leaps * caught + (lifts - falls) * (age - caught);
    f.moved = vec3(over.x, up, over.y);
    float left = exp(-age / lag);
    vec2 level = air + (crest - air) * left;
    f.velocity = vec3(level.x, lifts - falls + (leaps - lifts + falls) * left, level.y);
    f.radius = (thrown ? 0.2 + 0.3 * age : 0.2 + 0.5 * age) * mix(0.6, 1.5, nextShare(draws));
    f.stretch = thrown ? 2.0 : 3.0 + 3.0 * age;
    f.ragged = thrown ? 1.0 : 0.0;
    // What still breaks is foam, and all of one age.
    f.shown = smoothstep(0.1, 0.5, age) * (1.0 - smoothstep(0.3 * shownFor, shownFor, age));
    return f;
}

#endif
